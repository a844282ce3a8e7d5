#include "trial/seal.hpp"

#include "support/files/json_file.hpp"
#include "support/files/sha256.hpp"

namespace plumbline::trial {
namespace {

constexpr const char* format = "experiment-seals/1";

}  // namespace

std::string salt(const std::string& secret, const std::string& name) {
  constexpr std::size_t digits = 32;
  return files::sha256(secret + "\n" + name).substr(0, digits);
}

std::string seal(const Envelope& envelope) {
  return files::sha256(envelope.salt + "\n" + envelope.label);
}

std::string seals_text(const Seals& seals) {
  return nlohmann::ordered_json{{"format", format}, {"seals", seals}}.dump(1) + "\n";
}

Seals parse_seals(const std::string& text, const std::string& source) {
  const nlohmann::json json = files::parse_json(text, source);
  const files::JsonValue file(json, source);
  const std::string expected = std::string("an object with \"format\": \"") + format + "\" and \"seals\"";
  if (const files::JsonValue found = file.at("format", expected); found.json() != format)
    found.refuse(expected);
  Seals seals;
  for (const auto& [name, digest] : file.at("seals", expected).members("an object from names to digests"))
    seals[name] = digest.text("a digest");
  return seals;
}

std::string envelope_text(const Envelope& envelope) {
  return nlohmann::ordered_json{{"salt", envelope.salt}, {"label", envelope.label}}.dump(1) + "\n";
}

Envelope parse_envelope(const std::string& text, const std::string& source) {
  const nlohmann::json json = files::parse_json(text, source);
  const files::JsonValue file(json, source);
  const std::string expected = "an object with the strings \"salt\" and \"label\"";
  const auto value = [&](const char* key) {  // as it is, for the seal is that of every byte
    const files::JsonValue found = file.at(key, expected);
    if (!found.json().is_string()) found.refuse(expected);
    return found.json().get<std::string>();
  };
  return {value("salt"), value("label")};
}

}  // namespace plumbline::trial
