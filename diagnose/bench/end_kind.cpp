#include "diagnose/bench/end_kind.hpp"

#include <array>

namespace plumbline::diagnose {

const EndKind& end_kind(Alone alone) {
  using Name = Channel::Name;
  static const std::array kinds{EndKind{true,
                                        {Channel(Name::x), Channel(Name::y)},
                                        {Channel(Name::Fx), Channel(Name::Fy)},
                                        {Channel(Name::Fx_2), Channel(Name::Fy_2)},
                                        "displacement",
                                        "force",
                                        Sensor::angle,
                                        true,
                                        "nothing: angle and torque are of a joint alone, nominal.joint"},
                                EndKind{false,
                                        {Channel(Name::angle)},
                                        {Channel(Name::torque)},
                                        {Channel(Name::torque_2)},
                                        "angle",
                                        "torque",
                                        Sensor::angle,
                                        false,
                                        "nothing: a joint that turns has an angle and a torque"},
                                EndKind{false,
                                        {Channel(Name::x)},
                                        {Channel(Name::Fx)},
                                        {Channel(Name::Fx_2)},
                                        "displacement",
                                        "force",
                                        Sensor::position,
                                        false,
                                        "nothing: a joint that slides has x and Fx"}};
  return kinds[static_cast<std::size_t>(alone)];
}

std::vector<Channel> end_channels() {
  std::vector<Channel> all;
  for (const Alone alone : {Alone::no, Alone::turns, Alone::slides})
    for (const auto& channels : {end_kind(alone).place, end_kind(alone).load, end_kind(alone).second})
      all.insert(all.end(), channels.begin(), channels.end());
  return all;
}

}  // namespace plumbline::diagnose
