#include "support/files/sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <memory>
#include <plumbline/base/error.hpp>

#include "support/files/text_file.hpp"

namespace plumbline::files {
namespace {

class Digest {
 public:
  Digest() { EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr); }
  void add(const std::string& text) { EVP_DigestUpdate(context_.get(), text.data(), text.size()); }
  [[nodiscard]] std::string digits() const {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned int size = 0;
    EVP_DigestFinal_ex(context_.get(), bytes.data(), &size);
    return fmt::format("{:02x}", fmt::join(bytes.begin(), bytes.begin() + size, ""));
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

}  // namespace

std::string sha256(const std::string& text) {
  Digest digest;
  digest.add(text);
  return digest.digits();
}

std::string sha256(const std::vector<std::filesystem::path>& files) {
  Digest digest;
  for (const std::filesystem::path& file : files) {
    try {
      digest.add(read_text(file));
    } catch (const Error&) {
      continue;
    }
  }
  return digest.digits();
}

}  // namespace plumbline::files
