#pragma once
/// \file
/// Before anything is fitted: a column that reads the same throughout, where the chain moves.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// A measured column that never leaves one value where the nominal model goes far: a sensor that is not
/// connected, or a column of noughts for what was not measured.
struct StuckChannel {
  std::vector<std::string> runs;  ///< in which it does not; empty where in all
  Channel channel;
  std::set<double> values;  ///< one for each run, SI
  std::size_t readings;     ///< that hold them
  double predicted_range;   ///< of the nominal model in one of the runs, the widest: highest minus lowest, SI
};

/// The first channel of which some run shows that it does not move: eight readings or more, all the same to
/// the last digit, where the nominal model goes through more than twenty times the noise and a fiftieth of
/// what its sensor goes through. No effect holds readings so still: noise shows in their last digits, and
/// where these are too coarse for it the chain moves by less than the twenty.
std::optional<StuckChannel> stuck_channel(const Study& study);

/// \throws Error in one line, where a channel is unmoved
void require_no_stuck_channel(const Study& study);

}  // namespace plumbline::diagnose
