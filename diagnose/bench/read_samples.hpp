#pragma once
/// \file
/// Reads the samples of one run.

#include <string>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/sample_table.hpp"

namespace plumbline::diagnose {

/// The contents of a sample file.
struct Samples {
  std::vector<Reading> readings;  ///< in SI; an empty measured field is NaN
  std::vector<Origin> origins;    ///< of each channel
};

/// Time, the imposed channels and commanded joint angles may not be empty.
/// \param source  of the table, named in errors with the line
/// \param format  for n joints
/// \throws Error that names the source and the line
Samples read_samples(const SampleTable& table, const std::string& source, Control control,
                     const SampleFormat& format);

}  // namespace plumbline::diagnose
