#include "proofs/coq/machine_checked.hpp"

#include <array>

namespace plumbline::proofs {
namespace {

#ifdef PLUMBLINE_COQ
#include "checked.inc"
#else
constexpr std::string_view version;
constexpr std::array<std::string_view, 0> theorems{};
#endif

}  // namespace

std::string_view coq_version() {
  return version;
}

std::span<const std::string_view> machine_checked() {
  return theorems;
}

}  // namespace plumbline::proofs
