#include "app/terminal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "support/work/ranks.hpp"

namespace plumbline::app {
namespace {

std::size_t columns_of(int stream) {
  constexpr std::size_t usual = 80;
  winsize size{};
  if (isatty(stream) == 0) return 0;
  return ioctl(stream, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

}  // namespace

std::size_t terminal_columns(int stream) {
  if (!work::launched()) return columns_of(stream);
  const int behind = open(fmt::format("/proc/{}/fd/{}", getppid(), stream).c_str(),
                          O_WRONLY | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  if (behind < 0) return 0;
  const std::size_t columns = columns_of(behind);
  close(behind);
  return columns;
}

}  // namespace plumbline::app
