#include "support/files/output_file.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <plumbline/base/error.hpp>

#include "support/files/text_file.hpp"
#include "tests/folder.hpp"

namespace fs = std::filesystem;
using plumbline::Error;
using namespace plumbline::files;

namespace {

mode_t mode(const fs::path& path) {
  struct stat found = {};
  stat(path.c_str(), &found);
  return found.st_mode & 07777;
}

std::size_t count(const fs::path& folder) {
  const fs::directory_iterator all(folder);
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

}  // namespace

TEST_CASE("a file appears with commit, and nothing does before or without it") {
  const Folder here;
  {
    OutputFile file(here / "a");
    file.write("one ");
    file.write("two");
    file.complete();
    CHECK(count(here.path()) == 0);
    file.commit();
    CHECK(read_text(here / "a") == "one two");
  }
  {
    OutputFile file(here / "a");
    file.write("three");
    file.complete();
    CHECK(read_text(here / "a") == "one two");
  }
  CHECK(read_text(here / "a") == "one two");
  CHECK(count(here.path()) == 1);
}

TEST_CASE("a process that is killed leaves no draft") {
  const Folder here;
  here.write("a", "old");
  const pid_t other = fork();
  if (other == 0) {
    OutputFile file(here / "a");
    file.write(std::string(100000, 'x'));
    file.complete();
    raise(SIGKILL);
  }
  waitpid(other, nullptr, 0);
  CHECK(count(here.path()) == 1);
  CHECK(read_text(here / "a") == "old");
}

TEST_CASE("mode, symbolic links and further names of a file stay") {
  const Folder here;
  here.write("secret", "old");
  chmod((here / "secret").c_str(), 0600);
  write_text(here / "secret", "new");
  CHECK(mode(here / "secret") == 0600);
  CHECK(read_text(here / "secret") == "new");

  fs::create_symlink("secret", here / "link");
  write_text(here / "link", "through the link");
  CHECK(fs::is_symlink(here / "link"));
  CHECK(read_text(here / "secret") == "through the link");

  fs::create_directory(here / "sub");
  fs::create_symlink("sub/made", here / "dangling");
  write_text(here / "dangling", "made");
  CHECK(fs::is_symlink(here / "dangling"));
  CHECK(read_text(here / "sub/made") == "made");

  here.write("first", "a longer text that was there");
  fs::create_hard_link(here / "first", here / "second");
  write_text(here / "second", "both");
  CHECK(fs::equivalent(here / "first", here / "second"));
  CHECK(read_text(here / "first") == "both");
}

TEST_CASE("what cannot be written is found out before anything is") {
  const Folder here;
  fs::create_directory(here / "folder");
  fs::create_symlink("circle", here / "circle");
  mkfifo((here / "pipe").c_str(), 0600);
  for (const fs::path& path : {here / "folder", here / "missing" / "a", here / "circle", here / "pipe",
                               fs::path("/dev/full"), here / std::string(300, 'n')}) {
    CAPTURE(path.string());
    CHECK_THROWS_WITH_AS(OutputFile{path}, doctest::Contains("expected a file that can be written"), Error);
  }
  CHECK_THROWS_AS(require_folder(here / "circle" / "a"), Error);
  here.write("file", "text");
  CHECK_THROWS_AS(require_folder(here / "file"), Error);
  CHECK_NOTHROW(require_folder(here / "new" / "folders"));
  CHECK(!fs::exists(here / "new"));
}

TEST_CASE("a device takes what is written") {
  CHECK_NOTHROW(write_text("/dev/null", "text"));
}
