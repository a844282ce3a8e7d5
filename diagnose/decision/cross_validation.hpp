#pragma once
/// \file
/// How far a model shrinks the gap on readings that its fit has not seen, each part of them held out in turn.

#include <functional>
#include <optional>

#include "diagnose/decision/shrink.hpp"
#include "diagnose/inference/search.hpp"

namespace plumbline::diagnose {

/// What a model leaves of all readings, flat, where it was fitted to the readings seen, in their noise;
/// nothing where these say too little to predict the part that is held out.
using LeftUnseen = std::function<std::optional<VectorXd>(const Study& seen, const NoiseEstimate& noise,
                                                         const HeldOut& part)>;

/// What a hypothesis leaves. A part of which its own uncertainty is larger than the gap there is no test.
LeftUnseen left_by(const Study& study, const Findings& findings, const Hypothesis& hypothesis);

/// How far a model shrinks what another leaves, or the nominal one. Runs are held out in turn, else blocks of
/// readings: of these two ways the first whose readings carry more than noise. Nothing where too little can
/// be held out.
std::optional<Shrink> cross_validated(const Study& study, const NoiseEstimate& noise,
                                      const LeftUnseen& left_unseen, const LeftUnseen& left_before = {});

/// How far a hypothesis shrinks what the nominal model leaves.
std::optional<Shrink> cross_validated(const Study& study, const Findings& findings,
                                      const NoiseEstimate& noise, const Hypothesis& hypothesis);

}  // namespace plumbline::diagnose
