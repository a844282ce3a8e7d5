#pragma once
/// \file
/// An experiment under study: what was measured, and what follows from it once and for all.

#include <memory>
#include <mutex>

#include "diagnose/inference/measurements.hpp"
#include "diagnose/inference/summed_out.hpp"
#include "diagnose/rig/effect.hpp"
#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {

class Study {
 public:
  /// The effects that the experiment's nominal chain knows of the user's are looked for beside the
  /// catalogue's. \throws Error where the nominal model has an effect that is none
  explicit Study(Experiment experiment);
  /// The same, with these effects of the user's.
  Study(Experiment experiment, std::shared_ptr<const std::vector<Effect>> stated);
  /// Other readings of the same bench, in which the same effects are looked for.
  [[nodiscard]] Study of(Experiment other) const;

  [[nodiscard]] const Experiment& experiment() const { return experiment_; }
  [[nodiscard]] const Measurements& measurements() const { return measurements_; }
  [[nodiscard]] const CharacteristicScales& scales() const { return scales_; }
  /// The rows that are looked at: the catalogue's, and behind them those that the user states.
  [[nodiscard]] const std::vector<const Effect*>& effects() const { return effects_; }

  /// So many predictions may be made at once: as many as there are cores, but the user's expressions are
  /// evaluated one at a time.
  [[nodiscard]] unsigned threads() const;

  /// The rig that the nominal model believes in.
  [[nodiscard]] const Rig& nominal_rig() const { return nominal_rig_; }
  /// What the nominal model predicts; computed when it is first asked for.
  [[nodiscard]] const Prediction& nominal() const;
  /// (measured - predicted) / declared sigma, flat; of the nominal model. Frames that are unknown and
  /// tolerances of a calibrated arm are summed out: what is left has the noise's variance in all directions.
  [[nodiscard]] VectorXd residual(const Prediction& predicted) const;
  /// The same of derivatives or differences of predictions (one trace a run); nothing where frames and
  /// tolerances hold all of it.
  [[nodiscard]] VectorXd in_sigmas(const std::vector<Trace>& traces) const;
  [[nodiscard]] VectorXd nominal_residual() const;
  /// What the runs ask of the nominal joints; computed when it is first asked for.
  [[nodiscard]] const Excitation& excitation() const;

  /// The parameters of one effect and of a candidate.
  [[nodiscard]] std::vector<ParameterRange> ranges(const EffectAt& at) const;
  [[nodiscard]] std::vector<ParameterRange> ranges(const Candidate& candidate) const;

 private:
  [[nodiscard]] const SummedOut& summed_out() const;

  Experiment experiment_;
  std::vector<const Effect*> effects_;
  Measurements measurements_;
  CharacteristicScales scales_;
  Rig nominal_rig_;
  /// What is computed when it is first asked for, by whichever thread.
  struct Late {
    std::once_flag predicted, exercised, summed;
    Prediction nominal;
    Excitation exercise;
    SummedOut summed_out;
  };
  std::shared_ptr<Late> late_ = std::make_shared<Late>();
};

/// Every effect at every place of this chain where it can change anything at all: no stiffness error at a
/// passive joint, no gravity in a horizontal plane, no load-cell effect where no force is measured.
std::vector<EffectAt> possible_effects(const Study& study);

/// Effects that would be possible if the readings had a clock, and are not as they have none: they are looked
/// for with the number of a reading as its time, and count as causes outside of the catalogue.
std::vector<EffectAt> untimed_effects(const Study& study);

/// What is left of a candidate of which only some effects stay.
Instance part(const Study& study, const Candidate& candidate, const std::vector<double>& parameters,
              const std::function<bool(const EffectAt&)>& stays);

/// The nominal rig with the candidate's effects added. `parameters` are fitted coordinates.
Rig rig_with(const Study& study, const Candidate& candidate, const std::vector<double>& parameters);

/// The share of a parameter's scale by which sensitivities vary it.
inline constexpr double variation_share = 1e-6;
/// The same for a variation that is followed along a path of its own.
inline constexpr double path_share = 1e-3;

/// Predicts every channel of every reading.
/// \param parameters         fitted coordinates, in the order of the candidate's effects
/// \param with_sensitivity   also the derivatives by each parameter: one chord step and one back substitution
///                           each, so about a third of the cost of the prediction itself
Prediction predict(const Study& study, const Candidate& candidate, const std::vector<double>& parameters,
                   bool with_sensitivity = false);

}  // namespace plumbline::diagnose
