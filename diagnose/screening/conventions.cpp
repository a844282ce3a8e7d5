#include "diagnose/screening/conventions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <plumbline/base/error.hpp>
#include <utility>

#include "diagnose/bench/conversion.hpp"
#include "diagnose/rig/nominal.hpp"
#include "diagnose/screening/arm_conventions.hpp"
#include "diagnose/screening/misfit.hpp"
#include "diagnose/screening/stuck_channel.hpp"

namespace plumbline::diagnose {
namespace {

/// Misfits of a column below this fraction, and starts this near to the unloaded end points (in lengths of
/// the chain), raise no question.
constexpr double misfit_in_doubt = 0.05, start_in_doubt = 0.01;
/// Largest misfit of a run that a slip elsewhere leaves unchanged.
constexpr double misfit_of_a_gap = 0.25;
/// Distances of starts that support an axis or angle convention, and fractions of them that a conversion may
/// leave: the second pair is sufficient evidence alone.
constexpr double start_off = 0.03, start_far_off = 0.1, mostly_placed = 0.1, wholly_placed = 0.02;
/// Largest fractions of the misfit, and of the readings, that a conversion may leave.
struct Allowance {
  double misfit, readings;
};
/// Largest fraction of the misfit as read, both of the readings, that a conversion may leave: it mends nearly
/// all, or the numbers are another gap's.
constexpr double nearly_all = 0.35;
/// With a gap beside the slip the readings still follow the model: what leaves more than 0.6 of them explains
/// less than two thirds of their square, and is no answer to ask about. A gap does not turn or reverse
/// numbers, nor multiply them by a thousand; but a chain that buckles to the other side looks mirrored, and a
/// soft first joint looks like a list in reverse order. A conversion that other runs refute must mend the
/// rest nearly completely.
constexpr Allowance usual{0.2, 0.6}, of_a_mirror{0.1, 0.5}, of_an_order{0.04, 0.2},
    of_a_large_factor{0.6, 0.6}, refuted_elsewhere{0.03, 0.15};

bool is_large(double factor) {
  return factor != 0 && std::abs(std::log(factor)) > std::log(20);
}

bool is_of_an_order(const Conversion& conversion) {
  return conversion.chain && conversion.factor == 0;
}

const Allowance& allowance(const Conversion& conversion) {
  if (conversion.mirror) return of_a_mirror;
  if (is_of_an_order(conversion)) return of_an_order;
  return is_large(conversion.factor) ? of_a_large_factor : usual;
}

/// Whether the nominal model predicts the same for both.
bool same_command(const Experiment& a, const Experiment& b) {
  const auto same_run = [](const Run& one, const Run& other) {
    const auto same_reading = [&](const Reading& r, const Reading& s) {
      return one.imposed_at(r) == other.imposed_at(s) && r.rest == s.rest;
    };
    return one.rest == other.rest &&
           std::equal(one.readings.begin(), one.readings.end(), other.readings.begin(), same_reading);
  };
  return a.link_length == b.link_length && a.joint_stiffness == b.joint_stiffness &&
         a.link_mass == b.link_mass &&
         std::equal(a.runs.begin(), a.runs.end(), b.runs.begin(), b.runs.end(), same_run);
}

/// Sum of the distances between the runs' starts and their unloaded end points, in lengths of the chain.
double distance_at_start(const Experiment& experiment) {
  double sum = 0;
  const double whole = std::accumulate(experiment.link_length.begin(), experiment.link_length.end(), 0.0);
  for (const Run& run : experiment.runs) {
    if (!run.holds_end_point() || run.readings.empty() || run.imposed().size() == 1) continue;
    sum += (run.command(run.readings.front()) - unloaded_end(experiment, run.rest)).norm() / whole;
  }
  return sum;
}

/// The effect of a conversion on the columns that it changes: their misfits, and their sums by sensor as
/// fractions of the sensor's in the run.
struct Change {
  double before = 0, after = 0;
  std::array<ColumnSums, sensors> was, is;
  bool readable = true;  ///< the converted columns hold most of their readings

