#pragma once
/// \file How well each effect of a design space reproduces every other one.

#include <functional>

#include "diagnose/design/design_space.hpp"
#include "diagnose/design/fewest_runs.hpp"

namespace plumbline::diagnose {

class Comparison {
 public:
  /// Compares tangents of the effects at their typical size and at the initial guesses; where a tangent comes
  /// near another effect, the imitation is fitted in full.
  /// \param progress  called from time to time with the fraction of work done
  Comparison(const DesignSpace& space, const std::function<void(double)>& progress);

  [[nodiscard]] std::size_t size() const { return gap_.size(); }
  [[nodiscard]] const EffectAt& effect(std::size_t i) const {
    return space_.effects[i].candidate.effects.front();
  }

  /// The smaller of the two expected log-likelihood ratios, each with one of the effects as the truth;
  /// infinite where neither competes with the other.
  [[nodiscard]] double distinguishability(std::size_t i, std::size_t j,
                                          const std::vector<std::size_t>& runs) const;

  /// The contrasts that detect an effect, and that distinguish two.
  [[nodiscard]] const Contrast& gap(std::size_t i) const { return gap_[i]; }
  [[nodiscard]] std::vector<Contrast> between(std::size_t i, std::size_t j) const;

 private:
  [[nodiscard]] bool competes(std::size_t truth, std::size_t alternative) const;
  [[nodiscard]] const Contrast& contrast(std::size_t truth, std::size_t alternative) const {
    return contrast_[truth * size() + alternative];
  }

  const DesignSpace& space_;
  std::vector<Contrast> gap_;       ///< by true effect, against the nominal model
  std::vector<Contrast> contrast_;  ///< [truth][alternative]; empty where the alternative does not compete
};

}  // namespace plumbline::diagnose
