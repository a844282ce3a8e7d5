#include "support/files/file_identity.hpp"

#include <sys/stat.h>
#include <unistd.h>

namespace plumbline::files {

namespace fs = std::filesystem;

fs::path behind_links(fs::path path) {
  constexpr int most = 40;  // as the kernel has it
  const fs::path original = path;
  std::error_code error;
  for (int links = 0; links < most; ++links) {
    if (fs::symlink_status(path, error).type() != fs::file_type::symlink) return path;
    const fs::path next = fs::read_symlink(path, error);
    if (error) return path;
    path = path.parent_path() / next;  // an absolute one replaces what stands before
  }
  return original;
}

FileIdentity identity(const fs::path& path) {
  struct stat found = {};
  if (path == "-")
    return fstat(STDOUT_FILENO, &found) == 0 ? FileIdentity{found.st_dev, found.st_ino} : FileIdentity{};
  if (stat(path.c_str(), &found) == 0) return {found.st_dev, found.st_ino};
  const fs::path missing = behind_links(path);
  const fs::path folder = missing.has_parent_path() ? missing.parent_path() : fs::path(".");
  if (stat(folder.c_str(), &found) == 0) return {found.st_dev, found.st_ino, missing.filename().string()};
  return {0, 0, path.string()};
}

bool is_standard_output(const fs::path& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

}  // namespace plumbline::files
