#pragma once
/// \file
/// Which readings are held out, to be predicted by what is fitted without them. Decided by what was
/// commanded, before any residual is looked at; the order in which the runs stand does not matter.

#include <string>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The readings that are set aside before anything is fitted.
struct HeldOut {
  std::vector<std::vector<bool>> reading;  ///< [run][reading]
  std::vector<std::string> names;          ///< of runs, or of blocks as "run[from:to]"

  [[nodiscard]] bool empty() const { return names.empty(); }
};

HeldOut nothing_held(const Experiment& experiment);

/// What to set aside: of the kind of runs (control, loading only or not) that there are most of, the one that
/// goes farthest but one, where there are two and three runs in all; else two blocks of the path of every
/// run. Nothing where too little would be left.
HeldOut choose_heldout(const Experiment& experiment);

/// Two blocks of the path of every run. Where it goes and comes back, a block that is held out on one way is
/// seen on the other.
HeldOut choose_blocks(const Experiment& experiment);

/// The parts, of all below, whose names are all among these.
HeldOut named(const Experiment& experiment, const std::vector<std::string>& names);

/// The experiment without the measured values that are held out; what was commanded stays, for the history.
Experiment without(const Experiment& experiment, const HeldOut& heldout);

/// Parts of the runs, each to be held out once: from three runs on, those of which another is of the same
/// kind (control, whether it turns back); beyond four of them, four groups that go equally far.
std::vector<HeldOut> run_parts(const Experiment& experiment);

/// Parts of two blocks of every run, likewise; no block begins or ends a run.
std::vector<HeldOut> block_parts(const Experiment& experiment);

}  // namespace plumbline::diagnose
