#include <unistd.h>

#include <filesystem>

#include "diagnose/exchange/read_model.hpp"
#include "support/files/output_file.hpp"
#include "tests/fuzz/target.hpp"

namespace {

/// A file of this process alone, that ends as a format's files do.
std::string file_of(const char* ending) {
  return (std::filesystem::temp_directory_path() / ("fuzz-" + std::to_string(getpid()) + ending)).string();
}

}  // namespace

/// A simulator's model: what its parser lets through is to be an arm, and a planar chain. The first letter
/// says which format: a line of "m" MJCF, "u" URDF, "s" SDF, and the file behind it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const std::string mjcf = file_of(".xml"), urdf = file_of(".urdf"), sdf = file_of(".sdf");
  static const int removed = std::atexit([] {
    for (const std::string& file : {mjcf, urdf, sdf}) std::filesystem::remove(file);
  });
  if (size < 2 || removed != 0) return 0;
  const std::string& file = bytes[0] == 'u' ? urdf : bytes[0] == 's' ? sdf : mjcf;
  offer(bytes + 2, size - 2, [&](const std::string& text) {
    plumbline::files::write_text(file, text);
    plumbline::exchange::read_arm(file);
  });
  return offer(bytes + 2, size - 2, [&](const std::string&) { plumbline::exchange::read_model(file); });
}