  Change& operator+=(const Change& other) {
    before += other.before, after += other.after;
    for (std::size_t s = 0; s < was.size(); ++s) add(was[s], other.was[s], 1), add(is[s], other.is[s], 1);
    return *this;
  }
  static void add(ColumnSums& sum, const ColumnSums& one, double unit) {
    sum.measured += one.measured / unit;
    sum.predicted += one.predicted / unit;
    sum.product += one.product / unit;
  }
};

Change compare_run(const RunSums& before, const RunSums& after) {
  Change change;
  change.readable = after.size() == before.size();
  for (std::size_t c = 0; change.readable && c < after.size(); ++c) {
    change.readable = 2 * after[c].count >= before[c].count;
    const double b = misfit(before, before[c]), a = misfit(after, after[c]);
    if (std::abs(a - b) < 1e-9) continue;
    const auto sensor = place_of(after[c].channel.sensor());
    change.before += b, change.after += a;
    Change::add(change.was[sensor], before[c], energy_of_sensor(before, before[c]));
    Change::add(change.is[sensor], after[c], energy_of_sensor(after, after[c]));
  }
  return change;
}

/// Largest logarithm of the best remaining common factor. No error is a factor of twenty, and none a factor
/// of about ten at all joints; a factor of about four is possible. A wrong shape of the prediction shifts the
/// best factor.
double tolerance(double factor, double shape) {
  if (is_large(factor)) return std::log(2);
  return (std::abs(std::log(factor)) > std::log(7) ? 0.2 : 0.05) + std::min(shape, 0.35);
}

/// Whether the best remaining common factor of a unit is one.
bool centred(const ColumnSums& sensor, double factor) {
  if (factor == 0 || sensor.predicted == 0 || sensor.measured == 0) return true;
  const double best = sensor.product / sensor.predicted;
  const double shape =
      std::sqrt(std::max(0.0, 1 - sensor.product * sensor.product / (sensor.predicted * sensor.measured)));
  return best > 0 && std::abs(std::log(best)) < tolerance(factor, shape);
}

double relative_rms(const std::array<ColumnSums, sensors>& sensors) {
  double left = 0, measured = 0;
  for (const ColumnSums& one : sensors) left += one.difference(), measured += one.measured;
  return std::sqrt(left / measured);
}

/// Decades by which a number lies outside a usual range.
double decades_beyond(double value, double low, double high) {
  return value > 0 ? std::max({0.0, std::log10(low / value), std::log10(value / high)}) : 0;
}

/// Distance of the forces and lengths from those of a table-top bench: it distinguishes readings in kN from
/// stiffnesses in N mm/rad, which the nominal model cannot.
double unusual(const Experiment& experiment) {
  double force = 0;
  for (const Run& run : experiment.runs)
    for (const Reading& r : run.readings)
      force = std::fmax(force, std::fmax(std::abs(r[column_Fx]), std::abs(r[column_Fy])));
  const double length = std::accumulate(experiment.link_length.begin(), experiment.link_length.end(), 0.0);
  return decades_beyond(force, 0.1, 100) + decades_beyond(length, 0.05, 5);
}

/// A conversion and its result.
struct Trial {
  Conversion conversion;
  std::vector<std::size_t> runs = {};  ///< mended runs
  double misfit = 0;                   ///< left in all runs
  double unusual = 0;                  ///< distance from usual sizes
  double misfit_as_read = 0, left = 0;
  bool wholly_placed = false;
  double start = 0;  ///< remaining distance at the start
};

/// Whether a conversion places the unloaded end points at the starts of the runs.
enum class Placed { no, mostly, wholly };

class Check {
 public:
  explicit Check(const Study& study)
      : study_(study),
        as_is_(compare(study.experiment(), study.nominal())),
        start_(distance_at_start(study.experiment())),
        conversions_(conversions(study.experiment())) {}

  [[nodiscard]] bool in_doubt() const {
    const auto misfits = [](const RunSums& run) { return worst(run) > misfit_in_doubt; };
    return !study_.nominal().reached || start_ > start_in_doubt ||
           std::any_of(as_is_.begin(), as_is_.end(), misfits);
  }

  [[nodiscard]] double start_error_as_read() const { return start_; }

  [[nodiscard]] std::vector<Trial> suspected() const {
    std::vector<Trial> found;
    for (const Conversion& conversion : conversions_)
      if (const std::optional<Trial> trial = attempt(conversion)) found.push_back(*trial);
    return found;
  }

 private:
  /// The experiment after a conversion; one of some runs leaves those alone that agree as read.
  [[nodiscard]] Experiment as_if(const Conversion& conversion) const {
    Experiment experiment = converted(study_.experiment(), conversion);
    if (!conversion.of_some) return experiment;
    for (std::size_t r = 0; r < as_is_.size(); ++r)
      if (worst(as_is_[r]) <= misfit_in_doubt) experiment.runs[r] = study_.experiment().runs[r];
    return experiment;
  }

