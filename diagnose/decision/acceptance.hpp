#pragma once
/// \file
/// What is accepted as an explanation after the first verdict: which doubts are laid on one that stands out,
/// and which is taken though it leaves more than the noise.

#include <optional>

#include "diagnose/decision/shrink.hpp"
#include "diagnose/decision/verdict.hpp"

namespace plumbline::diagnose {

/// With thousands of readings every model fails a test for exactness. The best partial explanation of one
/// effect that predicts held-out readings nearly to the noise, where these show the gap clearly, is what was
/// looked for, with a remainder: beside a cause outside the catalogue where it leaves clearly more than noise
/// does, by more than chance, or has a value at every joint, link or run. Two effects are not: of 14 such on
/// simulated experiments eleven had a cause outside the catalogue. Answers whether there is one.
bool accept_remainder(const Study& study, const NoiseModel& noise, Cause& cause);

/// Where nothing better was found: names beside a cause outside the catalogue the best partial explanation
/// that predicts them to one and a half times the noise. Answers whether there is one.
bool accept_doubtful(const Study& study, const NoiseModel& noise, Cause& cause);

/// Makes the best explanation of fewer effects that leaves no structure the one that stands out, where the
/// best takes three and does not predict. Answers whether there is one.
bool step_down(const std::optional<Shrink>& blind, Cause& cause);

/// What does not predict, or could not be tested, is not identified: it may be one of the causes that nobody
/// has listed. Nor are three effects, which explain much that they are not: they are no more than the best
/// partial explanation.
/// Doubtful are two of which one has many values, two that are tested on little more than noise, what
/// machining leaves without another cause, and tolerances that are wider than that. \param blind  nothing
/// where no readings could test it
void demand_prediction(const Study& study, const std::optional<Shrink>& blind, Cause& cause);

/// What leaves most of the gap that held-out readings carry, and does not predict them, explains nothing
/// there, whatever it was accepted for: it is no more than the best partial explanation.
void demand_shrink(const std::optional<Shrink>& blind, Cause& cause);

/// What sets in somewhere (a stop) and shows in one run alone is not identified: no other run tests where.
void demand_second_run(const Study& study, Cause& cause);

/// Leaves to the others of a class, of which the readings do not tell the best apart, the chance that one of
/// them is the cause at least has: what evidence says beyond that is how wide priors were taken.
void share_with_class(Cause& cause);

/// Where nothing explains the readings to their noise, one effect that leaves no more of them than is
/// tolerated is as good an explanation as can be had. So much freedom is left to it that a cause outside the
/// catalogue might do as well. Answers whether there is one.
/// \param seen    the study without the readings held out
///
/// \param chosen  what the search found there
bool accept_tolerable(const Study& study, const Study& seen, Findings chosen, Findings& findings,
                      Cause& cause);

}  // namespace plumbline::diagnose
