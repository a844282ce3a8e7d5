#include "files/sha256.hpp"

#include <fmt/format.h>
#include <openssl/sha.h>

#include <array>

namespace plumbline::files {

std::string sha256(const std::string& text) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace plumbline::files
