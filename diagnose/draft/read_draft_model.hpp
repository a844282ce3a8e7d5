#pragma once
/// \file
/// The model of a draft out of a file: a chain in a plane, an arm in space, or both.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/draft/draft.hpp"
#include "diagnose/exchange/read_model.hpp"

namespace plumbline::diagnose {

struct ReadDraftModel {
  DraftModel model;
  std::vector<std::string> chain_notes, arm_notes;  ///< what was read, what assumed, what left out

  /// Those of the bench that a draft has.
  [[nodiscard]] const std::vector<std::string>& notes(BenchKind bench) const {
    return bench == BenchKind::arm ? arm_notes : chain_notes;
  }
};

/// \param joints  that make a chain, the others held; empty: all, and the model may be an arm
/// \param ends    of the arm, where a person names them
/// \throws Error, one line, where the model is neither, as exchange::read_arm() does, or read_model() of a chain
ReadDraftModel read_draft_model(const std::filesystem::path& file,
                                const std::vector<std::string>& joints = {},
                                const exchange::ArmEnds& ends = {});

}  // namespace plumbline::diagnose
