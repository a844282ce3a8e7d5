/// \file
/// Checks that a user's expressions are defined along the runs of the nominal model.

#include <fmt/format.h>

#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/rig/branches.hpp"
#include "diagnose/rig/user_effects/stated_effect.hpp"

namespace plumbline::diagnose {
namespace {

/// Parameters at which an expression is evaluated.
struct TriedValues {
  std::vector<double> parameters;
  bool nothing;  ///< all growing parameters are zero
};

std::vector<TriedValues> trials(const StatedEffect& stated, const Study& study) {
  std::vector<TriedValues> all;
  for (const std::vector<double>& start : row_of(std::make_shared<StatedEffect>(stated))
                                              .initial_guesses({study.scales(), 0}, study.excitation())
                                              .points) {
    all.push_back({start, false});
    for (std::size_t p = 0; p < start.size(); ++p)
      if (stated.parameters[p].grows()) all.back().parameters[p] = 0;
    all.back().nothing = true;
    all.push_back({start, false});
  }
  return all;
}

std::string spelled(const StatedEffect& stated, const std::vector<double>& values) {
  std::string text;
  for (std::size_t p = 0; p < values.size(); ++p)
    text += fmt::format("{}{} = {:.4g}", p > 0 ? ", " : "", stated.parameters[p].name, values[p]);
  return text;
}

/// \throws Error unless the value is finite, and zero where all growing parameters are
void require(double value, const TriedValues& trial, const StatedEffect& stated, const std::string& key,
             const std::string& where) {
  if (std::isfinite(value) && (!trial.nothing || value == 0)) return;
  throw Error(stated.place + ": " + stated.id + "." + key,
              fmt::format("the value {:.4g} {}, with {}", value, where, spelled(stated, trial.parameters)),
              std::isfinite(value) ? "zero, where all parameters that may be zero are: the nominal model"
                                   : "a finite number at every reading of the nominal model");
}

void require_torque(const StatedEffect& stated, const Study& study, const TriedValues& trial) {
  const Experiment& experiment = study.experiment();
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    const Trace& trace = study.nominal().runs[r];
    for (Eigen::Index row = 0; row < trace.rows(); ++row) {
      const Reading& reading = run.readings[static_cast<std::size_t>(row)];
      for (std::size_t i = 0; i < run.rest.size(); ++i) {
        const double q = trace(row, column_q + static_cast<Eigen::Index>(i));
        if (!std::isfinite(q)) continue;
        const StatedTorque torque{i, stated.torque, trial.parameters};
        const StatedTorque::Place at{
            q,
            q - run.rest_at(reading)[i],
            reading.t,
            experiment.joint_stiffness[i],
            {trace(row, column_Fx), trace(row, column_Fy), reading.wrench_force().z()},
            reading.covariates};
        for (const double direction : {1.0, -1.0})
          require(torque.value(at, direction), trial, stated, "torque",
                  fmt::format("in joint {} at reading {} of {}", i + 1, row, run.id));
      }
    }
  }
}

/// Checks one run.
void require_reading(const StatedEffect& stated, const StatedReading& one, const Run& run, const Trace& trace,
                     const TriedValues& trial) {
  const StatedCorrection correction{one.channel, one.joint, one.formula, trial.parameters};
  for (const Channel& channel : run.measured()) {
    if (!correction.applies_to(channel)) continue;
    for (Eigen::Index row = 0; row < trace.rows(); ++row) {
      if (!std::isfinite(trace(row, channel.column))) continue;
      const Reading& reading = run.readings[static_cast<std::size_t>(row)];
      for (const double direction : {1.0, -1.0}) {
        const Moment moment{reading.t, run.number, direction, run.rest_at(reading)[channel.joint],
                            reading.covariates};
        require(correction.value(reading_values(trace.row(row).transpose(), moment, channel)), trial, stated,
                "reading." + one.key, fmt::format("at reading {} of {}", row, run.id));
      }
    }
  }
}

void require_readings(const StatedEffect& stated, const Study& study, const TriedValues& trial) {
  const std::vector<Run>& runs = study.experiment().runs;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const StatedReading& one : stated.readings)
      require_reading(stated, one, runs[r], study.nominal().runs[r], trial);
}

}  // namespace

void require_defined(const StatedEffect& stated, const Study& study) {
  const std::size_t joints = study.scales().link_length.size();
  for (const StatedReading& one : stated.readings)
    if (one.joint && *one.joint >= joints)
      throw Error(stated.place + ": " + stated.id + ".reading", one.key,
                  fmt::format("q, or q1 to q{}: the chain has {} joints", joints, joints));
  if (!study.nominal().reached) return;
  for (const TriedValues& trial : trials(stated, study)) {
    if (stated.torque) require_torque(stated, study, trial);
    require_readings(stated, study, trial);
  }
}

Study study_with(Experiment experiment, const std::vector<StatedEffect>& stated) {
  std::vector<Effect> rows;
  for (const StatedEffect& one : stated) rows.push_back(row_of(std::make_shared<StatedEffect>(one)));
  const Study read(std::move(experiment), std::make_shared<const std::vector<Effect>>(std::move(rows)));
  Study study = read.of(on_observed_branches(read));
  for (const StatedEffect& one : stated) require_defined(one, study);
  return study;
}

}  // namespace plumbline::diagnose
