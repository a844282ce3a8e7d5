#pragma once
/// \file
/// Reading one sample file of an experiment.

#include <filesystem>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The readings of a CSV file with the header t,x,y,Fx,Fy and, where joint angles are measured, q1,…,qn.
/// An empty measured field is NaN; time and the imposed channels may not be empty.
/// \param joints  n
/// \throws Error that names the file and the line
std::vector<Reading> read_samples(const std::filesystem::path& file, Control control, std::size_t joints);

}  // namespace plumbline::diagnose
