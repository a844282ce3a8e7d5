#include "diagnose/draft/read_draft_model.hpp"

#include <optional>
#include <plumbline/base/error.hpp>

#include "support/files/text_file.hpp"

namespace plumbline::diagnose {
namespace {

void take_chain(const exchange::PlanarChain& read, ReadDraftModel& result) {
  DraftModel& model = result.model;
  model.chain = read.chain, model.joints = read.names, model.weighs = read.weighs;
  const Eigen::Vector2d base = read.plane.of(read.plane.origin);
  model.base = {base.x(), base.y()};
  for (const exchange::TakenJoint& joint : read.joints) model.angles.push_back({joint.sense, joint.straight});
  result.chain_notes = read.notes;
}

void take_arm(const exchange::SpatialArm& read, const std::filesystem::path& file,
              const exchange::ArmEnds& ends, ReadDraftModel& result) {
  result.model.arm = std::make_shared<const NominalArm>(read.nominal);
  result.model.file = {file.filename().string(), files::read_text(file)};
  result.model.base_body = ends.base, result.model.tip = ends.tip;
  result.arm_notes = read.notes;
}

}  // namespace

ReadDraftModel read_draft_model(const std::filesystem::path& file, const std::vector<std::string>& joints,
                                const exchange::ArmEnds& ends) {
  ReadDraftModel result;
  const bool ours = file.extension() == ".toml", chain_asked = !joints.empty(),
             arm_asked = !ends.base.empty() || !ends.tip.empty();
  if (ours || chain_asked) {
    take_chain(exchange::read_model(file, joints), result);
    return result;
  }
  std::optional<Error> no_chain;
  try {
    if (!arm_asked) take_chain(exchange::read_model(file), result);
  } catch (const Error& error) {
    no_chain = error;
  }
  try {
    take_arm(exchange::read_arm(file, ends), file, ends, result);
  } catch (const Error&) {
    if (no_chain || arm_asked) throw;
  }
  return result;
}

}  // namespace plumbline::diagnose
