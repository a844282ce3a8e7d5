#include "support/files/child_process.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <plumbline/base/error.hpp>
#include <thread>

#include "support/files/temporary_folder.hpp"
#include "tests/folder.hpp"

using plumbline::Error;
using namespace plumbline::files;
namespace fs = std::filesystem;

namespace {

/// Whether it becomes true within some seconds.
template <class Condition>
bool soon(const Condition& condition) {
  for (int i = 0; i < 500 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  return condition();
}

}  // namespace

TEST_CASE("a program reads, writes, complains and ends") {
  const Ended cat = run_program({"cat"}, "text\n");
  CHECK(cat.failure.empty());
  CHECK(cat.out == "text\n");
  const Ended wrong = run_program({"cat", "/nowhere/file"}, "");
  CHECK(wrong.failure == "exit status 1");
  CHECK(wrong.err.find("/nowhere/file") != std::string::npos);
  CHECK(run_program({"sh", "-c", "kill -9 $$"}, "").failure == "killed by signal 9");
  CHECK_THROWS_WITH_AS(run_program({"no-such-program"}, ""), doctest::Contains("No such file"), Error);
}

TEST_CASE("words are words: no shell reads them") {
  CHECK(run_program({"echo", "$(id)", "'; exit 3", "a b"}, "").out == "$(id) '; exit 3 a b\n");
}

TEST_CASE("a program has our environment, and one core") {
  setenv("OMP_NUM_THREADS", "7", 1);
  setenv("OF_OUR_OWN", "a = b", 1);
  const Ended ended =
      run_program({"sh", "-c", "env | grep -c ^OMP_NUM_THREADS; echo $OMP_NUM_THREADS $OF_OUR_OWN"}, "");
  unsetenv("OMP_NUM_THREADS");
  unsetenv("OF_OUR_OWN");
  CHECK(ended.out == "1\n1 a = b\n");
}

TEST_CASE("a program that takes too long is given up") {
  CHECK(run_program({"sleep", "60"}, "", std::chrono::duration<double>(0.1)).failure ==
        "not done after 0.1 s");
  CHECK(run_program({"true"}, "", std::chrono::duration<double>(60)).failure.empty());
}

TEST_CASE("what a killed process has begun goes with it: its program and its temporary folder") {
  const Folder here;
  const pid_t other = fork();
  if (other == 0) {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "x";
    std::ofstream(here / "folder") << folder.path().string() << std::flush;
    run_program({"sh", "-c", "echo $$ > " + (here / "pid").string() + "; exec sleep 1000"}, "");
    _exit(0);
  }
  std::string folder;
  pid_t program = 0;
  REQUIRE(soon([&] {
    return (std::ifstream(here / "pid") >> program) && (std::ifstream(here / "folder") >> folder);
  }));
  CHECK(fs::exists(folder));
  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
  CHECK(soon([&] { return !fs::exists(folder); }));
  // an orphan may stay a zombie where nobody waits for it: what counts is that it has ended
  CHECK(soon([&] {
    char state = 'Z';
    std::string ignored;
    std::ifstream(fs::path("/proc") / std::to_string(program) / "stat") >> ignored >> ignored >> state;
    return state == 'Z' || state == 'X';
  }));
}

TEST_CASE("a program works in the folder that it is given") {
  const Folder here;
  here.write("file", "content\n");
  CHECK(run_program({"cat", "file"}, "", std::nullopt, here.path()).out == "content\n");
  CHECK_THROWS_AS(run_program({"cat", "file"}, "", std::nullopt, here / "nowhere"), Error);
}

TEST_CASE("without a folder for temporary files the error says so") {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  setenv("TMPDIR", "/nowhere/at/all", 1);
  CHECK_THROWS_WITH_AS(TemporaryFolder{},
                       "TMPDIR: found /nowhere/at/all, expected a folder for temporary files", Error);
  before ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
}
