#pragma once
/// \file
/// An unknown torque at a joint: what stands for a cause that the catalogue does not have.

#include <memory>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// The id of the rows.
inline constexpr const char* unknown_torque = "unknown_torque";

/// Rows of a torque of one joint that is a smooth function of its deflection, nothing at rest: a Gaussian
/// process of covariance Matern 5/2, small and large, over the deflections of the nominal model and some way
/// beyond. Its parameters are the coordinates of the process along its principal components, each of variance
/// one.
std::shared_ptr<const std::vector<Effect>> unknown_torques(const Study& study);

/// The torques of a row at its knots, at these parameters. \param joint  from 0
std::vector<FreeLaw::Knot> knots_of(const Effect& row, std::size_t joint, const Study& study,
                                    const std::vector<double>& parameters);

}  // namespace plumbline::diagnose
