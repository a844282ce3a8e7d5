#include "benchmarks/kernels.hpp"

#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <plumbline/straight/critical_force_batch.hpp>

namespace plumbline::bench {
namespace {

ChainBatch batch_of(const ChainList& chains) {
  return {chains.links, chains.length, chains.stiffness};
}

std::vector<double> lowest_one_by_one(const ChainList& chains) {
  const ChainBatch batch = batch_of(chains);
  std::vector<double> forces;
  for (std::size_t c = 0; c < batch.size(); ++c) forces.push_back(lowest_critical_force(batch.chain(c)));
  return forces;
}

std::vector<double> lowest_as_batch(const ChainList& chains) {
  return lowest_forces(batch_of(chains), 1);
}

std::vector<double> all_forces(const ChainList& chains) {
  const ChainBatch batch = batch_of(chains);
  std::vector<double> forces;
  for (std::size_t c = 0; c < batch.size(); ++c) {
    const std::vector<double> own = critical_forces(batch.chain(c), chains.links);
    forces.insert(forces.end(), own.begin(), own.end());
  }
  return forces;
}

std::vector<double> path(const ChainList& chains) {
  using Model = NominalModel<double>;
  const Chain<double> straight = batch_of(chains).chain(0);
  std::vector<double> rest(chains.links);
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = (i % 2 == 0 ? 1 : -1) / static_cast<double>(i + 2);
  const Chain<double> chain(straight.length(), straight.stiffness(), rest);
  const Model model(chain);
  const Point<double> start = end_point(chain, rest);
  const Vector<double> shape = absolute_angles(rest);
  const double reach = std::hypot(start.x, start.y);
  Brancher<Model> brancher(model, {Control::end_point, start, {-start.x / reach, -start.y / reach}}, shape);
  const auto branch =
      Tracer<Model>(brancher, {0, reach / 2, reach / 100, 2000}).run(brancher.start(0, shape));
  std::vector<double> forces;
  for (const auto& point : branch.points) forces.push_back(point.force.x);
  return forces;
}

}  // namespace

[[gnu::visibility("default")]] Kernels PLUMBLINE_KERNELS() {
  return {lowest_one_by_one, lowest_as_batch, all_forces, path};
}

}  // namespace plumbline::bench
