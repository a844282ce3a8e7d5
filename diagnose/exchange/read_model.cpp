#include "diagnose/exchange/read_model.hpp"

#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/exchange/read_mjcf.hpp"
#include "diagnose/exchange/read_sdf.hpp"
#include "diagnose/exchange/read_urdf.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::exchange {
namespace {

/// A simulator's.
ReadModel model_in(const std::filesystem::path& file) {
  switch (format_of(file)) {
    case Format::mjcf:
      return read_mjcf(file);
    case Format::urdf:
      return read_urdf(file);
    case Format::sdf:
      return read_sdf(file);
    case Format::toml:
      break;
  }
  throw Error(file.string(), "a chain in our TOML", "a simulator's model: .xml (MJCF), .urdf or .sdf");
}

}  // namespace

PlanarChain read_model(const std::filesystem::path& file, const std::vector<std::string>& kept) {
  if (format_of(file) != Format::toml) return planar_chain(model_in(file), file.string(), kept);
  if (!kept.empty()) throw Error(file.string(), "joints to keep of a chain", "a simulator's model");
  return {diagnose::parse_nominal(files::read_text(file), file.string()), {}};
}

SpatialArm read_arm(const std::filesystem::path& file, const ArmEnds& ends) {
  return spatial_arm(model_in(file), file.string(), ends);
}

}  // namespace plumbline::exchange
