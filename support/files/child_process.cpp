#include "support/files/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <plumbline/base/error.hpp>
#include <string_view>

namespace plumbline::files {
namespace {

/// A file in memory that goes when it is closed.
class MemoryFile {
 public:
  explicit MemoryFile(const char* name) : number_(memfd_create(name, MFD_CLOEXEC)) {
    if (number_ < 0) throw Error(name, std::strerror(errno), "room for a program's input and output");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(number_); }

  [[nodiscard]] int number() const { return number_; }

  void fill(const std::string& text) const {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t more = write(number_, text.data() + done, text.size() - done);
      if (more < 0) throw Error("a program's input", std::strerror(errno), "room for it in memory");
      done += static_cast<std::size_t>(more);
    }
    lseek(number_, 0, SEEK_SET);
  }

  [[nodiscard]] std::string content() const {
    std::string text(static_cast<std::size_t>(lseek(number_, 0, SEEK_END)), '\0');
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t more = pread(number_, text.data() + done, text.size() - done, static_cast<off_t>(done));
      if (more <= 0) break;
      done += static_cast<std::size_t>(more);
    }
    text.resize(done);
    return text;
  }

 private:
  int number_;
};

/// Ours, in which a program has one core: those that we start share the machine.
std::vector<std::string> environment_of_programs() {
  constexpr std::string_view threads = "OMP_NUM_THREADS=";
  std::vector<std::string> all{std::string(threads) + "1"};
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (!std::string_view(*entry).starts_with(threads)) all.emplace_back(*entry);
  return all;
}

/// Pointers to texts, and the null that ends them.
std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  all.reserve(texts.size() + 1);
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// In the new process: becomes the program, or says by its status why it cannot.
[[noreturn]] void become(char* const* words, char* const* environment, const char* folder, int in, int out,
                         int err, int complain, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it died before that
  if (dup2(in, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0 &&
      chdir(folder) == 0)
    execvpe(words[0], words, environment);
  const int failure = errno;
  static_cast<void>(!write(complain, &failure, sizeof failure));
  _exit(1);
}

/// Empty when the process ended well.
std::string wait_for(pid_t process, std::optional<std::chrono::duration<double>> patience) {
  int status = 0;
  if (patience) {
    const int watch = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
    pollfd ended{watch, POLLIN, 0};
    const auto limit = std::chrono::duration_cast<std::chrono::milliseconds>(*patience).count();
    const bool late = watch >= 0 && poll(&ended, 1, static_cast<int>(std::min<long>(limit, 1000000000))) == 0;
    close(watch);
    if (late) {
      kill(process, SIGKILL);
      waitpid(process, &status, 0);
      return fmt::format("not done after {:g} s", patience->count());
    }
  }
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) return fmt::format("killed by signal {}", WTERMSIG(status));
  return WEXITSTATUS(status) == 0 ? "" : fmt::format("exit status {}", WEXITSTATUS(status));
}

}  // namespace

Ended run_program(const std::vector<std::string>& words, const std::string& input,
                  std::optional<std::chrono::duration<double>> patience,
                  const std::filesystem::path& folder) {
  const MemoryFile in("input"), out("output"), err("complaints");
  in.fill(input);
  std::vector<std::string> own_words = words, own_environment = environment_of_programs();
  const std::vector<char*> arguments = pointers(own_words), environment = pointers(own_environment);
  std::array<int, 2> complaint{};
  if (pipe2(complaint.data(), O_CLOEXEC) != 0) throw Error(words[0], std::strerror(errno), "a pipe");
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process == 0)
    become(arguments.data(), environment.data(), folder.c_str(), in.number(), out.number(), err.number(),
           complaint[1], parent);
  int failure = process < 0 ? errno : 0;
  close(complaint[1]);
  if (process > 0 && read(complaint[0], &failure, sizeof failure) > 0) waitpid(process, nullptr, 0);
  close(complaint[0]);
  if (failure != 0) throw Error(words[0], std::strerror(failure), "a program that can be started");
  Ended ended{wait_for(process, patience), "", ""};
  ended.out = out.content();
  ended.err = err.content();
  return ended;
}

}  // namespace plumbline::files