  [[nodiscard]] std::optional<Trial> attempt(const Conversion& conversion) const {
    const Experiment experiment = as_if(conversion);
    constexpr double rounding = 1e-3;
    const double start = distance_at_start(experiment);
    if (start > start_ + rounding) return {};
    Prediction predicted;
    if (same_command(experiment, study_.experiment())) {
      predicted = study_.nominal();
    } else {
      predicted = simulate(experiment, nominal_rig(experiment), {});
    }
    if (!predicted.reached) return {};
    std::optional<Trial> trial = judge(conversion, compare(experiment, predicted), placed(conversion, start));
    if (!trial) return {};
    trial->unusual = unusual(experiment);
    trial->start = start;
    return trial;
  }

  /// Unloaded end points do not depend on springs, loads or force sensors; where an order places them, it
  /// needs no more evidence than a unit.
  [[nodiscard]] Placed placed(const Conversion& conversion, double start) const {
    if (start_ > start_far_off && start < wholly_placed * start_) return Placed::wholly;
    const double off = is_of_an_order(conversion) ? start_in_doubt : start_off;
    return start_ > off && start < mostly_placed * start_ ? Placed::mostly : Placed::no;
  }

  /// \param now  the converted columns
  [[nodiscard]] std::optional<Trial> judge(const Conversion& conversion, const std::vector<RunSums>& now,
                                           Placed placed) const {
    return placed == Placed::wholly ? judge_placed(conversion, now) : judge_mended(conversion, now, placed);
  }

  /// A conversion that places the starts of all runs must not make anything else worse; how much it mends
  /// depends on the gap.
  [[nodiscard]] std::optional<Trial> judge_placed(const Conversion& conversion,
                                                  const std::vector<RunSums>& now) const {
    Trial trial{conversion};
    Change whole;
    for (std::size_t r = 0; r < now.size(); ++r) {
      const Change change = compare_run(as_is_[r], now[r]);
      if (!change.readable) return {};
      for (const ColumnSums& column : now[r]) trial.misfit += misfit(now[r], column);
      trial.runs.push_back(r);
      whole += change;
    }
    if (whole.after > whole.before + misfit_in_doubt) return {};
    trial.wholly_placed = true;
    return trial;
  }

  /// The changed columns must agree in all runs that the conversion mends.
  [[nodiscard]] std::optional<Trial> judge_mended(const Conversion& conversion,
                                                  const std::vector<RunSums>& now, Placed placed) const {
    Trial trial{conversion};
    Change whole;
    bool refuted = false;
    for (std::size_t r = 0; r < now.size(); ++r) {
      const Change change = compare_run(as_is_[r], now[r]);
      if (!change.readable) return {};
      const bool mended = change.after < change.before;
      const bool worse = change.before < change.after;
      if (!mended && worst(as_is_[r]) > misfit_of_a_gap) return {};
      if (change.after > change.before + misfit_in_doubt && (conversion.chain || conversion.mirror))
        return {};
      refuted = refuted || worse;
      for (const ColumnSums& column : mended ? now[r] : as_is_[r])
        trial.misfit += misfit(mended ? now[r] : as_is_[r], column);
      if (!mended) continue;
      trial.runs.push_back(r);
      whole += change;
    }
    const bool mostly = placed == Placed::mostly;
    if (conversion.of_some && trial.runs.size() == now.size()) return {};
    const bool elsewhere = refuted || conversion.of_some;
    const Allowance& allowed = elsewhere ? refuted_elsewhere : mostly ? usual : allowance(conversion);
    const bool in_doubt = mostly || whole.before >= misfit_in_doubt;
    if (trial.runs.empty() || !in_doubt || whole.after > allowed.misfit * whole.before) return {};
    for (const ColumnSums& sensor : whole.is)
      if (!centred(sensor, conversion.factor)) return {};
    trial.misfit_as_read = relative_rms(whole.was);
    trial.left = relative_rms(whole.is);
    const double most = std::min(nearly_all, allowed.readings) * trial.misfit_as_read;
    if (trial.left > allowed.readings || trial.left > most) return {};
    return trial;
  }

