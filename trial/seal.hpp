#pragma once
/// \file
/// Seals: commitments to labels before the diagnosis.

#include <map>
#include <string>

#include "trial/label.hpp"

namespace plumbline::trial {

/// A label with its salt, kept until the diagnosis is over.
struct Envelope {
  std::string salt;   ///< unpredictable hexadecimal digits
  std::string label;  ///< the label's JSON, byte for byte
};

/// The salt of an experiment, a function of a secret and its name.
std::string salt(const std::string& secret, const std::string& name);

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
