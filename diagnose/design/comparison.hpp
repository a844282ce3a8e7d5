#pragma once
/// \file
/// How much each effect of a design space looks like each other one, and like nothing.

#include <functional>

#include "diagnose/design/design_space.hpp"
#include "diagnose/design/fewest_runs.hpp"

namespace plumbline::diagnose {

class Comparison {
 public:
  /// Each effect by its tangents where it is sizeable and where fits start; what comes near another there is
  /// fitted to it in full.
  /// \param progress  called now and then with the share of the work that is done
  Comparison(const DesignSpace& space, const std::function<void(double)>& progress);

  [[nodiscard]] std::size_t size() const { return gap_.size(); }
  [[nodiscard]] const EffectAt& effect(std::size_t i) const {
    return space_.effects[i].candidate.effects.front();
  }

  /// Expected lead of whichever of the two leads less where it is true; infinite where neither competes.
  [[nodiscard]] double distinguishability(std::size_t i, std::size_t j,
                                          const std::vector<std::size_t>& runs) const;

  /// What must be shown to see an effect, and to tell two apart.
  [[nodiscard]] const Contrast& gap(std::size_t i) const { return gap_[i]; }
  [[nodiscard]] std::vector<Contrast> between(std::size_t i, std::size_t j) const;

 private:
  [[nodiscard]] bool competes(std::size_t truth, std::size_t alternative) const;
  [[nodiscard]] const Contrast& contrast(std::size_t truth, std::size_t alternative) const {
    return contrast_[truth * size() + alternative];
  }

  const DesignSpace& space_;
  std::vector<Contrast> gap_;       ///< by truth: the nominal model
  std::vector<Contrast> contrast_;  ///< [truth][alternative]; empty where the other does not compete
};

}  // namespace plumbline::diagnose
