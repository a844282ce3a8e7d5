#pragma once
/// \file
/// A cause in part: effects that belong to every probable explanation, beside something that the catalogue
/// does not have; and causes that are named, but leave what noise does not explain.

#include <optional>

#include "diagnose/answers/cause.hpp"
#include "diagnose/decision/shrink.hpp"

namespace plumbline::diagnose {

/// A partial cause, one of these, and how far the first shrinks the gap by itself.
struct InPart {
  std::vector<RankedCause> causes;
  Rest rest;
  std::optional<Shrink> shrink;
};

/// Where the cause is unknown: the effects of which one is surely part of it, whichever else acts
/// (Posterior::surely_part). Beside a smooth function of the command one of them, which is named first, has
/// to predict surely more of readings that its fit has not seen than that function alone.
std::optional<InPart> in_part(const Study& study, const Findings& findings, const Posterior& posterior,
                              const NoiseEstimate& noise);

/// What the only cause that is named leaves, where that is more than noise: more of readings that its fit has
/// not seen, a scatter of many times the declared noise, or what the end of a parameter's range keeps it
/// from.
/// \param shrink  of the cause
std::optional<Rest> rest_of(const RankedCause& cause, const NoiseEstimate& noise,
                            const std::optional<Shrink>& shrink, double nominal_chi2);

}  // namespace plumbline::diagnose
