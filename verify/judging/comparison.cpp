#include "verify/judging/comparison.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <set>
#include <sstream>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exactly.hpp"
#include "verify/judging/formula_value.hpp"
#include "verify/judging/notation.hpp"

namespace plumbline::verify {
namespace {

void require_count(std::size_t printed, std::size_t computed) {
  if (printed != computed) {
    throw Error("claim", fmt::format("{} printed entries", printed), fmt::format("{}", computed));
  }
}

int places_behind_point(const std::string& decimal) {
  const std::size_t point = decimal.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(decimal.size() - point - 1);
}

std::string certified_fixed(const Interval& value, int places) {
  const std::string low = proofs::to_fixed(proofs::exactly(value.lower()), places);
  if (low != proofs::to_fixed(proofs::exactly(value.upper()), places)) {
    throw Error("enclosure", value.text(10), fmt::format("narrow enough for {} places", places));
  }
  return low;
}

/// Whether the printed number is within a unit of its last place of every value of the enclosure.
bool within_a_unit(const Rational& printed, const Interval& value, int places) {
  Rational unit = 1;
  for (int i = 0; i < places; ++i) unit /= 10;
  const Interval error = Interval(printed) - value;
  return certainly_less(error, Interval(unit)) && certainly_less(-error, Interval(unit));
}

}  // namespace

Verdict worst(Verdict a, Verdict b) {
  for (const Verdict v : {Verdict::refuted, Verdict::imprecise, Verdict::convention}) {
    if (a == v || b == v) return v;
  }
  return Verdict::confirmed;
}

namespace {

void collect_symbols(const GiNaC::ex& e, std::set<std::string>& names) {
  if (GiNaC::is_a<GiNaC::symbol>(e)) names.insert(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
  for (std::size_t i = 0; i < e.nops(); ++i) collect_symbols(e.op(i), names);
}

/// Values of two expressions at some points, where both have one.
std::vector<std::pair<Interval, Interval>> at_points(const GiNaC::ex& a, const GiNaC::ex& b) {
  std::set<std::string> names;
  collect_symbols(a, names);
  collect_symbols(b, names);
  std::vector<std::pair<Interval, Interval>> pairs;
  constexpr int points = 6;
  for (int point = 1; point <= points; ++point) {
    Values values;
    int place = 0;
    for (const std::string& name : names) {
      ++place;
      values[name] = Interval(Rational(7 * place + 5 * point, 31 + 2 * place));
    }
    try {
      pairs.emplace_back(value_of(a, values), value_of(b, values));
    } catch (const Error&) {  // no value there
    }
  }
  return pairs;
}

/// Whether two expressions are certainly no equal ones: their values differ at a point.
bool certainly_different(const GiNaC::ex& a, const GiNaC::ex& b) {
  const auto pairs = at_points(a, b);
  return std::any_of(pairs.begin(), pairs.end(), [](const auto& pair) {
    return certainly_less(pair.first, pair.second) || certainly_less(pair.second, pair.first);
  });
}

/// Whether two expressions certainly have no constant ratio other than zero: it differs between two points,
/// or one of them is zero where the other is not.
bool certainly_disproportional(const GiNaC::ex& a, const GiNaC::ex& b) {
  const auto pairs = at_points(a, b);
  const auto nonzero = [](const Interval& x) { return certainly_positive(x) || certainly_negative(x); };
  for (const auto& [x, y] : pairs) {
    for (const auto& [u, v] : pairs)
      if (nonzero(x * v - u * y)) return true;
  }
  const bool a_zero = a.is_zero(), b_zero = b.is_zero();
  return a_zero != b_zero && std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
           return nonzero(a_zero ? pair.second : pair.first);
         });
}

/// Printed against computed, entry by entry; the truth of each that is certainly not `alike`.
/// \throws Error where neither is decided
template <class Alike, class Unlike>
Judgement judge_entries(const proofs::Formulas& formulas, const Printed& printed,
                        const std::vector<GiNaC::ex>& computed, const std::vector<std::string>& names,
                        const std::string& how, const Alike& alike, const Unlike& unlike) {
  require_count(printed.size(), computed.size());
  Judgement result{Verdict::confirmed, "", {{EvidenceKind::symbolic, how}}, ""};
  std::vector<std::string> truths;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const GiNaC::ex stated = formulas.parse(printed[i]);
    if (alike(stated, computed[i])) continue;
    if (!unlike(stated, computed[i]))
      throw Error("claim", "'" + printed[i] + "', of which " + names[i] + " is neither proved nor told apart",
                  "a formula that algebra or a value decides");
    result.verdict = Verdict::refuted;
    truths.push_back(fmt::format("{} = {}, not {}", names[i], formula_in_print(proofs::text(computed[i])),
                                 formula_in_print(printed[i])));
  }
  result.truth = fmt::format("{}", fmt::join(truths, "; "));
  return result;
}

}  // namespace

Judgement judge_formulas(const proofs::Formulas& formulas, const Printed& printed,
                         const std::vector<GiNaC::ex>& computed, const std::vector<std::string>& names,
                         const std::string& how) {
  return judge_entries(formulas, printed, computed, names, how, proofs::identical, certainly_different);
}

Judgement judge_equations(const proofs::Formulas& formulas, const Printed& printed,
                          const std::vector<GiNaC::ex>& computed, const std::vector<std::string>& names,
                          const std::string& how) {
  return judge_entries(formulas, printed, computed, names, how, proofs::proportional,
                       certainly_disproportional);
}

Judgement judge_word(const std::string& printed, const std::string& computed, const std::string& truth,
                     std::vector<Evidence> evidence) {
  const bool right = printed == computed;
  return {right ? Verdict::confirmed : Verdict::refuted, right ? "" : truth, std::move(evidence), ""};
}

