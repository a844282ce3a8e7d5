#pragma once
/// \file
/// What is put and what is read at the end of a chain, or of a joint alone: a row of a table.

#include <string_view>
#include <vector>

#include "diagnose/bench/channel.hpp"

namespace plumbline::diagnose {

/// A joint alone has no links: its angle and its torque are all there is of it, or the stroke and the force
/// of one that slides.
enum class Alone { no, turns, slides };

struct EndKind {
  bool has_links;                      ///< behind the end: they have lengths and angles, and may buckle
  std::vector<Channel> place;          ///< where the end point, or the joint, is
  std::vector<Channel> load;           ///< what the environment does to it
  std::vector<Channel> second;         ///< the load once more, by a second sensor
  std::string_view by_place, by_load;  ///< words of `control` for what is imposed
  Sensor joint;                        ///< in what joints move
  bool joint_angles;                   ///< angles of joints may be read beside the place
  std::string_view has_others;         ///< what is expected in place of the channels of other benches
};

const EndKind& end_kind(Alone alone);
/// Of all ends.
std::vector<Channel> end_channels();

}  // namespace plumbline::diagnose
