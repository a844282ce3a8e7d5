#pragma once
/// \file
/// Seals: a label is committed to before the diagnosis and shown after it.

#include <map>
#include <string>

#include "trial/label.hpp"

namespace plumbline::trial {

/// What is kept elsewhere until the diagnosis is over.
struct Envelope {
  std::string salt;   ///< 32 hexadecimal digits that nobody can guess
  std::string label;  ///< the label's JSON, byte for byte
};

/// An envelope around a label, with a new salt from the operating system's generator.
/// \throws Error when that fails
Envelope envelope(const Label& label);

/// The seal of an envelope: SHA-256 of salt, line feed, label, as 64 hexadecimal digits.
std::string seal(const Envelope& envelope);

/// Seals by the name of the experiment.
using Seals = std::map<std::string, std::string>;

/// The seals as a file, and back. The published digest of a trial is the SHA-256 of this text.
std::string seals_text(const Seals& seals);
/// \throws Error that names the source, for what is not such a file
Seals parse_seals(const std::string& text, const std::string& source);

/// An envelope as a file, and back.
std::string envelope_text(const Envelope& envelope);
/// \throws Error that names the source, for what is not such a file
Envelope parse_envelope(const std::string& text, const std::string& source);

}  // namespace plumbline::trial
