#pragma once
/// \file
/// What the benchmarks are held to, and whether it was reached.

#include <fmt/format.h>

#include <string>
#include <vector>

namespace plumbline::bench {

struct Bar {
  std::string what;
  double limit, measured;
  bool at_least;  ///< or at most

  [[nodiscard]] bool met() const { return at_least ? measured >= limit : measured <= limit; }
};

inline std::string table_of(const std::vector<Bar>& bars) {
  std::string text = "| what | bar | measured | met |\n|---|--:|--:|---|\n";
  for (const Bar& bar : bars) {
    text += fmt::format("| {} | {} {:.3g} | {:.3g} | {} |\n", bar.what, bar.at_least ? "≥" : "≤", bar.limit,
                        bar.measured, bar.met() ? "yes" : "no");
  }
  return text;
}

}  // namespace plumbline::bench
