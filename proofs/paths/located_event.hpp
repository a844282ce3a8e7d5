#pragma once
/// \file
/// Where the events of a branch lie, to fifty digits and more.

#include <plumbline/base/interval.hpp>
#include <plumbline/branch/trace.hpp>

template <>
struct Eigen::NumTraits<plumbline::Interval::End> : plumbline::EigenScalar<plumbline::Interval::End> {};

namespace plumbline::proofs {

/// 64 digits: enough to say 50 of a point that Newton's method has located.
using Located = Interval::End;

/// Digits of a located event that are beyond doubt.
inline constexpr int located_digits = 50;

/// The events of a branch that was followed in double precision, in the same order.
/// \param chain, loading  what the branch was followed with, to 64 digits
/// \throws Error where an event does not stand up to the higher precision
std::vector<BranchEvent<Located>> locate_events(const Chain<Located>& chain, const Loading<Located>& loading,
                                                const Branch<double>& branch);

/// The point of a branch at a load between those of two of its points, to 64 digits.
BranchPoint<Located> locate_at(const Chain<Located>& chain, const Loading<Located>& loading,
                               const BranchPoint<double>& near, const Located& load);

}  // namespace plumbline::proofs
