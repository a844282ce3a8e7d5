#include "diagnose/inference/hum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <optional>

#include "diagnose/beliefs.hpp"
#include "diagnose/inference/least_squares.hpp"
#include "diagnose/inference/spectrum.hpp"

namespace plumbline::diagnose {
namespace {

Eigen::VectorXd clock_of(const Series& series) {
  return Eigen::Map<const Eigen::VectorXd>(series.clock.data(),
                                           static_cast<Eigen::Index>(series.clock.size()));
}

/// The tone of this frequency in fast values.
Hum tone_of(const Eigen::VectorXd& fast, const Eigen::VectorXd& clock, double frequency) {
  const Eigen::Vector2d size = amplitudes(fast, tone(clock, frequency));
  return {0, 1 / frequency, size(0), size(1)};
}

/// The loudest tone in these values, the chance that noise alone has one as loud, and their spectrum.
struct Loudest {
  Hum tone;
  double chance;
  Eigen::VectorXd shares;
};

Loudest loudest(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double correlation) {
  const auto count = static_cast<std::size_t>(values.size());
  const Eigen::VectorXd fast = fast_part(values);
  Eigen::VectorXd shares = tone_shares(fast, clock, correlation);
  Eigen::Index look = 0;
  const double share = shares.maxCoeff(&look);
  // Fisher: with n ordinates the largest share g of the energy has P(g > x) < n (1 - x)^(n - 1); looking
  // between the ordinates finds no more than twice as often.
  const double n = ordinates(count);
  return {tone_of(fast, clock, looked_at(count, look)), 2 * n * std::pow(1 - share, n - 1),
          std::move(shares)};
}

/// That a series may have.
constexpr long most_tones = 2;

/// A spectrum of fewer ordinates has no line.
bool long_enough(const Series& series) {
  return series.readings.size() >= 16;
}

Eigen::VectorXd values_of(const Series& series, const std::vector<double>& residual) {
  return Eigen::Map<const Eigen::VectorXd>(residual.data() + series.first,
                                           static_cast<Eigen::Index>(series.readings.size()));
}

/// By how much neighbours correlate beside the loudest tone of each series, be it noise or not.
double correlation_beside_tones(const Measurements& measurements, const std::vector<double>& residual) {
  std::vector<Hum> all;
  for (std::size_t s = 0; s < measurements.series().size(); ++s) {
    const Series& series = measurements.series()[s];
    if (!long_enough(series)) continue;
    all.push_back(loudest(values_of(series, residual), clock_of(series), 0).tone);
    all.back().series = s;
  }
  return estimate_noise(measurements, without_hum(measurements, residual, all)).correlation;
}

/// A tone in some series of a run, alike in frequency.
using Chord = std::vector<Hum>;

double rms_of(const Chord& chord) {
  double squares = 0;
  for (const Hum& one : chord) squares += one.rms() * one.rms();
  return std::sqrt(squares / static_cast<double>(chord.size()));
}

/// The tones of each run, those alike in frequency together; of a series that has two the louder alone.
std::vector<Chord> chords(const Measurements& measurements, const std::vector<Hum>& all) {
  std::vector<Chord> heard;
  for (std::size_t h = 0; h < all.size(); ++h) {
    if (h > 0 && all[h - 1].series == all[h].series) continue;
    const std::size_t run = measurements.series()[all[h].series].run;
    const auto known = std::find_if(heard.begin(), heard.end(), [&](const Chord& chord) {
      return measurements.series()[chord.front().series].run == run && chord.front().period == all[h].period;
    });
    known == heard.end() ? heard.push_back({all[h]}) : known->push_back(all[h]);
  }
  return heard;
}

/// A tone of this frequency, slow in a series: beside its mean, and how far noise alone would fall behind.
struct Slow {
  Hum tone;
  double loud;
};

Slow slow_tone(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency) {
  Eigen::MatrixX3d waves(values.size(), 3);
  waves << tone(clock, frequency), Eigen::VectorXd::Ones(values.size());
  const Eigen::Vector3d size = LeastSquares(waves).solve(values);
  const double energy = (values.array() - values.mean()).square().sum(),
               left = (values - waves * size).squaredNorm();
  return {{0, 1 / frequency, size(0), size(1)},
          left > 0 ? static_cast<double>(values.size() - 3) / 2 * std::log(energy / left) : 0};
}

/// A chord that is known from another run, in series of this one where it is slow: once around at least, as
/// loud as there within a factor of two, and not by chance.
std::optional<Chord> known_chord(const Measurements& measurements, const std::vector<double>& residual,
                                 const std::vector<std::size_t>& here, const Chord& heard, double level) {
  constexpr int looks = 9;  // within half an ordinate of the run where it was heard, to either side
  const Series &there = measurements.series()[heard.front().series],
               &first = measurements.series()[here.front()];
  const std::size_t count = first.readings.size();
  const double ratio = first.interval / there.interval;
  const double off = 0.5 / static_cast<double>(there.readings.size());
  double most = 0;
  Chord found;
  for (int i = 0; i < looks; ++i) {
    const double frequency = ratio * (1 / heard.front().period + off * (2.0 * i / (looks - 1) - 1));
    if (!(frequency * static_cast<double>(count) > 1) || !(frequency < slowest_tone(count))) continue;
    Chord chord;
    double loud = 0;
    for (const std::size_t s : here) {
      const Series& series = measurements.series()[s];
      Slow one = slow_tone(values_of(series, residual), clock_of(series), frequency);
      one.tone.series = s;
      loud += one.loud;
      chord.push_back(one.tone);
    }
    if (loud > most) most = loud, found = std::move(chord);
  }
  if (found.empty()) return std::nullopt;
  const double chance = looks * boost::math::gamma_q(static_cast<double>(here.size()), most);
  const double louder = rms_of(found) / rms_of(heard);
  if (!(chance < level) || !(louder > 0.5 && louder < 2)) return std::nullopt;
  return found;
}

/// Series of a run that may have a chord too, and have not: long enough, read together, of the channels that
/// it was heard in or of the others, without two tones of their own or one like it.
std::vector<std::size_t> deaf_to(const Measurements& measurements, std::size_t run, const Chord& heard,
                                 const std::vector<Hum>& all, bool of_its_channels) {
  const std::vector<Series>& series = measurements.series();
  const Series& there = series[heard.front().series];
  const double frequency = 1 / (heard.front().period * there.interval),
               ordinate = 1 / (static_cast<double>(there.readings.size()) * there.interval);
  std::vector<std::size_t> here;
  for (std::size_t s = 0; s < series.size(); ++s) {
    if (series[s].run != run || !long_enough(series[s]) || !(series[s].interval > 0)) continue;
    if (!here.empty() && series[s].readings != series[here.front()].readings) continue;
    const bool alike = std::any_of(heard.begin(), heard.end(), [&](const Hum& one) {
      return series[one.series].channel == series[s].channel;
    });
    const auto is_here = [&](const Hum& one) { return one.series == s; };
    const auto is_like_it = [&](const Hum& one) {
      return is_here(one) && std::abs(1 / (one.period * series[s].interval) - frequency) < ordinate;
    };
    if (alike == of_its_channels && std::count_if(all.begin(), all.end(), is_here) < most_tones &&
        std::none_of(all.begin(), all.end(), is_like_it))
      here.push_back(s);
  }
  return here;
}

/// Adds to the tones that were heard in some run those that others then have too: the same channels first,
/// and the rest, for what hums in one may be in the room.
void add_known(const Measurements& measurements, const std::vector<double>& residual, double level,
               std::vector<Hum>& all) {
  const std::vector<Chord> heard = chords(measurements, all);
  const std::size_t runs = measurements.series().empty() ? 0 : measurements.series().back().run + 1;
  for (std::size_t run = 0; run < runs; ++run)
    for (const Chord& one : heard)
      for (const bool its_channels : {true, false}) {
        if (!(measurements.series()[one.front().series].interval > 0)) continue;
        const std::vector<std::size_t> here = deaf_to(measurements, run, one, all, its_channels);
        if (here.empty()) continue;
        const std::vector<double> left = without_hum(measurements, residual, all);
        const auto found = known_chord(measurements, left, here, one, level);
        if (found) all.insert(all.end(), found->begin(), found->end());
      }
}

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

/// Adds to each run the tones that its series share.
/// \param spectra  of all series
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
      const Eigen::VectorXd fast = fast_part(values_of(series[s], residual));
      chord.push_back(tone_of(fast, clock_of(series[s]), looked_at(count, found->look)));
      chord.back().series = s;
    }
    const bool ripples = std::any_of(chord.begin(), chord.end(),
                                     [](const Hum& one) { return one.rms() > beliefs::largest_scale; });
    if (!ripples) all.insert(all.end(), chord.begin(), chord.end());
  }
}

}  // namespace

