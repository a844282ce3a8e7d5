#include "verify/core/core_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <plumbline/chain/linearised.hpp>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/coq/machine_checked.hpp"
#include "proofs/exact/exact_chain.hpp"
#include "verify/sampled/algorithm1_instances.hpp"
#include "verify/sampled/chain_properties.hpp"
#include "verify/sampled/sampled.hpp"

namespace plumbline::verify {
namespace {

/// Relative to the exact value, in units of epsilon; infinite for what is no number.
template <Floating Real>
double units_off(const Real& found, const Real& exact) {
  using std::abs;
  const Real off = abs(found / exact - Real(1)) / epsilon<Real>();
  return off < Real(std::numeric_limits<double>::max()) ? static_cast<double>(off)
                                                        : std::numeric_limits<double>::infinity();
}

/// The values of a line on one chain, against exact ones; nothing where the number type does not resolve
/// them.
template <Floating Real>
using Compared = std::optional<std::vector<std::pair<Real, Real>>>;

/// A line: its words, and how it is computed in each type.
struct Row {
  CoreLine line;
  Compared<double> (*in_double)(const Sample&);
  Compared<Mpfr50> (*in_mp50)(const Sample&);
};

/// Elementary symmetric functions of 1/F, the coefficients of Π (lambda + 1/F): sums of positive terms, which
/// lose no digits. The exact ones are those of det(lambda I - B^-1 A), divided by lambda^2.
template <Floating Real>
Compared<Real> coefficients(const Sample& s) {
  const auto chain = from_rational<Real>(s.exact);
  std::vector<Real> product{Real(1)};
  for (const Real& force : critical_forces(chain, s.exact.size() - 1)) {
    std::vector<Real> next(product.size() + 1, Real(0));
    for (std::size_t i = 0; i < product.size(); ++i) {
      next[i + 1] += product[i];
      next[i] += product[i] / force;
    }
    product = std::move(next);
  }
  const proofs::Polynomial exact = proofs::characteristic_polynomial(s.exact);
  std::vector<std::pair<Real, Real>> pairs;
  for (std::size_t i = 0; i < product.size(); ++i)
    pairs.emplace_back(product[i], from_rational<Real>(exact[i + 2]));
  return pairs;
}

/// How far a relative error of B and of the lengths' sums can grow in B^-1 A and in S1.
double condition_of_matrices(const Chain<Rational>& exact) {
  const auto chain = from_rational<double>(exact);
  const Matrix<double> B = matrix_B(chain);
  const auto& length = chain.length();
  const double whole = std::accumulate(length.begin(), length.end(), 0.0);
  return std::max(B.norm() * B.inverse().norm(), whole / *std::min_element(length.begin(), length.end()));
}

/// det S1 = (-1)^n L_1 … L_n, so that the rank is n; and the Jordan chain at zero, B^-1 A (-1, 0, …) = (0, …,
/// 0, 1): the angles in the first column of B^-1 A are nought beside the others.
template <Floating Real>
Compared<Real> zeros(const Sample& s) {
  const auto n = static_cast<Eigen::Index>(s.exact.size());
  if (condition_of_matrices(s.exact) * static_cast<double>(epsilon<Real>()) > 1e-3) return std::nullopt;
  const auto chain = from_rational<Real>(s.exact);
  Real product(n % 2 == 0 ? 1 : -1);
  for (const Real& length : chain.length()) product *= length;
  const Matrix<Real> angles = algorithm1_matrix(chain).topLeftCorner(n, n);
  const Real second = angles.col(0).norm() / angles.norm();
  return {{{matrix_S1(chain).partialPivLu().determinant(), product}, {Real(1) + second, Real(1)}}};
}

/// Algorithm 1 in the number type; nothing where the condition of a force leaves no digit.
template <Floating Real>
std::optional<std::vector<Mode<Real>>> resolved_modes(const Sample& s) {
  for (std::size_t i = 0; i < s.modes.size(); ++i)
    if (!s.resolved(i, static_cast<double>(epsilon<Real>()))) return std::nullopt;
  if constexpr (std::same_as<Real, Mpfr50>) return s.modes;
  try {
    return algorithm1(from_rational<Real>(s.exact));
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// The exact forces, rounded to the number type: those of the recursion in 50 digits, which counts prove.
template <Floating Real>
Real exact_force(const Sample& s, std::size_t i) {
  const auto forces = critical_forces(from_rational<Mpfr50>(s.exact), s.exact.size() - 1);
  return static_cast<Real>(forces[i]);
}

/// The least energy factor against 1/max|lambda|.
template <Floating Real>
Compared<Real> least_factor(const Sample& s) {
  const auto modes = resolved_modes<Real>(s);
  if (!modes) return std::nullopt;
  const auto chain = from_rational<Real>(s.exact);
  Real least = energy_factor(chain, modes->front().q);
  for (const Mode<Real>& mode : *modes) least = std::min<Real>(least, energy_factor(chain, mode.q));
  return {{{least, exact_force<Real>(s, 0)}}};
}

/// F(q) of (1), (15) and (19) at an angle whose square is epsilon, against (2), (16) and (20). The lengths
/// and stiffnesses are the first of the chain.
template <Floating Real>
Compared<Real> small_angles(const Sample& s) {
  using std::sin, std::sqrt;
  const Real q = sqrt(epsilon<Real>()), L = from_rational<Real>(s.exact.length().front()),
             k = from_rational<Real>(s.exact.stiffness().back() == 0 ? Rational(1)
                                                                     : s.exact.stiffness().back());
  return {{{Real(2) * k * q / (L * sin(q)), Real(2) * k / L},
           {k * q / (L * sin(q)), k / L},
           {Real(3) * k * q / (L * sin(q)), Real(3) * k / L}}};
}

/// All forces of Algorithm 1.
template <Floating Real>
Compared<Real> algorithm_1(const Sample& s) {
  const auto modes = resolved_modes<Real>(s);
  if (!modes) return std::nullopt;
  std::vector<std::pair<Real, Real>> pairs;
  for (std::size_t i = 0; i < modes->size(); ++i)
    pairs.emplace_back((*modes)[i].force, exact_force<Real>(s, i));
  return pairs;
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {{"coefficients of the characteristic polynomial",
        {},
        {},
        "",
        "Two zeros",
        {"eigenvalues.characteristic_polynomial"}},
       coefficients<double>,
       coefficients<Mpfr50>},
      {{"two zero eigenvalues and the rank",
        {},
        {},
        "the rank is n, not n - 1; zero is one Jordan block",
        "Two zeros",
        {"eigenvalues.rank_BinvA", "eigenvalues.zero_twice", "eigenvalues.jordan_chain"}},
       zeros<double>,
       zeros<Mpfr50>},
      {{"minimum of the energy factor at max|λ|", {}, {}, "", "Energy factor", {"definite.energy_factor"}},
       least_factor<double>,
       least_factor<Mpfr50>},
      {{"small-angle limits (2), (16), (20)", {}, {}, "", "Two links", {}},
       small_angles<double>,
       small_angles<Mpfr50>},
      {{"Algorithm 1, every force", {}, {}, "", "Two zeros", {"eigenvalues.eigenvalues"}},
       algorithm_1<double>,
       algorithm_1<Mpfr50>},
  };
  return all;
}

/// What rounding may make of a value, in units of epsilon: of what Algorithm 1 finds Sample::condition, of a
/// determinant the condition of its matrix, elsewhere a few for each operation, of which a coefficient takes
/// 2 (n - 1)^2 and a force of the recursion 16.
double allowed(const Sample& s, const Row& row) {
  const auto n = static_cast<double>(s.exact.size());
  if (row.in_double == &zeros<double>) return 10 * n * n * condition_of_matrices(s.exact);
  if (row.in_double == &algorithm_1<double> || row.in_double == &least_factor<double>)
    return 3 * *std::max_element(s.condition.begin(), s.condition.end());
  return 16 * n + 2 * n * n;
}

template <Floating Real>
void compare(const Compared<Real>& values, std::uint64_t index, double allowance, Deviation& deviation) {
  if (!values) {
    ++deviation.refused;
    return;
  }
  ++deviation.chains;
  for (const auto& [found, exact] : *values) {
    const double units = units_off(found, exact);
    deviation.used = std::max(deviation.used, units / allowance);
    if (units <= deviation.units) continue;
    deviation.units = units;
    deviation.worst = index;
  }
  const double relative = deviation.units * static_cast<double>(epsilon<Real>());
  deviation.digits = -std::log10(std::max(relative, static_cast<double>(epsilon<Real>())));
}

std::string cell(const Deviation& d) {
  const std::string refused = d.refused > 0 ? fmt::format(", {} not resolved", d.refused) : "";
  if (d.units == 0) return fmt::format("exact on {}{}", d.chains, refused);
  return fmt::format("{:.3g} eps, {:.0f} digits on {}{}", d.units, d.digits, d.chains, refused);
}

std::string proof_of(const CoreLine& line) {
  const auto checked = proofs::machine_checked();
  const bool by_coq =
      !line.coq.empty() && std::all_of(line.coq.begin(), line.coq.end(), [&](const std::string& one) {
        return std::find(checked.begin(), checked.end(), one) != checked.end();
      });
  return fmt::format("“{}”{}", line.theorem, by_coq ? ", by Coq" : "");
}

std::string as_file(const Chain<double>& chain) {
  return fmt::format("lengths = [{}], stiffness = [{}]", fmt::join(chain.length(), ", "),
                     fmt::join(chain.stiffness(), ", "));
}

}  // namespace

CoreTable core_table(std::size_t chains, std::uint64_t seed, const std::function<void()>& advance) {
  CoreTable table{seed, chains, {}};
  for (const Row& row : rows()) table.lines.push_back(row.line);
  for (std::uint64_t index = 0; index < chains; ++index) {
    const Sample sample(random_chain(seed, index));
    for (std::size_t i = 0; i < rows().size(); ++i) {
      const Row& row = rows()[i];
      const double allowance = allowed(sample, row);
      compare<double>(row.in_double(sample), index, allowance, table.lines[i].in_double);
      compare<Mpfr50>(row.in_mp50(sample), index, allowance, table.lines[i].in_mp50);
    }
    advance();
  }
  return table;
}

std::string as_text(const CoreTable& table) {
  std::string text = fmt::format(
      "The core on {} random chains of 2 to 8 links, seed {}: largest deviation from exact "
      "arithmetic\n\n",
      table.chains, table.seed);
  for (const CoreLine& line : table.lines) {
    text += fmt::format("{}\n  double  {}, worst chain {}\n  mp50    {}, worst chain {}\n  proof   {}\n",
                        line.what, cell(line.in_double), line.in_double.worst, cell(line.in_mp50),
                        line.in_mp50.worst, proof_of(line));
    if (!line.truth.empty()) text += "  true    " + line.truth + "\n";
  }
  std::vector<std::uint64_t> worst;
  for (const CoreLine& line : table.lines)
    for (const Deviation* const one : {&line.in_double, &line.in_mp50}) worst.push_back(one->worst);
  std::sort(worst.begin(), worst.end());
  worst.erase(std::unique(worst.begin(), worst.end()), worst.end());
  text += "\n";
  for (const std::uint64_t index : worst)
    text += fmt::format("chain {}: {}\n", index, as_file(random_chain(table.seed, index)));
  return text;
}

bool holds(const CoreTable& table) {
  return std::all_of(table.lines.begin(), table.lines.end(),
                     [](const CoreLine& line) { return line.in_double.used <= 1 && line.in_mp50.used <= 1; });
}

}  // namespace plumbline::verify
