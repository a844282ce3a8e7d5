#include "support/files/tar_archive.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <plumbline/base/error.hpp>

#include "support/files/text_file.hpp"
#include "tests/folder.hpp"

using namespace plumbline;
using files::TarArchive;

TEST_CASE("an archive is opened by tar, and holds what was put into it") {
  const Folder here;
  TarArchive archive;
  // a block holds 512 bytes: none, less, one exactly, more
  const std::size_t sizes[] = {0, 1, 512, 513};
  for (const std::size_t size : sizes) archive.add("lab/" + std::to_string(size), std::string(size, 'x'));
  here.write("lab.tar", archive.bytes());
  CHECK(archive.bytes().size() == 512 * (4 + 1 + 1 + 2 + 2));  // heads, texts, the end
  REQUIRE(std::system(("tar --extract --file='" + (here / "lab.tar").string() + "' --directory='" +
                       here.path().string() + "'")
                          .c_str()) == 0);
  for (const std::size_t size : sizes) {
    const auto file = here / ("lab/" + std::to_string(size));
    CHECK(std::filesystem::file_size(file) == size);
    if (size > 0) CHECK(files::read_text(file) == std::string(size, 'x'));
  }
}

TEST_CASE("a name that the format has no room for is refused") {
  TarArchive archive;
  CHECK_NOTHROW(archive.add(std::string(100, 'n'), ""));
  CHECK_THROWS_AS(archive.add(std::string(101, 'n'), ""), Error);
  CHECK(archive.bytes().size() == 512 * (1 + 2));
}
