#pragma once
/// \file
/// Lines of a drawing in few bytes.

#include <string>

namespace plumbline::page {

/// How far a compact line may lie from the line that was drawn, in pixels.
inline constexpr double unseen = 0.1;

/// The data of an SVG path of straight lines, in tenths of a pixel and relative, without the points that are
/// within `unseen` of the line without them; as it is where it has anything but M, L and Z.
std::string compact_line(const std::string& path);

}  // namespace plumbline::page
