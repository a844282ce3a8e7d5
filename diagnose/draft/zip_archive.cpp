#include "diagnose/draft/zip_archive.hpp"

#include <zlib.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

namespace plumbline::diagnose {
namespace {

class Archive {
 public:
  Archive(const std::string& bytes, const std::string& source) : bytes_(bytes), source_(source) {}

  std::map<std::string, std::string> files() {
    std::map<std::string, std::string> all;
    // The end record stands last; a comment may follow it.
    const std::size_t end = bytes_.rfind("PK\x05\x06");
    if (end == std::string::npos) refuse("no list of its files");
    std::size_t at = number(end + 16, 4);
    for (std::size_t left = number(end + 10, 2); left > 0; --left) {
      if (bytes_.compare(at, 4, "PK\x01\x02") != 0) refuse("a damaged list of its files");
      const std::size_t name = number(at + 28, 2);
      all[part(at + 46, name)] = unpacked(at);
      at += 46 + name + number(at + 30, 2) + number(at + 32, 2);
    }
    return all;
  }

 private:
  [[noreturn]] void refuse(const std::string& found) const {
    throw Error(source_, found, "a whole zip archive");
  }

  [[nodiscard]] std::string part(std::size_t from, std::size_t size) const {
    if (from > bytes_.size() || size > bytes_.size() - from) refuse("an end in the middle");
    return bytes_.substr(from, size);
  }
  /// Little endian.
  [[nodiscard]] std::size_t number(std::size_t at, std::size_t size) const {
    std::size_t value = 0;
    const std::string digits = part(at, size);
    for (std::size_t i = size; i-- > 0;) value = value << 8U | static_cast<unsigned char>(digits[i]);
    return value;
  }

  /// \param entry  where the list has it
  std::string unpacked(std::size_t entry) {
    const std::size_t flags = number(entry + 8, 2), method = number(entry + 10, 2),
                      packed = number(entry + 20, 4), size = number(entry + 24, 4),
                      head = number(entry + 42, 4);
    constexpr std::size_t most = 256U << 20U;
    total_ += size;
    if (total_ > most) refuse("more than 256 MB");
    if ((flags & 1U) != 0) refuse("a password");
    const std::string data = part(head + 30 + number(head + 26, 2) + number(head + 28, 2), packed);
    if (method == 0) return data;
    if (method != Z_DEFLATED) refuse("a packing other than deflate");
    return inflated(data, size);
  }

  [[nodiscard]] std::string inflated(const std::string& data, std::size_t size) const {
    std::string text(size, '\0');
    z_stream stream{};
    // zlib takes no constant input, and does not change it
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
    stream.avail_in = static_cast<uInt>(data.size());
    stream.next_out = reinterpret_cast<Bytef*>(text.data());
    stream.avail_out = static_cast<uInt>(text.size());
    const bool begun = inflateInit2(&stream, -MAX_WBITS) == Z_OK;
    const bool whole = begun && inflate(&stream, Z_FINISH) == Z_STREAM_END && stream.total_out == size;
    if (begun) inflateEnd(&stream);
    if (!whole) refuse("damaged data");
    return text;
  }

  const std::string& bytes_;
  const std::string& source_;
  std::size_t total_ = 0;
};

}  // namespace

std::map<std::string, std::string> files_in_archive(const std::string& bytes, const std::string& source) {
  return Archive(bytes, source).files();
}

}  // namespace plumbline::diagnose
