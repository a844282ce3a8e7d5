#pragma once
/// \file
/// Tables that benchmarks put between their markers in the documents.

#include <fmt/format.h>

#include <fstream>
#include <plumbline/base/error.hpp>
#include <sstream>
#include <string>

namespace plumbline::bench {

/// Replaces what stands between "<!-- NAME:begin -->" and "<!-- NAME:end -->".
/// \throws Error without markers
inline void put_into(const std::string& file, const std::string& name, const std::string& table) {
  const std::string begin = "<!-- " + name + ":begin -->\n", end = "<!-- " + name + ":end -->\n";
  std::ostringstream old;
  old << std::ifstream(file).rdbuf();
  std::string text = old.str();
  const std::size_t from = text.find(begin), to = text.find(end);
  if (from == std::string::npos || to == std::string::npos)
    throw Error(file, "no markers", begin + "... " + end);
  text.replace(from + begin.size(), to - from - begin.size(), table);
  std::ofstream(file) << text;
}

inline std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

inline std::string in_units(double seconds) {
  if (seconds < 1e-6) return fmt::format("{:.0f} ns", seconds * 1e9);
  if (seconds < 1e-3) return fmt::format("{:.3g} µs", seconds * 1e6);
  if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

}  // namespace plumbline::bench
