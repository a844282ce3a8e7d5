#pragma once
/// \file
/// The formats that models are written in.

#include <filesystem>

namespace plumbline::exchange {

enum class Format { toml, mjcf, urdf, sdf };

/// By the ending of a file's name: .toml, .xml, .urdf, .sdf.
/// \throws Error that names the file, for another ending
Format format_of(const std::filesystem::path& file);

}  // namespace plumbline::exchange
