#include "diagnose/bench/end_kind.hpp"

#include <array>

namespace plumbline::diagnose {

const EndKind& end_kind(Device device) {
  using Name = Channel::Name;
  using Of = ChannelKind::Of;
  static const std::array kinds{
      EndKind{.axes = 2,
              .has_links = true,
              .visits_poses = false,
              .joints = Of::chain,
              .place = {Channel(Name::x), Channel(Name::y)},
              .load = {Channel(Name::Fx), Channel(Name::Fy)},
              .second = {Channel(Name::Fx_2), Channel(Name::Fy_2)},
              .by_place = "displacement",
              .by_load = "force",
              .joint = Sensor::angle,
              .joint_angles = true,
              .has_others = "nothing: angle and torque are of a joint alone, nominal.joint"},
      EndKind{.axes = 1,
              .has_links = false,
              .visits_poses = false,
              .joints = Of::end,
              .place = {Channel(Name::angle)},
              .load = {Channel(Name::torque)},
              .second = {Channel(Name::torque_2)},
              .by_place = "angle",
              .by_load = "torque",
              .joint = Sensor::angle,
              .joint_angles = false,
              .has_others = "nothing: a joint that turns has an angle and a torque"},
      EndKind{.axes = 1,
              .has_links = false,
              .visits_poses = false,
              .joints = Of::end,
              .place = {Channel(Name::x)},
              .load = {Channel(Name::Fx)},
              .second = {Channel(Name::Fx_2)},
              .by_place = "displacement",
              .by_load = "force",
              .joint = Sensor::position,
              .joint_angles = false,
              .has_others = "nothing: a joint that slides has x and Fx"},
      EndKind{.axes = 3,
              .has_links = true,
              .visits_poses = true,
              .joints = Of::arm,
              .place = {},
              .load = {},
              .second = {},
              .by_place = "command",
              .by_load = "command",
              .joint = Sensor::angle,
              .joint_angles = true,
              .has_others = "nothing: an arm has joints and points"}};
  return kinds[static_cast<std::size_t>(device)];
}

std::vector<Channel> end_channels() {
  std::vector<Channel> all;
  for (const Device device : {Device::chain, Device::turning_joint, Device::sliding_joint})
    for (const auto& channels : {end_kind(device).place, end_kind(device).load, end_kind(device).second})
      all.insert(all.end(), channels.begin(), channels.end());
  return all;
}

}  // namespace plumbline::diagnose
