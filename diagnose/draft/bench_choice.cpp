#include "diagnose/draft/bench_choice.hpp"

#include <algorithm>

namespace plumbline::diagnose {
namespace {

/// Whether the table of a run has what moves an arm: a command of its joints, or their angles where nothing
/// loads it.
bool is_of_an_arm(const std::vector<ColumnWords>& words) {
  const auto has = [&](const auto& is) { return std::any_of(words.begin(), words.end(), is); };
  const bool commanded = has([](const ColumnWords& one) { return one.kind == Kind::angle && one.commanded; });
  const bool angles = has([](const ColumnWords& one) { return one.kind == Kind::angle; });
  const bool loaded =
      has([](const ColumnWords& one) { return is_force(one.kind) || is_actuation(one.kind); });
  const bool in_space = has([](const ColumnWords& one) { return one.kind == Kind::x; }) &&
                        has([](const ColumnWords& one) { return one.kind == Kind::y; }) &&
                        has([](const ColumnWords& one) { return one.kind == Kind::z; });
  return angles && (in_space || !loaded) && (commanded || in_space || !loaded);
}

}  // namespace

BenchKind bench_of(const DraftModel& model, const std::vector<RunSource>& sources,
                   const std::vector<std::string>& joints) {
  if (!model.chain.has_links()) return BenchKind::joint;
  if (!model.arm) return BenchKind::plane;
  if (model.chain.link_length.empty()) return BenchKind::arm;
  const bool arm = std::any_of(sources.begin(), sources.end(),
                               [&](const RunSource& source) { return is_of_an_arm(source.words(joints)); });
  return arm ? BenchKind::arm : BenchKind::plane;
}

}  // namespace plumbline::diagnose
