#include "diagnose/screening/arm_conventions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "diagnose/bench/registration.hpp"
#include "diagnose/rig/history.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

/// A slip that readings, or the model, may have.
struct Slip {
  std::string looks_like, remedy;
  std::function<void(Experiment&)> mend;
  std::ptrdiff_t rows = 0;  ///< by which what was measured stands too early in its table
};

std::function<void(Experiment&)> in_each_reading(std::function<void(Reading&)> change) {
  return [change = std::move(change)](Experiment& experiment) {
    for (Run& run : experiment.runs)
      for (Reading& reading : run.readings) change(reading);
  };
}

std::function<void(Experiment&)> in_each_command(std::function<void(std::vector<double>&)> change) {
  return [change = std::move(change)](Experiment& experiment) {
    for (Run& run : experiment.runs) run.each_rest(change);
  };
}

std::function<void(Experiment&)> in_each_place(std::function<void(double*)> change) {
  return [change = std::move(change)](Experiment& experiment) {
    for (std::size_t p = 0; p < experiment.arm_bench.points.size(); ++p) {
      const Channel last(Channel::Name::place, 3 * p + 2, experiment.arm->arm.size());
      for (Run& run : experiment.runs)
        for (Reading& reading : run.readings) change(&last.in(reading)-2);
    }
  };
}

std::function<void(Experiment&)> places_times(double factor) {
  return in_each_place([factor](double* at) {
    for (int axis = 0; axis < 3; ++axis) at[axis] *= factor;
  });
}

std::function<void(Experiment&)> loads_times(double factor) {
  return in_each_reading([factor](Reading& reading) {
    for (double& load : reading.wrench) load *= factor;
  });
}

void add_units(const Experiment& experiment, std::vector<Slip>& slips) {
  for (const auto& [unit, factor] : {std::pair("mm", 1e-3), {"cm", 1e-2}, {"in", 0.0254}}) {
    slips.push_back({fmt::format("places look like {}", unit), fmt::format("units.place = \"{}\"", unit),
                     places_times(factor)});
    slips.push_back({fmt::format("places look like m that were taken for {}", unit), "units.place = \"m\"",
                     places_times(1 / factor)});
  }
  const auto turning = [&experiment](double factor) {
    std::vector<double> factors(experiment.link_length.size(), factor);
    for (std::size_t j = 0; j < factors.size(); ++j)
      if (experiment.slides(j)) factors[j] = 1;
    return in_each_command([factors](std::vector<double>& command) {
      for (std::size_t j = 0; j < command.size(); ++j) command[j] *= factors[j];
    });
  };
  constexpr double degree = std::numbers::pi / 180;
  slips.push_back({"commands look like degrees", "units.angle = \"deg\"", turning(degree)});
  slips.push_back({"commands look like radians that were taken for degrees", "units.angle = \"rad\"",
                   turning(1 / degree)});
}

void add_loads(std::vector<Slip>& slips) {
  constexpr double kilogram = 9.80665;  // its weight, N
  slips.push_back(
      {"weights look like N that were taken for kg", "them over 9.80665", loads_times(1 / kilogram)});
  slips.push_back({"loads look like kgf", "units.force = \"kgf\"", loads_times(kilogram)});
  slips.push_back({"weights look like g", "units.mass = \"g\"", loads_times(1e-3)});
  slips.push_back({"loads look as if they pulled the other way", "their other sign", loads_times(-1)});
  slips.push_back({"gravity looks as if it pulled the other way",
                   "the other sign of arm.gravity, or the base the other way up", [](Experiment& experiment) {
                     NominalArm arm = *experiment.arm;
                     arm.arm.gravity *= -1;
                     experiment.arm = std::make_shared<const NominalArm>(std::move(arm));
                   }});
}

