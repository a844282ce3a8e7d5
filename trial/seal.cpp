#include "trial/seal.hpp"

#include <fmt/format.h>
#include <openssl/rand.h>

#include <array>
#include <plumbline/base/error.hpp>

#include "files/json_file.hpp"
#include "files/sha256.hpp"
#include "files/text_file.hpp"

namespace plumbline::trial {
namespace {

constexpr const char* format = "experiment-seals/1";

nlohmann::json json_in(const std::filesystem::path& path) {
  return files::parse_json(files::read_text(path), path.string());
}

}  // namespace

Envelope envelope(const Label& label) {
  std::array<unsigned char, 16> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw Error("salt", "no random numbers from the system", "some");
  return {fmt::format("{:02x}", fmt::join(bytes, "")), as_json(label).dump()};
}

std::string seal(const Envelope& envelope) {
  return files::sha256(envelope.salt + "\n" + envelope.label);
}

std::string seals_text(const Seals& seals) {
  return nlohmann::ordered_json{{"format", format}, {"seals", seals}}.dump(1) + "\n";
}

Seals read_seals(const std::filesystem::path& path) {
  const nlohmann::json file = json_in(path);
  if (!file.is_object() || file.value("format", "") != format || !file.contains("seals"))
    throw Error(path.string(), "no seals",
                std::string("an object with \"format\": \"") + format + "\" and \"seals\"");
  try {
    return file["seals"].get<Seals>();
  } catch (const nlohmann::json::exception&) {
    throw Error(path.string() + ", key seals", "something else", "an object from names to digests");
  }
}

std::string envelope_text(const Envelope& envelope) {
  return nlohmann::ordered_json{{"salt", envelope.salt}, {"label", envelope.label}}.dump(1) + "\n";
}

Envelope read_envelope(const std::filesystem::path& path) {
  const nlohmann::json file = json_in(path);
  try {
    return {file.at("salt"), file.at("label")};
  } catch (const nlohmann::json::exception& error) {
    throw Error(path.string(), error.what(), "an object with the strings \"salt\" and \"label\"");
  }
}

}  // namespace plumbline::trial
