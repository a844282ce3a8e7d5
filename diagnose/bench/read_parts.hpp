#pragma once
/// \file
/// The key `samples` of a run: one file, or several parts.

#include <functional>
#include <string>
#include <vector>

#include "diagnose/bench/sample_columns.hpp"
#include "diagnose/bench/section.hpp"

namespace plumbline::diagnose {

/// A sample file.
struct NamedText {
  std::string source;  ///< as errors name it
  std::string text;
};

/// Reads a file that a key names.
/// \throws Error at the place of the name, or that names the file
using ReadText = std::function<NamedText(const std::string& name, const std::string& place)>;

/// The parts of a run: a file name, or a list of names and tables `{ file = …, csv = …, columns = … }`.
/// \param format  that the experiment and the run declare; each part says what differs in its file
/// \throws Error that names the key, or file and line
std::vector<SamplePart> read_parts(const Section& run, const SampleFormat& format, const ReadText& read);

}  // namespace plumbline::diagnose
