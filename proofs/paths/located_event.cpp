#include "proofs/paths/located_event.hpp"

#include <plumbline/branch/sharpen.hpp>
#include <plumbline/loaded/nominal_model.hpp>

namespace plumbline::proofs {

namespace {

using LocatedModel = NominalModel<Located>;

}  // namespace

std::vector<BranchEvent<Located>> locate_events(const Chain<Located>& chain, const Loading<Located>& loading,
                                                const Branch<double>& branch) {
  const LocatedModel model(chain);
  Brancher<LocatedModel> brancher(model, loading, absolute_angles(chain.rest()));
  std::vector<BranchEvent<Located>> events;
  for (const BranchEvent<double>& event : branch.events) events.push_back(sharpen(brancher, event));
  return events;
}

BranchPoint<Located> locate_at(const Chain<Located>& chain, const Loading<Located>& loading,
                               const BranchPoint<double>& near, const Located& load) {
  const LocatedModel model(chain);
  Brancher<LocatedModel> brancher(model, loading, absolute_angles(chain.rest()));
  const BranchPoint<Located> guess = lift<Located>(near);
  return brancher.start(load, guess.theta, guess.force);
}

}  // namespace plumbline::proofs