double Hum::rms() const {
  return std::hypot(cosine, sine) / std::numbers::sqrt2;
}

std::vector<Hum> find_hum(const Measurements& measurements, const std::vector<double>& residual) {
  constexpr double level = 1e-3;
  std::vector<Hum> all;
  std::vector<Eigen::VectorXd> spectra(measurements.series().size());
  const double correlation = correlation_beside_tones(measurements, residual);
  for (std::size_t s = 0; s < measurements.series().size(); ++s) {
    const Series& series = measurements.series()[s];
    if (!long_enough(series)) continue;
    Eigen::VectorXd values = values_of(series, residual);
    for (long i = 0; i < most_tones; ++i) {
      auto [one, chance, shares] = loudest(values, clock_of(series), correlation);
      spectra[s] = std::move(shares);
      if (!(chance < level) || one.rms() > beliefs::largest_scale) break;
      values -= tone(clock_of(series), 1 / one.period) * Eigen::Vector2d(one.cosine, one.sine);
      one.series = s;
      all.push_back(one);
    }
  }
  add_shared(measurements, residual, spectra, level, all);
  add_known(measurements, residual, level, all);
  return all;
}

std::vector<double> without_hum(const Measurements& measurements, std::vector<double> residual,
                                const std::vector<Hum>& hum) {
  for (const Hum& one : hum) {
    const Series& series = measurements.series()[one.series];
    Eigen::Map<Eigen::VectorXd> values(residual.data() + series.first,
                                       static_cast<Eigen::Index>(series.readings.size()));
    values -= tone(clock_of(series), 1 / one.period) * Eigen::Vector2d(one.cosine, one.sine);
  }
  return residual;
}

}  // namespace plumbline::diagnose
