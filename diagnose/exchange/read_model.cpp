#include "diagnose/exchange/read_model.hpp"

#include <plumbline/base/error.hpp>
#include <utility>

#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/exchange/corrected_springs.hpp"
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

/// With the corrections in it as effects of the nominal chain.
PlanarChain chain_in(ReadModel model, const std::string& file, const std::vector<std::string>& kept) {
  if (model.rows.empty()) return planar_chain(model, file, kept);
  if (!kept.empty()) throw Error(file, "joints to keep, and corrections of all", "the model without them");
  drop_added(model);
  PlanarChain read = planar_chain(model, file);
  std::vector<diagnose::NominalEffect> in_place = std::exchange(read.chain.effects, model.rows.effects);
  read.chain.laws = model.rows.laws;
  take_off_springs(read.chain, file);
  for (const diagnose::NominalEffect& one : read.chain.effects)
    read.notes.push_back("corrected by " + one.label());
  // Where a row has the dry friction, it has that of all joints.
  if (has_friction(read.chain, file))
    std::erase_if(in_place, [&](const diagnose::NominalEffect& one) {
      diagnose::NominalChain alone = read.chain;
      alone.effects = {one};
      return has_friction(alone, file);
    });
  read.chain.effects.insert(read.chain.effects.begin(), in_place.begin(), in_place.end());
  return read;
}

}  // namespace

PlanarChain read_model(const std::filesystem::path& file, const std::vector<std::string>& kept) {
  if (format_of(file) != Format::toml) return chain_in(model_in(file), file.string(), kept);
  if (!kept.empty()) throw Error(file.string(), "joints to keep of a chain", "a simulator's model");
  return {diagnose::parse_nominal(files::read_text(file), file.string()), {}};
}

SpatialArm read_arm(const std::filesystem::path& file, const ArmEnds& ends) {
  return spatial_arm(model_in(file), file.string(), ends);
}

diagnose::ReadArm ArmReader::read() {
  return [this](const std::string& file, const std::string& base, const std::string& tip) {
    SpatialArm arm = read_arm(file, {base, tip});
    effects_ = std::move(arm.effects);
    return std::move(arm.nominal);
  };
}

diagnose::Experiment ArmReader::with_effects(diagnose::Experiment experiment) const {
  experiment.effects.insert(experiment.effects.end(), effects_.begin(), effects_.end());
  return experiment;
}

}  // namespace plumbline::exchange
