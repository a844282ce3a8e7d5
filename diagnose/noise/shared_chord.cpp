/// \file
/// A chord that is too soft to be heard in any one series.

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <optional>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/chord.hpp"
#include "diagnose/noise/noise.hpp"
#include "diagnose/noise/spectrum.hpp"

namespace plumbline::diagnose {
namespace {

/// Series of a run that were read together, have no tone yet, and are long enough for one.
std::vector<std::size_t> read_together(const Measurements& measurements, std::size_t first,
                                       const std::vector<Hum>& all) {
  const std::vector<Series>& series = measurements.series();
  std::vector<std::size_t> together;
  for (std::size_t s = first; s < series.size() && series[s].run == series[first].run; ++s) {
    const bool has = std::any_of(all.begin(), all.end(), [&](const Hum& one) { return one.series == s; });
    if (!has && long_enough(series[s]) && series[s].readings == series[first].readings) together.push_back(s);
  }
  return together;
}

/// How far noise alone would fall behind at every look: of independent series the sum of what each has,
/// -(n - 1) log(1 - share), which is exponential in one of them.
Eigen::VectorXd loudness(const Measurements& measurements, const std::vector<std::size_t>& together,
                         const std::vector<Eigen::VectorXd>& spectra) {
  constexpr double whole = 1 - 1e-12;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(spectra[together.front()].size());
  for (const std::size_t s : together)
    sum.array() -=
        (ordinates(measurements.series()[s].readings.size()) - 1) * (1 - spectra[s].array().min(whole)).log();
  return sum;
}

/// Whether nothing beyond the line itself comes near it, and it is no flank of what is slower: a kink of the
/// residual is heard at all frequencies.
bool is_line(const Eigen::VectorXd& loud, Eigen::Index at) {
  constexpr double stands_out = 2;
  constexpr Eigen::Index width = 3 * looks_an_ordinate / 2;
  double beside = 0;
  for (Eigen::Index look = 0; look < loud.size(); ++look)
    if (std::abs(look - at) > width) beside = std::max(beside, loud(look));
  return at >= looks_an_ordinate && loud(at) > stands_out * beside;
}

/// Where series that were read together have a tone that is too soft to be heard in one of them, and the
/// chance that noise alone has one as loud.
struct Shared {
  Eigen::Index look;
  double chance;
};

std::optional<Shared> shared_look(const Eigen::VectorXd& loud, std::size_t count, std::size_t series) {
  Shared shared{};
  const double most = loud.maxCoeff(&shared.look);
  if (series < 2 || !is_line(loud, shared.look)) return std::nullopt;
  shared.chance = 2 * ordinates(count) * boost::math::gamma_q(static_cast<double>(series), most);
  return shared;
}

/// The same beside a tone that was heard in another series of the run: within half an ordinate of that.
std::optional<Shared> shared_look(const Eigen::VectorXd& loud, std::size_t count, std::size_t series,
                                  const Hum& heard) {
  constexpr Eigen::Index near = looks_an_ordinate / 2;
  const double look =
      (1 / heard.period - slowest_tone(count)) * looks_an_ordinate * static_cast<double>(count);
  const Eigen::Index from = std::max<Eigen::Index>(std::lround(look) - near, 0);
  const Eigen::Index looks = std::min<Eigen::Index>(2 * near + 1, loud.size() - from);
  if (looks < 1) return std::nullopt;
  Shared shared{};
  const double most = loud.segment(from, looks).maxCoeff(&shared.look);
  shared.look += from;
  shared.chance = static_cast<double>(looks) * boost::math::gamma_q(static_cast<double>(series), most);
  return shared;
}

}  // namespace

void add_shared(const Measurements& measurements, const std::vector<double>& residual,
                const std::vector<Eigen::VectorXd>& spectra, double level, std::vector<Hum>& all) {
  const std::vector<Series>& series = measurements.series();
  const std::vector<Hum> heard = all;
  for (std::size_t first = 0; first < series.size(); ++first) {
    if (first > 0 && series[first].run == series[first - 1].run) continue;
    const std::vector<std::size_t> together = read_together(measurements, first, all);
    if (together.empty()) continue;
    const std::size_t count = series[together.front()].readings.size();
    const Eigen::VectorXd loud = loudness(measurements, together, spectra);
    const auto here = std::find_if(heard.begin(), heard.end(), [&](const Hum& one) {
      return series[one.series].run == series[first].run;
    });
    const auto found = here == heard.end() ? shared_look(loud, count, together.size())
                                           : shared_look(loud, count, together.size(), *here);
    if (!found || !(found->chance < level)) continue;
    Chord chord;
    for (const std::size_t s : together) {
      chord.push_back(
          tone_of(values_of(series[s], residual), clock_of(series[s]), looked_at(count, found->look)));
      chord.back().series = s;
    }
    const bool ripples = std::any_of(chord.begin(), chord.end(),
                                     [](const Hum& one) { return one.rms() > beliefs::largest_hum; });
    if (!ripples) all.insert(all.end(), chord.begin(), chord.end());
  }
}

}  // namespace plumbline::diagnose
