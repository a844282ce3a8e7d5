#include "diagnose/exchange/read_model.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/exchange/read_mujoco.hpp"
#include "diagnose/exchange/read_sdf.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::exchange {
namespace {

using Parser = ReadModel (*)(const std::string&);

Parser mujoco() {
#ifdef PLUMBLINE_MUJOCO
  return read_mujoco;
#else
  return nullptr;
#endif
}

Parser sdformat() {
#ifdef PLUMBLINE_SDFORMAT
  return read_sdf;
#else
  return nullptr;
#endif
}

}  // namespace

ReadModel parsed(const std::filesystem::path& file, Format format) {
  Parser parser = format == Format::mjcf ? mujoco() : sdformat();
  // URDF has its springs in elements that sdformat alone knows.
  if (parser == nullptr && format == Format::urdf) parser = mujoco();
  if (parser == nullptr)
    throw Error(file.string(),
                format == Format::sdf ? "SDF, and no sdformat12" : "a simulator's model, and no MuJoCo",
                "a program that was built with it: ./setup.sh --models, then build again");
  return parser(file.string());
}

PlanarChain read_model(const std::filesystem::path& file) {
  const Format format = format_of(file);
  const std::string text = files::read_text(file);
  if (format == Format::toml) return {diagnose::parse_nominal(text, file.string()), {}};
  return planar_chain(parsed(file, format), file.string());
}

}  // namespace plumbline::exchange
