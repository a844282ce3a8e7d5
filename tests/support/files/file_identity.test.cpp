#include "support/files/file_identity.hpp"

#include <doctest/doctest.h>

#include "tests/folder.hpp"

using namespace plumbline::files;
namespace fs = std::filesystem;

TEST_CASE("a file is the same by every name, and no other is") {
  const Folder here;
  here.write("file", "x");
  here.write("other", "x");
  fs::create_symlink("file", here / "link");
  fs::create_hard_link(here / "file", here / "twin");
  for (const char* name : {"link", "twin", "./file"}) CHECK(identity(here / name) == identity(here / "file"));
  CHECK(identity(here / "other") != identity(here / "file"));
}

TEST_CASE("a file that is yet to be made is known by its folder and name") {
  const Folder here;
  fs::create_symlink("new", here / "link");
  CHECK(identity(here / "link") == identity(here / "new"));
  CHECK(identity(here / "./new") == identity(here / "new"));
  CHECK(identity(here / "new") != identity(here / "newer"));
  CHECK(identity(here / "nowhere/new") != identity(here / "nowhere/newer"));
  CHECK(identity("new") == identity("./new"));
}

TEST_CASE("links in a circle lead to the path itself") {
  const Folder here;
  fs::create_symlink("b", here / "a");
  fs::create_symlink("a", here / "b");
  CHECK(behind_links(here / "a") == here / "a");
  fs::create_symlink(here / "b", here / "absolute");
  CHECK(behind_links(here / "absolute") == here / "absolute");
}

TEST_CASE("standard output has several names") {
  for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
    CHECK(is_standard_output(name));
  CHECK_FALSE(is_standard_output("out"));
  CHECK(identity("-") == identity("/dev/stdout"));
}