  const Study& study_;
  std::vector<RunSums> as_is_;
  double start_;
  std::vector<Conversion> conversions_;
};

/// "220 %", "2.5 %"
std::string percent(double share) {
  return share < 0.1 ? fmt::format("{:.2g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
}

}  // namespace

std::optional<SuspectedConvention> suspected_convention(const Study& study) {
  const Check check(study);
  if (!check.in_doubt()) return {};
  std::vector<Trial> found = check.suspected();
  if (found.empty()) return {};
  if (std::ranges::any_of(found, &Trial::wholly_placed))
    std::erase_if(found, [](const Trial& one) { return !one.wholly_placed; });
  // Squares of residuals: half as much again, or a difference of a thousandth, is no distinction, and twice
  // as much is none between two units, whose factors a gap may shift; of those the more common is asked
  // first.
  constexpr double alike = 2.25, alike_units = 10, as_well_units = 4, anyway = 1e-3;
  const auto less = [](const Trial& a, const Trial& b) { return a.misfit < b.misfit; };
  const Trial least = *std::min_element(found.begin(), found.end(), less);
  // Runs that are right as read show how large the gap is, so that no factor is shifted by it.
  const bool known_gap = least.runs.size() < study.experiment().runs.size();
  const double as_near = known_gap ? 0 : anyway;
  std::erase_if(found, [&](const Trial& one) {
    const bool units = one.conversion.factor != 0 && least.conversion.factor != 0 && !known_gap;
    return one.misfit > std::max((units ? alike_units : alike) * least.misfit, least.misfit + as_near);
  });
  // The order of questions: by remaining misfit, by usual sizes, by frequency.
  const bool units = least.conversion.factor != 0 && !known_gap;
  const double as_well = std::max((units ? as_well_units : alike) * least.misfit, least.misfit + as_near);
  const auto order = [&](const Trial& one) {
    return std::pair(one.misfit > as_well ? one.misfit : 0.0, one.unusual);
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Trial& a, const Trial& b) { return order(a) < order(b); });
  const Trial& best = found.front();
  const Conversion& conversion = best.conversion;
  SuspectedConvention doubt{{},
                            conversion.what,
                            conversion.looks_like,
                            conversion.expected,
                            conversion.remedy,
                            {},
                            best.misfit_as_read,
                            best.left,
                            best.wholly_placed ? check.start_error_as_read() : 0,
                            best.start};
  if (best.runs.size() < study.experiment().runs.size())
    for (const std::size_t r : best.runs) doubt.runs.push_back(study.experiment().runs[r].id);
  for (std::size_t i = 1; i < found.size(); ++i)
    doubt.alternatives.push_back(found[i].conversion.what + " like " + found[i].conversion.looks_like);
  return doubt;
}

namespace {

/// \throws Error with the question where the readings of an arm agree with it after a slip is mended
void require_no_slip(const Study& study) {
  const std::optional<SuspectedSlip> doubt = suspected_slip(study);
  if (!doubt) return;
  throw Error(
      study.experiment().name,
      fmt::format("readings in which {} (the places are then off by {} of their spread, instead of {})",
                  doubt->looks_like, percent(doubt->left), percent(doubt->as_read)),
      "places near those of the nominal arm: if it is so, write " + doubt->remedy + "; if not, pass --as-is");
}

}  // namespace

void require_conventions(const Study& study) {
  require_no_stuck_channel(study);
  if (study.experiment().arm) return require_no_slip(study);
  const std::optional<SuspectedConvention> doubt = suspected_convention(study);
  if (!doubt) return;
  std::string where = study.experiment().name + ", ";
  if (!doubt->runs.empty())
    where += fmt::format("run{} {}, ", doubt->runs.size() > 1 ? "s" : "", fmt::join(doubt->runs, ", "));
  std::string found = "what looks like " + doubt->looks_like;
  for (const std::string& other : doubt->alternatives) found += ", or " + other;
  if (doubt->start_error_as_read > 0)
    found +=
        fmt::format(" (the starts are then off by {:.2g} lengths of the chain in all, instead of {:.2g})",
                    doubt->start, doubt->start_error_as_read);
  else
    found += fmt::format(" (the misfit then falls from {} to {})", percent(doubt->misfit_as_read),
                         percent(doubt->left));
  throw Error(where + doubt->what, found,
              doubt->expected + ": if it is so, write " + doubt->remedy + "; if not, pass --as-is");
}

}  // namespace plumbline::diagnose
