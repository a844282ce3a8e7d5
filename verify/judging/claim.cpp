#include "verify/judging/claim.hpp"

#include <array>

namespace plumbline::verify {

std::string_view name(Verdict verdict) {
  static constexpr std::array<std::string_view, 4> names{"confirmed", "refuted", "imprecise", "convention"};
  return names.at(static_cast<std::size_t>(verdict));
}

std::string_view name(EvidenceKind kind) {
  static constexpr std::array<std::string_view, 7> names{"theorem", "symbolic", "exact",  "interval",
                                                         "mp50",    "double",   "sampled"};
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace plumbline::verify
