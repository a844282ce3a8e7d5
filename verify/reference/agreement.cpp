#include "verify/reference/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <plumbline/straight/buckling_mode.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/enclosure.hpp"
#include "verify/reference/condition.hpp"

namespace plumbline::verify {
namespace {

/// Digits of the certified force: enough to judge values of 50 digits.
constexpr int compared_digits = 60;
/// A value this close to another quantity is that quantity.
constexpr double alike_digits = 4;

double digits_of_agreement(const Rational& value, const Rational& truth) {
  const Rational error = value < truth ? Rational(truth - value) : Rational(value - truth);
  const Rational relative = error / (truth < 0 ? Rational(-truth) : truth);
  const auto rounded = from_rational<Mpfr50>(relative);
  return relative == 0 ? compared_digits
                       : std::min<double>(compared_digits, -mp::log10(rounded).convert_to<double>());
}

Rational middle(const proofs::ForceEnclosure& force) {
  return (force.low + force.high) / 2;
}

double spread(const std::vector<Rational>& values) {
  Rational low(0), high(0);
  for (const Rational& x : values) {
    if (x != 0 && (low == 0 || x < low)) low = x;
    if (x > high) high = x;
  }
  return low == 0 ? 1.0 : from_rational<double>(high / low);
}

unsigned traits_of(const Chain<Rational>& chain, const std::vector<proofs::ForceEnclosure>& forces,
                   std::size_t mode) {
  const auto& k = chain.stiffness();
  unsigned traits = 0;
  if (k[0] == 0) traits |= Trait::passive_base;
  if (std::find(k.begin() + 1, k.end(), 0) != k.end()) traits |= Trait::passive_interior;
  if (spread(chain.length()) > 1e4 || spread(k) > 1e4) traits |= Trait::graded;
  if (chain.size() > 30) traits |= Trait::long_chain;
  if (2 * mode > chain.size()) traits |= Trait::upper_half;
  const auto close = [&](std::size_t a, std::size_t b) {
    return a >= 1 && b <= forces.size() &&
           digits_of_agreement(middle(forces[a - 1]), middle(forces[b - 1])) > 2;
  };
  if (close(mode - 1, mode) || close(mode, mode + 1)) traits |= Trait::close_pair;
  return traits;
}

/// How many significant digits a decimal is written with.
int written_digits(const std::string& text) {
  const std::string mantissa = text.substr(0, text.find_first_of("eE"));
  const auto first = mantissa.find_first_of("123456789");
  if (first == std::string::npos) return 0;
  return static_cast<int>(std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                                        [](char c) { return c >= '0' && c <= '9'; }));
}

std::string finding(const SubmittedForce& submitted, const std::vector<proofs::ForceEnclosure>& forces) {
  const auto value = proofs::parse_decimal(submitted.text);
  if (!value) return "not a number";
  const Rational truth = middle(forces[submitted.mode - 1]);
  const auto alike = [&](const Rational& x) { return digits_of_agreement(*value, x) > alike_digits; };
  if (*value == 0) return "zero";
  if (alike(-truth)) return "wrong sign: compression counts as positive";
  if (alike(1 / truth) || alike(-1 / truth)) return "the eigenvalue lambda = -1 / F, not the force";
  if (*value < 0) return "negative";
  const int written = written_digits(submitted.text);
  const Rational half_unit = proofs::unit_in_digit(*value, written) / 2;
  if (written < 16 && *value - half_unit <= truth && truth <= *value + half_unit)
    return fmt::format("right as far as it is written, {} digits: print 17", written);
  for (const proofs::ForceEnclosure& other : forces) {
    if (other.index != submitted.mode && alike(middle(other)) && !alike(truth))
      return fmt::format("the force of mode {}", other.index);
  }
  for (const int factor : {2, 3, 4, 8}) {
    if (alike(truth * factor)) return fmt::format("{} times too large", factor);
    if (alike(truth / factor)) return fmt::format("{} times too small", factor);
  }
  return "rounding errors";
}

struct Suspicion {
  unsigned trait;
  const char* where;
};
constexpr Suspicion suspicions[] = {
    {Trait::passive_base,
     "chains with a passive base: k_1 = 0 needs no special case, but no division by it either"},
    {Trait::passive_interior,
     "chains with a passive joint behind the first: they fall into two parts, each with modes of its own"},
    {Trait::graded,
     "graded chains: B^-1 A and dense eigensolvers lose small eigenvalues in the rounding of large ones"},
    {Trait::long_chain, "chains of more than 30 links: rescale the recursion, or it overflows"},
    {Trait::upper_half, "the upper half of the modes: refine each force on its own"},
    {Trait::close_pair,
     "forces that lie close together: count sign changes rather than look for sign changes"},
};

}  // namespace

std::vector<ForceAgreement> compare(const std::string& name, const Chain<Rational>& chain,
                                    const std::vector<SubmittedForce>& submitted) {
  std::size_t highest = 0;
  for (const SubmittedForce& force : submitted) highest = std::max(highest, force.mode);
  const auto forces = proofs::enclose_critical_forces(chain, highest + 1, compared_digits);
  const auto precise = from_rational<Mpfr50>(chain);
  const auto modes = critical_modes(precise, highest);
  std::vector<ForceAgreement> result;
  for (const SubmittedForce& force : submitted) {
    const Rational truth = middle(forces[force.mode - 1]);
    const auto value = proofs::parse_decimal(force.text);
    const auto condition = condition_number(precise, modes[force.mode - 1]).convert_to<double>();
    const double permitted =
        -std::log10(condition * static_cast<double>(chain.size()) * std::ldexp(1.0, -52));
    result.push_back({name, force, proofs::to_decimal(truth, 20),
                      value ? std::max(0.0, digits_of_agreement(*value, truth)) : 0.0, condition, permitted,
                      "", traits_of(chain, forces, force.mode)});
    if (!result.back().agrees()) result.back().finding = finding(force, forces);
  }
  return result;
}

void sort_worst_first(std::vector<ForceAgreement>& values) {
  std::stable_sort(values.begin(), values.end(), [](const ForceAgreement& a, const ForceAgreement& b) {
    return a.digits - a.permitted < b.digits - b.permitted;
  });
}

std::vector<std::string> where_to_look(const std::vector<ForceAgreement>& values) {
  std::map<std::string, std::size_t> findings;
  for (const ForceAgreement& v : values) {
    if (!v.agrees()) ++findings[v.finding];
  }
  std::vector<std::pair<double, std::string>> lines;
  for (const auto& [finding, count] : findings) {
    if (finding != "rounding errors")
      lines.emplace_back(1.0, fmt::format("{} of {} values: {}", count, values.size(), finding));
  }
  for (const Suspicion& suspicion : suspicions) {
    double with = 0, without = 0, wrong_with = 0, wrong_without = 0;
    for (const ForceAgreement& v : values) {
      const bool has = (v.traits & suspicion.trait) != 0;
      (has ? with : without) += 1;
      if (!v.agrees()) (has ? wrong_with : wrong_without) += 1;
    }
    if (with == 0 || without == 0) continue;
    const double share = wrong_with / with, elsewhere = wrong_without / without;
    if (share > 1.5 * elsewhere && wrong_with > 1)
      lines.emplace_back(share - elsewhere, fmt::format("{} of {} here, {} of {} elsewhere: {}", wrong_with,
                                                        with, wrong_without, without, suspicion.where));
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> result;
  for (const auto& line : lines) result.push_back(line.second);
  return result;
}

}  // namespace plumbline::verify
