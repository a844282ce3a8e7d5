#include "trial/diagnosis_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <fstream>
#include <plumbline/base/error.hpp>
#include <thread>

#include "files/temporary_folder.hpp"

namespace plumbline::trial {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

void copy_experiment(const fs::path& from, const fs::path& to) {
  fs::create_directory(to);
  for (const auto& file : fs::directory_iterator(from))
    if (file.path().filename() == "experiment.toml" || file.path().extension() == ".csv")
      fs::copy_file(file.path(), to / file.path().filename());
}

pid_t start(const fs::path& executable, const fs::path& experiment, const fs::path& report,
            const fs::path& complaints) {
  std::array<std::string, 5> words{executable.string(), "diagnose", experiment.string(), "--json",
                                   report.string()};
  std::array<char*, 6> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, complaints.c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t process = 0;
  const int failure = posix_spawn(&process, executable.c_str(), &streams, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (failure != 0) throw Error(executable.string(), std::strerror(failure), "a program that can be started");
  return process;
}

/// How the process ended; empty when well.
std::string wait_for(pid_t process, std::chrono::duration<double> patience) {
  const auto start = Clock::now();
  int status = 0;
  while (waitpid(process, &status, WNOHANG) == 0) {
    if (Clock::now() - start > patience) {
      kill(process, SIGKILL);
      waitpid(process, &status, 0);
      return fmt::format("not done after {:g} s", patience.count());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (WIFSIGNALED(status)) return fmt::format("killed by signal {}", WTERMSIG(status));
  return WEXITSTATUS(status) == 0 ? "" : fmt::format("exit status {}", WEXITSTATUS(status));
}

}  // namespace

Diagnosed diagnose_alone(const fs::path& executable, const fs::path& experiment, const fs::path& report,
                         std::chrono::duration<double> patience) {
  const files::TemporaryFolder chamber;
  copy_experiment(experiment, chamber / "experiment");
  const auto begin = Clock::now();
  const pid_t process = start(executable, chamber / "experiment", report, chamber / "complaints");
  Diagnosed result{0, wait_for(process, patience)};
  result.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  std::string complaint;
  if (!result.failure.empty() && std::getline(std::ifstream(chamber / "complaints"), complaint))
    result.failure += ": " + complaint;
  return result;
}

}  // namespace plumbline::trial
