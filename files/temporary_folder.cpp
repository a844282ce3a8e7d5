#include "files/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <plumbline/base/error.hpp>

namespace plumbline::files {
namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "plumbline-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw Error(pattern, std::strerror(errno), "a new folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace plumbline::files
