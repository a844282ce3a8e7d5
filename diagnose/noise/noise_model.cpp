#include "diagnose/noise/noise_model.hpp"

#include <cmath>

namespace plumbline::diagnose {

double at_pace(const Series& series, const BySensor& correlation, const Manner& manner) {
  const double fastest = of(series.channel, correlation);
  return manner.with_time[place_of(series.channel.sensor())] ? std::pow(fastest, series.pace) : fastest;
}

}  // namespace plumbline::diagnose
