#pragma once
/// \file
/// The readings of one run.

#include <string>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The readings of CSV text with the header t,x,y,Fx,Fy and, where joint angles are measured, q1,…,qn.
/// An empty measured field is NaN; time and the imposed channels may not be empty.
/// \param joints  n
/// \throws Error that names the source and the line
std::vector<Reading> parse_samples(const std::string& text, const std::string& source, Control control,
                                   std::size_t joints);

}  // namespace plumbline::diagnose