Judgement judge_list(const Printed& printed, const std::vector<std::string>& computed,
                     const std::string& truth, std::vector<Evidence> evidence) {
  const bool right = printed == computed;
  return {right ? Verdict::confirmed : Verdict::refuted, right ? "" : truth, std::move(evidence), ""};
}

Judgement judge_rows(const Printed& printed, const std::vector<std::string>& computed, std::size_t width,
                     const std::string& truth, std::vector<Evidence> evidence) {
  const auto rows = [&](const std::vector<std::string>& entries) {
    std::multiset<std::vector<std::string>> set;
    for (std::size_t i = 0; i < entries.size(); i += width)
      set.emplace(entries.begin() + static_cast<std::ptrdiff_t>(i),
                  entries.begin() + static_cast<std::ptrdiff_t>(std::min(i + width, entries.size())));
    return set;
  };
  const bool right = rows(printed) == rows(computed);
  return {right ? Verdict::confirmed : Verdict::refuted, right ? "" : truth, std::move(evidence), ""};
}

namespace {

/// What is counted, one and several of it.
constexpr std::pair<std::string_view, std::string_view> things[] = {{"minimum", "minima"},
                                                                    {"saddle", "saddles"},
                                                                    {"maximum", "maxima"},
                                                                    {"stable", "stable"},
                                                                    {"unstable", "unstable"}};

}  // namespace

Counts::Counts(const std::string& text) {
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    std::istringstream words(part);
    std::size_t count = 0;
    std::string word, more;
    if (!(words >> count >> word) || words >> more) throw Error("claim", "'" + text + "'", "counts");
    const auto* const thing = std::find_if(std::begin(things), std::end(things), [&](const auto& one) {
      return word == one.first || word == one.second;
    });
    if (thing == std::end(things)) throw Error("claim", "'" + word + "'", "stable, minima or the like");
    if (count > 0) count_[std::string(thing->first)] += count;
  }
}

std::size_t Counts::of(const std::string& thing) const {
  const auto found = count_.find(thing);
  return found == count_.end() ? 0 : found->second;
}

std::size_t Counts::total() const {
  std::size_t sum = 0;
  for (const auto& [thing, count] : count_) sum += count;
  return sum;
}

std::string Counts::text() const {
  std::string text;
  for (const auto& [one, several] : things) {
    const std::size_t count = of(std::string(one));
    if (count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, count == 1 ? one : several);
  }
  return text.empty() ? "none" : text;
}

Judgement judge_counts(const std::string& printed, const std::string& computed, const std::string& truth,
                       std::vector<Evidence> evidence) {
  const bool right = Counts(printed) == Counts(computed);
  return {right ? Verdict::confirmed : Verdict::refuted, right ? "" : truth, std::move(evidence), ""};
}

Judgement judge_count(const std::string& printed, const std::function<std::size_t(std::size_t)>& count,
                      const std::string& truth, EvidenceKind kind, const std::string& how) {
  const proofs::Formulas formulas({"n"});
  const GiNaC::ex formula = formulas.parse(printed);
  bool right = true;
  std::vector<std::string> found;
  for (std::size_t n = fewest; n <= most; ++n) {
    const std::size_t computed = count(n);
    right = right && proofs::identical(formula.subs(formulas.symbol("n") == static_cast<int>(n)),
                                       static_cast<int>(computed));
    found.push_back(fmt::format("{}", computed));
  }
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : truth,
          {{kind, fmt::format("n = 2 … 6: {} ({})", fmt::join(found, ", "), how)}},
          ""};
}

Judgement with_evidence(Judgement judgement, Evidence evidence) {
  judgement.evidence.push_back(std::move(evidence));
  std::stable_sort(judgement.evidence.begin(), judgement.evidence.end(),
                   [](const Evidence& a, const Evidence& b) { return a.kind < b.kind; });
  return judgement;
}

Judgement judge_decimals(const Printed& printed, const std::vector<Interval>& computed,
                         const std::vector<std::string>& names, const std::string& how) {
  require_count(printed.size(), computed.size());
  Judgement result{Verdict::confirmed, "", {{EvidenceKind::interval, how}}, ""};
  std::vector<std::string> truths;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const std::optional<Rational> number = proofs::parse_decimal(printed[i]);
    if (!number) throw Error("claim", "'" + printed[i] + "'", "a decimal");
    // a plain 0 is no rounded number
    const bool zero = printed[i] == "0" && !(computed[i].contains_zero() && computed[i].width() == 0);
    const std::string right = certified_fixed(computed[i], places_behind_point(printed[i]));
    if (right == printed[i] && !zero) continue;
    result.verdict =
        worst(result.verdict, !zero && within_a_unit(*number, computed[i], places_behind_point(printed[i]))
                                  ? Verdict::imprecise
                                  : Verdict::refuted);
    const std::string truth =
        fmt::format("{} = {}, printed {}", names[i], certified_decimal(computed[i], 10), printed[i]);
    if (std::find(truths.begin(), truths.end(), truth) == truths.end()) truths.push_back(truth);
  }
  result.truth = fmt::format("{}", fmt::join(truths, "; "));
  return result;
}

std::string certified_decimal(const Interval& value, int digits) {
  const std::string low = proofs::to_decimal(proofs::exactly(value.lower()), digits);
  if (low != proofs::to_decimal(proofs::exactly(value.upper()), digits)) {
    throw Error("enclosure", value.text(10), fmt::format("narrow enough for {} digits", digits));
  }
  return low;
}

}  // namespace plumbline::verify
