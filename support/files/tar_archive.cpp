#include "support/files/tar_archive.hpp"

#include <fmt/format.h>

#include <numeric>
#include <plumbline/base/error.hpp>

namespace plumbline::files {
namespace {

constexpr std::size_t tar_block = 512, longest_name = 100;

}  // namespace

void TarArchive::add(const std::string& name, const std::string& text) {
  constexpr std::size_t largest = std::size_t{1} << 33;
  if (name.size() > longest_name || text.size() >= largest)
    throw Error("archive", name, "a name of at most 100 bytes, and less than 8 GB");
  std::string head(tar_block, '\0');
  const auto put = [&](std::size_t at, const std::string& field) { head.replace(at, field.size(), field); };
  put(0, name);
  put(100, "0000644");                       // mode
  put(108, "0000000"), put(116, "0000000");  // owner, group
  put(124, fmt::format("{:011o}", text.size()));
  put(136, "00000000000");  // time: the same bytes for the same files
  put(148, "        ");     // the sum is taken with blanks in its place
  put(156, "0");            // a plain file
  put(257, std::string("ustar\0", 6) + "00");
  const auto sum = std::accumulate(head.begin(), head.end(), 0U,
                                   [](unsigned all, char c) { return all + static_cast<unsigned char>(c); });
  put(148, fmt::format("{:06o}", sum) + std::string("\0 ", 2));
  blocks_ += head + text;
  blocks_.resize((blocks_.size() + tar_block - 1) / tar_block * tar_block, '\0');
}

std::string TarArchive::bytes() const {
  return blocks_ + std::string(2 * tar_block, '\0');
}

}  // namespace plumbline::files
