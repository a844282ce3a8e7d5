#pragma once
/// \file
/// Seals: a label is committed to before the diagnosis and shown after it.

#include <map>
#include <string>

#include "trial/label.hpp"

namespace plumbline::trial {

/// What is kept elsewhere until the diagnosis is over.
struct Envelope {
  std::string salt;   ///< hexadecimal digits that nobody can guess
  std::string label;  ///< the label's JSON, byte for byte
};

/// The salt of an experiment: who knows the secret can make it again, and nobody else.
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
