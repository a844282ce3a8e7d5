#pragma once
/// \file
/// Which file a path means, by whatever name or link.

#include <sys/types.h>

#include <compare>
#include <filesystem>
#include <string>

namespace plumbline::files {

/// Device and inode of a file; of a file that is yet to be made, those of its folder, with its name.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;
  std::string name = {};
  auto operator<=>(const FileIdentity&) const = default;
};

/// The file at the end of all symbolic links, there or not. The path as it is where the links go in a circle.
std::filesystem::path behind_links(std::filesystem::path path);

/// "-" is standard output. Nothing is the same as what cannot be looked at.
FileIdentity identity(const std::filesystem::path& path);

/// Whether the path means what standard output goes to.
bool is_standard_output(const std::filesystem::path& path);

}  // namespace plumbline::files
