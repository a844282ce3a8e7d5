#include "diagnose/rig/delayed.hpp"

namespace plumbline::diagnose {
namespace {

/// Replaces a value of every reading by the response to it.
/// \param start  what comes before the first reading, if anything
/// \param value  in a reading
template <class Value>
void respond(const Response& how, const std::optional<Reading>& start, std::vector<Reading>& readings,
             Value value) {
  const Eigen::Index before = start ? 1 : 0, count = static_cast<Eigen::Index>(readings.size());
  Eigen::ArrayXd t(before + count), commanded(before + count);
  if (Reading first = start.value_or(Reading{}); start) {
    t(0) = first.t;
    commanded(0) = value(first);
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    Reading& one = readings[static_cast<std::size_t>(i)];
    t(before + i) = one.t;
    commanded(before + i) = value(one);
  }
  const Eigen::ArrayXd led = responded(how, t, commanded);
  for (Eigen::Index i = 0; i < count; ++i) value(readings[static_cast<std::size_t>(i)]) = led(before + i);
}

}  // namespace

std::vector<Reading> led_by(const Drive& drive, const Run& run) {
  std::vector<Reading> all = run.readings;
  const std::optional<Reading> start = run.before_first();
  if (run.commands_joints())
    for (std::size_t j = 0; j < run.rest.size(); ++j) {
      respond(drive.response, start, all, [j](Reading& one) -> double& { return one.rest[j]; });
      for (Reading& one : all) one.rest[j] += drive.drift[j] * one.t;
    }
  if (run.holds_end_point() || !run.by_weights)
    for (const Channel& channel : run.imposed())
      respond(drive.response, start, all, [&](Reading& one) -> double& { return channel.in(one); });
  for (const auto& [number, told] : drive.covariates) {
    respond(told.response, start, all, [c = number](Reading& one) -> double& { return one.covariates[c]; });
    for (Reading& one : all) {
      double& value = one.covariates[number];
      value += told.gain * value + told.zero + told.drift * one.t;
    }
  }
  return all;
}

LedCommand::LedCommand(const Run& run, const Drive& drive)
    : behind_(drive.is_exact() ? std::vector<Reading>{} : led_by(drive, run)) {}

const Reading& LedCommand::at(const Stop& stop) {
  if (behind_.empty() || !stop.to) return stop.reading;
  if (!stop.from || stop.share == 1) return behind_[*stop.to];
  on_the_way_ = between(behind_[*stop.from], behind_[*stop.to], stop.share);
  return on_the_way_;
}

}  // namespace plumbline::diagnose
