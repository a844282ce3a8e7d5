#pragma once
/// \file
/// Drawings of gnuplot's without what no one sees.

#include <string>

namespace plumbline::page {

/// The same drawing in fewer bytes: no empty or unused elements, every combination of attributes said once,
/// and compact lines (compact_line.hpp).
/// \throws Error where the text is no XML
std::string compact_svg(const std::string& svg);

}  // namespace plumbline::page