/// Slips of a frame that is known.
void add_turned_axes(std::vector<Slip>& slips) {
  for (int axis = 0; axis < 3; ++axis) {
    const char name = "xyz"[axis], next = "xyz"[(axis + 1) % 3];
    slips.push_back({fmt::format("{} and {} of the tracker look exchanged", name, next),
                     "their columns the other way round",
                     in_each_place([axis](double* at) { std::swap(at[axis], at[(axis + 1) % 3]); })});
    for (int turned = 0; turned < 2; ++turned)
      slips.push_back({fmt::format("the tracker's frame looks turned by a quarter about {}", name),
                       "places in the frame of the base", in_each_place([axis, turned](double* at) {
                         double &a = at[(axis + 1) % 3], &b = at[(axis + 2) % 3];
                         std::swap(a, b);
                         (turned ? a : b) *= -1;
                       })});
  }
}

/// A left hand is no matter of where the tracker stands; which axis is the one, is.
void add_reversed_axes(bool known, std::vector<Slip>& slips) {
  for (int axis = 0; axis < (known ? 3 : 1); ++axis) {
    const std::string which =
        known ? fmt::format("{} of the tracker", "xyz"[axis]) : "an axis of the tracker";
    slips.push_back({which + " looks reversed: its frame is left-handed",
                     known ? fmt::format("the other sign of the columns of {}", "xyz"[axis])
                           : std::string("the other sign of the columns of one axis"),
                     in_each_place([axis](double* at) { at[axis] = -at[axis]; })});
  }
}

void add_zeros(const NominalChain& chain, std::vector<Slip>& slips) {
  for (std::size_t j = 0; j < chain.arm->joint.size(); ++j) {
    if (chain.slides(j)) continue;
    for (const int degrees : {90, -90, 180})
      slips.push_back(
          {fmt::format("the zero of {} looks off by {} degrees", chain.arm->joint[j], std::abs(degrees)),
           fmt::format("its commands with {} degrees more, as the zeros of the model are", degrees),
           in_each_command([j, degrees](std::vector<double>& command) {
             command[j] += degrees * std::numbers::pi / 180;
           })});
  }
}

void add_order(const NominalArm& arm, std::vector<Slip>& slips) {
  for (std::size_t j = 0; j < arm.joint.size(); ++j) {
    slips.push_back({fmt::format("{} looks as if it turned the other way", arm.joint[j]),
                     "the other sign of its commands, or of its axis in the model",
                     in_each_command([j](std::vector<double>& command) { command[j] *= -1; })});
    for (std::size_t k = 0; k < j; ++k)
      slips.push_back(
          {fmt::format("{} and {} look exchanged", arm.joint[k], arm.joint[j]),
           "their columns the other way round",
           in_each_command([j, k](std::vector<double>& command) { std::swap(command[j], command[k]); })});
  }
  slips.push_back(
      {"the joints look numbered from the tip", "their columns in the order from the base",
       in_each_command([](std::vector<double>& command) { std::reverse(command.begin(), command.end()); })});
  for (const std::ptrdiff_t rows : {1, -1})
    slips.push_back({fmt::format("places look one row {} their commands", rows > 0 ? "after" : "before"),
                     "them in the rows of their commands", [](Experiment&) {}, rows});
}

/// All that is asked about.
std::vector<Slip> slips_of(const Experiment& experiment) {
  const bool known = experiment.arm_bench.frames == ArmBench::Frames::known;
  std::vector<Slip> all;
  add_units(experiment, all), add_loads(all);
  add_reversed_axes(known, all);
  if (known) add_turned_axes(all);
  add_order(*experiment.arm, all), add_zeros(experiment, all);
  return all;
}

Vector3<double> place_in(const Eigen::ArrayXd& row, std::size_t point, std::size_t joints) {
  return row.segment<3>(Channel(Channel::Name::place, 3 * point, joints).column);
}

/// An experiment that shows the pose of each point's link by three marks: its origin, and ends of two axes.
Experiment marked(Experiment experiment) {
  std::vector<MeasuredPoint> marks;
  for (const MeasuredPoint& point : experiment.arm_bench.points)
    for (const Vector3<double>& at : {Vector3<double>(0, 0, 0), {1, 0, 0}, {0, 1, 0}}) {
      marks.push_back({point.name, {point.at.link}});
      marks.back().at.frame.translation() = at;
    }
  experiment.arm_bench.points = std::move(marks);
  experiment.arm_bench.sensors.clear();
  return experiment;
}

