#include "verify/claims/sign_of_force.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/chain/linearised.hpp>
#include <plumbline/straight/critical_force.hpp>
#include <regex>

#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/exact_matrix.hpp"
#include "proofs/exact/expression.hpp"
#include "verify/chains/straight_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/paper/paper.hpp"
#include "verify/sampled/algorithm1_instances.hpp"

namespace plumbline::verify {
namespace {

/// Where a sign is printed: the claim that has it, the entry of its print and the term there; `sense` is -1
/// where the joint angle of the term is itself negative.
struct Place {
  const char *name, *claim;
  std::size_t entry;
  const char* term;
  int sense;
};

const Place places[] = {
    {"(6)", "eq-6", 1, "k*q1", 1},
    {"(14)", "eq-14", 1, "k*phi", -1},  // q_1 = -phi
    {"(16)", "eq-16", 0, "k/L", 1},
    {"(18)", "eq-18", 1, "k*3*phi", -1},  // q_1 = -3 phi
    {"(20)", "eq-20", 0, "3*k/L", 1},
    {"(24)", "eq-24", 0, "k1*q1", 1},
    {"(29)", "eq-29", 0, "K*q", 1},
    {"(33)", "eq-31-33", 5, "K", 1},
    {"(34)", "eq-34", 0, "1/Fx", 1},
    {"(35)", "eq-35-force", 0, "1/lambda", 1},
    {"Table 2", "table-2-row-1", 0, "1.0822", 1},
    {"(36)", "eq-36", 0, "1/max|lambda|", 1},
    {"Table 3", "table-3-forces", 0, "0.9240", 1},
    {"step 4", "algorithm-1-step-4", 0, "1/max|lambda|", 1},
};

/// The sign of the non-zero eigenvalues of B^-1 A, unit chain of four links, with a sign of K in B.
int sign_of_eigenvalues(int sign_of_K) {
  const Matrix<Rational> A = matrix_A(four_link_chain());
  Matrix<Rational> B = matrix_B(four_link_chain());
  for (Eigen::Index i = 0; i < 4; ++i) B(i, i) *= sign_of_K;
  const proofs::Polynomial chi = proofs::pencil_determinant(-A, B);  // det(lambda B - A)
  const std::size_t positive = proofs::distinct_positive_roots(chi),
                    negative = proofs::distinct_negative_roots(chi);
  if ((positive > 0) == (negative > 0)) throw Error("eigenvalues", "both signs or none", "one sign");
  return positive > 0 ? 1 : -1;
}

bool agree(const Signs& s) {
  static const int with_plus = sign_of_eigenvalues(1), with_minus = sign_of_eigenvalues(-1);
  const int lambda = s.at("(33)") > 0 ? with_plus : with_minus;
  const int force = s.at("(35)") * lambda;
  return s.at("(6)") == s.at("(14)") && s.at("(6)") == s.at("(18)") &&    // J^T F + M = 0, one M
         s.at("(16)") == s.at("(14)") && s.at("(20)") == s.at("(18)") &&  // their solutions
         s.at("(24)") == s.at("(6)") &&                                   // (22) is (6)
         s.at("(29)") == s.at("(24)") && s.at("(33)") == s.at("(29)") &&  // (22) to first order
         s.at("(34)") == -1 && s.at("(35)") == -1 &&                      // A F_x + B = 0
         s.at("Table 2") == lambda && s.at("Table 3") == force && s.at("(16)") == force &&
         s.at("(36)") == force && s.at("step 4") == force;
}

/// Algorithm 1, run as written in a floating type, against a certified force.
/// \throws Error when they
/// disagree
template <Floating Real>
std::string algorithm1_against(const Chain<Rational>& exact, const Interval& certified) {
  using std::abs;
  const Chain<Real> chain = from_rational<Real>(exact);
  const Real F = algorithm1(chain).front().force;
  const Matrix<double> B = matrix_B(from_rational<double>(exact));
  // backward errors of the elimination and of the QR iteration, each bounded by size^3 epsilon times the
  // condition of B
  const auto size = static_cast<double>(B.rows());
  const double condition = B.norm() * B.inverse().norm();
  const Real bound = Real(size * size * size * condition) * epsilon<Real>();
  const Real reference(certified.middle());
  const Real deviation = abs(F - reference) / reference;
  if (!(deviation < bound))
    throw Error("Algorithm 1", "number types that disagree", "agreement within rounding");
  return fmt::format(
      "Algorithm 1 as written gives 1/max|lambda| within {:.1e} of the certified value, relatively",
      static_cast<double>(deviation));
}

/// "-1/max|lambda|", over the eigenvalues, as the lowest force of the unit chain of
/// four links, at a place of the paper.
Judgement lowest_force_at(const std::string& place, const Printed& printed, const Premises& given,
                          int digits) {
  const Chain<Rational> chain = given.exact_chain("unit-chain");
  static const std::regex form(R"(([+-]?)(\d+)/(max|min)\|lambda\|)");
  std::smatch parts;
  const std::string text = printed.at(0);
  if (!std::regex_match(text, parts, form))
    throw Error("claim", "'" + text + "'", "-1/max|lambda| or the like");
  const auto forces = proofs::enclose_critical_forces(chain, chain.size() - 1, 60);
  const auto enclosed = [](const proofs::ForceEnclosure& force) {
    return hull(Interval(force.low), Interval(force.high));
  };
  const Interval lowest = enclosed(forces.front());
  // the largest |lambda| = 1/F belongs to the lowest force
  const Interval stated =
      Interval(std::stoi(parts[2])) * (parts[3] == "max" ? lowest : enclosed(forces.back()));
  const bool size = !certainly_less(stated, lowest) && !certainly_less(lowest, stated);
  Signs signs = printed_signs();
  signs[place] = parts[1] == "-" ? -1 : 1;
  Judgement result = judge_place(place, signs);
  if (!size) result.verdict = Verdict::refuted;
  if (result.verdict != Verdict::confirmed)
    result.truth =
        "F_x^0 = +1/max|lambda_i|: every non-zero lambda_i is negative, so that (35) makes every force "
        "positive, "
        "the lowest of the example " +
        certified_decimal(lowest, 4);
  result.evidence.insert(result.evidence.begin(),
                         Evidence::by_checked_theorem("Definiteness", {"eigenvalues.eigenvalues"},
                                                      "all n - 1 forces -1/lambda_i are positive"));
  result.evidence.push_back({EvidenceKind::interval, "F_x^0 bounded by exact counts: " + lowest.text(20)});
  result.evidence.push_back({EvidenceKind::mp50, algorithm1_against<Mpfr50>(chain, lowest)});
  result.evidence.push_back({EvidenceKind::real64, algorithm1_against<double>(chain, lowest)});
  result.value = certified_decimal(lowest, digits);
  return result;
}

Judgement force_of_36(const Printed& printed, const Premises& given, int digits) {
  return lowest_force_at("(36)", printed, given, digits);
}
Judgement force_of_step_4(const Printed& printed, const Premises& given, int digits) {
  return lowest_force_at("step 4", printed, given, digits);
}

/// What there is to choose between: "; all signs agree with those of (24), (36) turned, …".
std::string ways_to_agree(const Signs& signs) {
  std::string text;
  for (const auto& set : corrections(signs)) {
    Signs turned = signs;
    for (const std::string& place : set) turned[place] *= -1;
    text += fmt::format("{} of {} turned, F_x being {} in compression",
                        text.empty() ? ". All signs agree with those" : "; or with those",
                        fmt::join(set, ", "), turned.at("Table 3") > 0 ? "positive" : "negative");
  }
  return text;
}

/// (24): each entry ±k_i q_i, all with one sign.
Judgement torques(const Printed& printed, int) {
  const proofs::Formulas formulas({"k1", "k2", "k3", "k4", "q1", "q2", "q3", "q4"});
  if (printed.size() != 4) throw Error("claim", fmt::format("{} torques", printed.size()), "4");
  const int sign = printed[0].starts_with('-') ? -1 : 1;
  bool springs = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const GiNaC::ex spring =
        sign * formulas.symbol(fmt::format("k{}", i + 1)) * formulas.symbol(fmt::format("q{}", i + 1));
    springs = springs && proofs::identical(formulas.parse(printed[i]), spring);
  }
  Signs signs = printed_signs();
  signs["(24)"] = sign;
  Judgement result = judge_place("(24)", signs);
  if (!springs) result.verdict = Verdict::refuted;
  if (result.verdict != Verdict::confirmed)
    result.truth = "M = +(k_1 q_1, …, k_n q_n), as in (6) and (29)" + ways_to_agree(signs);
  return result;
}

Judgement torques_of_2(const Printed& printed, int) {
  if (printed.at(0) != "+" && printed.at(0) != "-") throw Error("claim", printed.at(0), "+ or -");
  Signs signs = printed_signs();
  for (const char* place : {"(6)", "(14)", "(18)"}) signs[place] = printed.at(0) == "-" ? -1 : 1;
  Judgement result = judge_place("(6)", signs);
  if (result.verdict != Verdict::confirmed)
    result.truth = "with J^T F + M = 0 and F_x positive in compression the torques are M = +K q";
  return result;
}

}  // namespace

