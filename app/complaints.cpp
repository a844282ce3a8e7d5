#include "app/complaints.hpp"

#include <fmt/core.h>

#include "support/files/printable.hpp"

namespace plumbline::app {

void complain(const std::string& text) {
  fmt::print(stderr, "plumbline: {}\n", files::printable(text));
}

void complain(const std::vector<std::string>& errors) {
  constexpr std::size_t most = 50;
  for (std::size_t i = 0; i < errors.size() && i < most; ++i) complain(errors[i]);
  if (errors.size() > most) complain(fmt::format("... and {} more like these", errors.size() - most));
}

}  // namespace plumbline::app