Pose<double> link_of(const Eigen::ArrayXd& row, std::size_t point, std::size_t joints) {
  Pose<double> link = Pose<double>::Identity();
  link.translation() = place_in(row, 3 * point, joints);
  for (std::size_t axis = 0; axis < 2; ++axis)
    link.linear().col(static_cast<Eigen::Index>(axis)) =
        place_in(row, 3 * point + 1 + axis, joints) - link.translation();
  link.linear().col(2) = link.linear().col(0).cross(link.linear().col(1));
  return link;
}

/// The places that were seen, and the links of the nominal arm under its loads; none where it does not hold.
std::vector<Sight> sights_of(const Experiment& experiment) {
  const Experiment shows_links = marked(experiment);
  const Prediction predicted = simulate(shows_links, nominal_rig(shows_links), {});
  if (!predicted.reached) return {};
  const std::size_t joints = experiment.arm->arm.size();
  std::vector<Sight> all;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i)
      for (std::size_t p = 0; p < experiment.arm_bench.points.size(); ++p) {
        Vector3<double> place;
        for (std::size_t axis = 0; axis < 3; ++axis)
          place(static_cast<Eigen::Index>(axis)) =
              Channel(Channel::Name::place, 3 * p + axis, joints).of(experiment.runs[r].readings[i]);
        if (place.allFinite())
          all.push_back({p, link_of(predicted.runs[r].row(static_cast<Eigen::Index>(i)), p, joints), place});
      }
  return all;
}

/// Root mean square distance of the places from the nominal ones, over that from their mean; in the best
/// frames where these are unknown.
double misfit_of_places(const Experiment& experiment) {
  const std::vector<Sight> sights = sights_of(experiment);
  if (sights.empty()) return std::numeric_limits<double>::infinity();
  const ArmBench& bench = experiment.arm_bench;
  std::vector<Vector3<double>> points;
  for (const MeasuredPoint& point : bench.points) points.push_back(point.at.frame.translation());
  return bench.frames == ArmBench::Frames::known ? misfit_as_told(sights, points)
                                                 : misfit_in_any_frame(sights, std::move(points));
}

/// A share of the readings, for a slip is in all of them.
/// \param rows  by which what was measured is moved up
Experiment some_of(const Experiment& experiment, std::ptrdiff_t rows) {
  constexpr std::ptrdiff_t most = 60;
  std::ptrdiff_t readings = 0;
  for (const Run& run : experiment.runs) readings += std::ssize(run.readings);
  const std::ptrdiff_t stride = 1 + readings / most;
  Experiment some = experiment;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const std::vector<Reading>& all = experiment.runs[r].readings;
    some.runs[r].readings.clear();
    for (std::ptrdiff_t i = 0; i < std::ssize(all); i += stride) {
      if (i + rows < 0 || i + rows >= std::ssize(all)) continue;
      some.runs[r].readings.push_back(all[static_cast<std::size_t>(i)]);
      some.runs[r].readings.back().value = all[static_cast<std::size_t>(i + rows)].value;
    }
    if (!some.runs[r].readings.empty() && !some.runs[r].readings.front().rest.empty())
      some.runs[r].rest = some.runs[r].readings.front().rest;
  }
  std::erase_if(some.runs, [](const Run& run) { return run.readings.empty(); });
  return some;
}

}  // namespace

std::optional<SuspectedSlip> suspected_slip(const Study& study) {
  constexpr double mended = 0.1, rounding = 1e-6;  // of the misfit as read; of the places
  const Experiment few = some_of(study.experiment(), 0);
  if (few.runs.empty()) return {};
  Experiment as_told = few;
  if (few.arm_bench.frames == ArmBench::Frames::unknown) register_frames(as_told);
  const double as_read = misfit_of_places(as_told);
  if (!(as_read > rounding)) return {};
  std::optional<SuspectedSlip> best;
  for (const Slip& slip : slips_of(few)) {
    Experiment other = slip.rows == 0 ? few : some_of(study.experiment(), slip.rows);
    slip.mend(other);
    const double left = misfit_of_places(other);
    if (left < mended * std::min(1.0, as_read) && (!best || left < best->left))
      best = {slip.looks_like, slip.remedy, as_read, left};
  }
  return best;
}

}  // namespace plumbline::diagnose
