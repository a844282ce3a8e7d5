#include "diagnose/exchange/format.hpp"

#include <plumbline/base/error.hpp>

namespace plumbline::exchange {

Format format_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".toml") return Format::toml;
  if (ending == ".xml") return Format::mjcf;
  if (ending == ".urdf") return Format::urdf;
  if (ending == ".sdf") return Format::sdf;
  throw Error(file.string(), ending.empty() ? "no ending" : "the ending " + ending,
              "a model: .toml (ours), .xml (MJCF), .urdf or .sdf");
}

}  // namespace plumbline::exchange
