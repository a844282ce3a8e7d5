#pragma once
/// \file
/// What is put and what is read at the end of a device: a row of a table for each kind of device.

#include <string_view>
#include <vector>

#include "diagnose/bench/channel.hpp"

namespace plumbline::diagnose {

/// A chain in a plane; a joint alone, which has no links: its angle and its torque are all there is of it, or
/// the stroke and the force of one that slides; an arm in space.
enum class Device { chain, turning_joint, sliding_joint, arm };

struct EndKind {
  std::size_t axes;  ///< of the space in which it moves: without links 1
  bool has_links;    ///< behind the end: they have lengths and angles, and may buckle
  /// Readings are poses that are visited; else they lie on the way of a command, along which values are alike
  /// and history is known.
  bool visits_poses;
  ChannelKind::Of joints;              ///< whose channels its joints have, besides their angles
  std::vector<Channel> place;          ///< where the end point, or the joint, is; nothing is put to an arm's
  std::vector<Channel> load;           ///< what the environment does to it
  std::vector<Channel> second;         ///< the load once more, by a second sensor
  std::string_view by_place, by_load;  ///< words of `control` for what is imposed
  Sensor joint;                        ///< in what joints move
  bool joint_angles;                   ///< angles of joints may be read beside the place
  std::string_view has_others;         ///< what is expected in place of the channels of other benches
};

const EndKind& end_kind(Device device);
/// Of all ends.
std::vector<Channel> end_channels();

}  // namespace plumbline::diagnose