int sign_before(const std::string& term, const std::string& formula) {
  const std::size_t at = formula.find(term);
  if (at == std::string::npos) throw Error("claim", "'" + formula + "'", "a formula with " + term);
  return at > 0 && formula[at - 1] == '-' ? -1 : 1;
}

Signs printed_signs() {
  static const Signs instance = [] {
    Signs signs;
    for (const Place& place : places)
      signs[place.name] =
          place.sense * sign_before(place.term, printed_in_paper(place.claim).at(place.entry));
    return signs;
  }();
  return instance;
}

std::vector<std::set<std::string>> corrections(const Signs& printed) {
  std::vector<std::string> names;
  for (const auto& [name, sign] : printed) names.push_back(name);
  std::vector<std::set<std::string>> found;
  for (unsigned set = 0; set < 1U << names.size(); ++set) {
    Signs turned = printed;
    std::set<std::string> chosen;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if ((set >> i & 1U) == 0) continue;
      turned[names[i]] *= -1;
      chosen.insert(names[i]);
    }
    if (agree(turned)) found.push_back(std::move(chosen));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return found;
}

Judgement judge_place(const std::string& place, const Signs& signs) {
  auto smallest = corrections(signs);
  std::erase_if(smallest, [size = smallest.empty() ? 0 : smallest.front().size()](const auto& set) {
    return set.size() > size;
  });
  const auto turned = std::count_if(smallest.begin(), smallest.end(),
                                    [&](const std::set<std::string>& set) { return set.contains(place); });
  std::vector<std::string> sets;
  for (const auto& set : smallest) sets.push_back(fmt::format("{}", fmt::join(set, ", ")));
  return {turned == 0                                           ? Verdict::confirmed
          : static_cast<std::size_t>(turned) == smallest.size() ? Verdict::refuted
                                                                : Verdict::convention,
          turned == 0 ? "" : "the sign is to be turned",
          {{EvidenceKind::exact,
            fmt::format(
                "of the {} sets of signs that can be turned in (6), (14), (16), (18), (20), (24), (29), "
                "(33) to (36), step 4, Tables 2 and 3, the smallest under which all agree: {}",
                1U << signs.size(), sets.empty() ? "none" : fmt::format("{}", fmt::join(sets, "; or ")))}},
          ""};
}

Checks claims::sign_of_force() {
  return {
      {"torque-sign", torques_of_2},
      {"eq-24", torques},
      {"eq-36", force_of_36},
      {"algorithm-1-step-4", force_of_step_4},
  };
}

}  // namespace plumbline::verify
