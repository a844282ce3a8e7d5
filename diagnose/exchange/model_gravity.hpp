#pragma once
/// \file
/// Gravity of a model in a format that has no word for it: an instruction <?plumbline gravity="…"?> at the
/// head of the file.

#include <Eigen/Core>
#include <optional>
#include <pugixml.hpp>
#include <string>

namespace plumbline::exchange {

/// m/s², in the frame of the model; none where the file says nothing.
/// \param file  named in errors
/// \throws Error where it is no three numbers
std::optional<Eigen::Vector3d> gravity_in(const pugi::xml_document& document, const std::string& file);

/// The file with gravity at its head.
std::string with_gravity(const std::string& text, const Eigen::Vector3d& gravity);

}  // namespace plumbline::exchange
