#pragma once
/// \file
/// Errors of the sensors that read a rig, by channel, and how sensors and drives respond in time.

#include <Eigen/Core>
#include <limits>
#include <map>
#include <utility>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The prediction of one run: a row a reading, a column a channel. Imposed channels repeat the command.
using Trace = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A channel is read as (1 + gain) v + neighbours (v_before + v_after) + zero + drift t. Neighbours are the
/// channels beside it that a sensor of its kind reads: those of the joints, or the other axis.
struct SensorError {
  double zero = 0, gain = 0, neighbours = 0;
  double drift = 0;  ///< of the zero, by second
  friend bool operator==(const SensorError&, const SensorError&) = default;
};

/// What sensors of one kind show of a value, or drives make of a command, in time: first it comes late, then
/// it is followed, then it creeps.
struct Response {
  double delay = 0;                                        ///< s
  double lag = 0;                                          ///< time constant, s
  double creep = 0, creep_time = 1;                        ///< share that is shown more in time; s
  double limit = std::numeric_limits<double>::infinity();  ///< no value is shown beyond it, to either side
  [[nodiscard]] bool is_prompt() const { return *this == Response{}; }
  friend bool operator==(const Response&, const Response&) = default;
};

/// The response to values that change linearly from time to time. Before the first they stood still, and have
/// been followed. NaN is no value, and stays.
/// \param t  s, not falling
Eigen::ArrayXd responded(const Response& how, const Eigen::ArrayXd& t, const Eigen::ArrayXd& values);

struct Sensors {
  std::map<std::pair<Channel::Name, std::size_t>, SensorError> errors;  ///< by name and number of the channel
  std::map<Channel::Name, Response> responses;

  [[nodiscard]] bool are_exact() const { return errors.empty() && responses.empty(); }
  [[nodiscard]] SensorError& error(Channel::Name name, std::size_t index = 0) {
    return errors[{name, index}];
  }
  [[nodiscard]] Response response(Channel::Name name) const {
    const auto found = responses.find(name);
    return found == responses.end() ? Response{} : found->second;
  }
  /// The measured channels of a run as these sensors show them.
  /// \param trace  what stands before the sensors
  [[nodiscard]] Trace shown(const Run& run, Trace trace) const;
  friend bool operator==(const Sensors&, const Sensors&) = default;
};

}  // namespace plumbline::diagnose
