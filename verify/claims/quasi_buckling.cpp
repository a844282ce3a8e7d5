/// \file
/// Section 3.2, Fig. 14: where and how the Z-chain of Table 1 softens, and what is said of quasi-buckling.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "proofs/census/census.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exactly.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/formula_value.hpp"

namespace plumbline::verify {
namespace {

const SlowPath& z_path(const Premises& given) {
  return held(given, "z-chain").compressed(far);
}

/// A sharp knee: the stiffness falls to a tenth within a tenth of L.
Judgement z_smooth(const Printed& printed, const Premises& given, int) {
  const bool smooth = z_path(given).regular();
  const std::vector<Rational> at{Rational(11, 100), Rational(12, 100), Rational(21, 100), Rational(22, 100)};
  const std::vector<Interval> slopes = mean_stiffnesses(z_path(given), at);
  const bool knee = certainly_less(given.value("knee") * slopes[2], slopes[0]);
  return judge_word(
      printed.at(0),
      !smooth ? "not smooth"
      : knee  ? "not very smooth"
              : "smooth",
      "it bends, but has no knee",
      {{EvidenceKind::interval,
        fmt::format(
            "certified censuses at {}: mean stiffness {} k/L^2 between the first two, {} between the last",
            in_lengths(at), certified_decimal(slopes[0], 5), certified_decimal(slopes[2], 5))},
       z_path(given).evidence(),
       {EvidenceKind::interval,
        "along the proved branch the Hessian on the tangent space is definite, so by the implicit function "
        "theorem shape and force are analytic in the deflection"}});
}

Judgement z_soft(const Printed& printed, const Premises& given, int) {
  const std::vector<Rational> at{Rational(1, 100), Rational(1, 50), Rational(1, 2), Rational(7, 10)};
  const std::vector<Interval> slopes = mean_stiffnesses(z_path(given), at);
  const bool low = certainly_less(given.value("very-low") * slopes[2], slopes[0]);
  return judge_word(
      printed.at(0), low ? "very low" : "not low", "the stiffness does not become low",
      {{EvidenceKind::interval,
        fmt::format(
            "certified censuses at {}: mean stiffness {} k/L^2 between the first two, {} between the last",
            in_lengths(at), certified_decimal(slopes[0], 5), certified_decimal(slopes[2], 5))}});
}

/// Whether the path has two parts, one steep and one flat.
Judgement z_two_parts(const Printed& printed, const Premises& given, int) {
  const std::vector<Rational> at{Rational(1, 100), Rational(3, 20), Rational(1, 5), Rational(3, 2)};
  const std::vector<Interval> slopes = mean_stiffnesses(z_path(given), at);
  const bool two = z_path(given).stiff() && certainly_less(given.value("very-slowly") * slopes[2], slopes[0]);
  return judge_word(printed.at(0), two ? "fast, then very slow" : "even", "the force grows evenly",
                    {{EvidenceKind::interval,
                      fmt::format("certified censuses at {}: mean stiffness between them {}, {} and {} k/L^2",
                                  in_lengths(at), certified_decimal(slopes[0], 4),
                                  certified_decimal(slopes[1], 4), certified_decimal(slopes[2], 4))},
                     z_path(given).evidence()});
}

/// How fast the links of the Z-chain turn where it softens and beyond, against the beginning.
Judgement fast(const Printed& printed, const Premises& given, int) {
  const std::vector<Rational> looked_at{Rational(1, 20), Rational(1, 10), Rational(17, 100),
                                        Rational(19, 100), Rational(2, 5)};
  const std::vector<proofs::CertifiedEquilibrium> at = states(z_path(given), looked_at);
  const auto turn = [&](std::size_t i) {
    Interval square(0), theta(0);
    for (std::size_t j = 0; j < at[i].q.size(); ++j) {
      theta += at[i + 1].q[j] - at[i].q[j];
      square += sqr(theta);
    }
    return sqrt(square);
  };
  const auto force = [&](std::size_t i) { return at[i].fx - at[i + 1].fx; };
  const Interval slow = turn(0) / Interval(Rational(1, 20)), quick = turn(2) / Interval(Rational(1, 50)),
                 slow_by_force = turn(0) / force(0), quick_by_force = turn(3) / force(3);
  const Printed& factors = given.at("very-fast").parts.at("value");
  const bool faster = certainly_less(number(factors.at(0)) * slow, quick) &&
                      certainly_less(number(factors.at(1)) * slow_by_force, quick_by_force);
  const std::string found = !z_path(given).regular() ? "instant" : faster ? "fast, not instant" : "slow";
  return judge_word(
      printed.at(0), found, "the shape does not change faster, or it jumps",
      {{EvidenceKind::interval,
        fmt::format("certified censuses at {}: the links turn by {} rad per L between the first two, {} "
                    "between the third and the fourth; by {} rad per k/L of the force between the first "
                    "two, {} between the last two",
                    in_lengths(looked_at), certified_decimal(slow, 4), certified_decimal(quick, 4),
                    certified_decimal(slow_by_force, 4), certified_decimal(quick_by_force, 4))},
       z_path(given).evidence()});
}

/// The variable by which the compression F_x has a positive derivative.
Judgement stiffness_variable(const Printed& printed, const Premises& given, int) {
  const std::string positive = z_path(given).stiff() ? "delta_x" : "x",
                    negative = positive == "x" ? "delta_x" : "x";
  return {printed.at(0) == positive   ? Verdict::confirmed
          : printed.at(0) == negative ? Verdict::convention
                                      : Verdict::refuted,
          printed.at(0) == positive
              ? ""
              : "x = const - delta_x by (12): with F_x positive in compression, as in Fig. 14, the stiffness "
                "coefficient is d F_x / d " +
                    positive + "; d F_x / d " + negative + " is negative",
          {z_path(given).evidence()},
          ""};
}

/// Whether a state is certainly unstable under the force that holds it, as a dead load: the second variation
/// sum k_i (v_i - v_{i-1})^2 + sum L_i (Fx cos theta_i + Fy sin theta_i) v_i^2 is negative for some turns v
/// of the links.
bool unstable_under_force(const Chain<Interval>& chain, const proofs::CertifiedEquilibrium& one) {
  const auto n = static_cast<Eigen::Index>(chain.size());
  std::vector<Interval> weight;
  Interval theta(0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    theta += one.q[i];
    weight.push_back(chain.length()[i] * (one.fx * cos(theta) + one.fy * sin(theta)));
  }
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n, n);
  const auto number = [](const Interval& x) { return static_cast<double>(x.middle()); };
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto joint = static_cast<std::size_t>(i);
    const double k = number(chain.stiffness()[joint]);
    H(i, i) += k + number(weight[joint]);
    if (i == 0) continue;
    H(i - 1, i - 1) += k;
    H(i, i - 1) = H(i - 1, i) = -k;
  }
  const Eigen::VectorXd v = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvectors().col(0);
  Interval form(0);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto link = static_cast<std::size_t>(i);
    const Interval turn(Rational(v(i))), before(i == 0 ? Rational(0) : Rational(v(i - 1)));
    form += chain.stiffness()[link] * sqr(turn - before) + weight[link] * sqr(turn);
  }
  return certainly_negative(form);
}

/// Whether the stable shapes of a held end point are also stable under the force that holds it.
Judgement under_force(const Printed& printed, const Premises& given, int) {
  std::vector<std::string> unstable;
  const SlowPath& u_path = held(given, "u-chain").compressed(far);
  for (const auto& [name, path] : {std::pair{"U", &u_path}, {"Z", &z_path(given)}}) {
    const std::vector<Rational> deflections{Rational(1, 10), Rational(2, 5), Rational(6, 5)};
    const std::vector<proofs::CertifiedEquilibrium> at = states(*path, deflections);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (unstable_under_force(path->enclosed, at[i]))
        unstable.push_back(fmt::format("{} at {:.1f} L", name, static_cast<double>(deflections[i])));
    }
  }
  const std::string list = fmt::format("{}", fmt::join(unstable, ", "));
  return judge_word(
      printed.at(0), "similar", "the equilibria are the same",
      {Evidence::by_theorem("Held and loaded",
                            "with and without the constraint the equations of equilibrium are the same; what "
                            "is stable under the force is stable with its end point held"),
       {EvidenceKind::interval,
        "certified censuses: fewer are stable under the dead force, for the second variation is negative "
        "for some turns of the links of " +
            (list.empty() ? "none" : list)}});
}

/// Which torques make (8) give no force in the unloaded shapes of Table 1.
Judgement torques_from_rest(const Printed& printed, const Premises& given, int) {
  bool from_rest = true;
  std::vector<std::string> forces;
  for (const Chain<Interval>& chain : {given.chain("u-chain"), given.chain("z-chain")}) {
    Interval x(0), y(0), theta(0), xx(0), xy(0), yy(0), xm(0), ym(0);
    for (const Interval& q : chain.rest()) theta += q;
    for (std::size_t i = chain.size(); i-- > 0;) {  // rows of J^T: (-y, x), from the last joint on
      x += chain.length()[i] * cos(theta);
      y += chain.length()[i] * sin(theta);
      const Interval q = chain.rest()[i], torque = chain.stiffness()[i] * q;
      theta -= q;
      xx += y * y, xy -= x * y, yy += x * x, xm -= y * torque, ym += x * torque;
    }
    const Interval fx = (xy * ym - yy * xm) / (xx * yy - xy * xy);  // -(J J^T)^-1 J M, first component
    from_rest = from_rest && !fx.contains_zero();
    forces.push_back(certified_decimal(fx, 4));
  }
  const std::string found = from_rest ? "q-q0" : "q";
  return {printed.at(0) == found ? Verdict::confirmed
          : printed.at(0) == "q" ? Verdict::convention
                                 : Verdict::refuted,
          printed.at(0) == found
              ? ""
              : "q_i of (12) counts from the straight chain, q_i of (8) and (10) from the shape at "
                "rest: M = K (q - q^0), or the unloaded chain would bear a force",
          {{EvidenceKind::interval,
            fmt::format("(8) with M = K q at the unloaded shapes of Table 1: F_x = {} k/L instead of 0",
                        fmt::join(forces, " and "))}},
          ""};
}

/// Which of (6) and (8) are as many equations as there are angles: (8) says J (J^T F + M) = 0.
Judgement equations_of_8(const Printed& printed, int) {
  bool enough = true;
  std::string counts;
  for (std::size_t n = fewest; n <= most; ++n) {
    const Matrix<Rational> J = bent_jacobian(n);
    const auto count = printed.at(0) == "(8)" ? Eigen::FullPivLU<Matrix<Rational>>(J).rank() : J.cols();
    enough = enough && static_cast<std::size_t>(count) == n;
    counts += fmt::format("{}{}", counts.empty() ? "" : ", ", count);
  }
  return {enough ? Verdict::confirmed : Verdict::refuted,
          enough
              ? ""
              : "(8) says J (J^T F + M) = 0: two equations for n unknowns. Equilibrium is (6), all n of them",
          {{EvidenceKind::exact,
            fmt::format(
                "{} for n = 2 … 6 links, bent shape, rows of (6) and rank of J in rationals: {} equations",
                printed.at(0), counts)}},
          ""};
}

/// The most minima of the stiffness that a simulated curve without buckling has.
Judgement most_points(const Printed& printed, const Premises& given, int digits) {
  std::size_t most = 0;
  std::vector<std::string> list;
  Judgement result;
  for (const auto& [name, path] : {std::pair{"Fig. 5b", &held(given, "quasi-straight").compressed(1)},
                                   {"Fig. 7", &held(given, "fig-7-chain").compressed(far)},
                                   {"Fig. 12", &held(given, "u-chain").compressed(far)},
                                   {"Fig. 14", &z_path(given)}}) {
    const double first = path->stretches[0].points.front().stiffness;
    most = std::max(most, path->softest());
    result.evidence.push_back({EvidenceKind::interval, std::string(name) + ": " + path->evidence().detail});
    for (const auto& event : path->of_kind(EventKind::quasi_buckling)) {
      const double part = static_cast<double>(event.point.stiffness) / first;
      list.push_back(fmt::format("{} at {} L, {:.3g} % of the initial stiffness", name,
                                 event.point.load.str(6), 100 * part));
      result.value += (result.value.empty() ? "" : "; ") + located(event.point.load, digits);
    }
  }
  const std::string points = fmt::format("{}", fmt::join(list, "; "));
  result.evidence.push_back(
      {EvidenceKind::mp50, "points of least stiffness, located in 64 digits: " + points});
  const bool right = printed.at(0) == std::to_string(most);
  result.verdict = right ? Verdict::confirmed : Verdict::refuted;
  result.truth = right ? "" : fmt::format("at most {} on a curve: {}", most, points);
  return result;
}

}  // namespace

Checks claims::quasi_buckling() {
  return {
      {"fig-14-smooth", z_smooth},
      {"fig-14-soft", z_soft},
      {"fig-14-parts", z_two_parts},
      {"fig-14-fast", fast},
      {"fig-14-sign", stiffness_variable},
      {"eq-8-torques", torques_from_rest},
      {"given-force-equations", equations_of_8},
      {"given-force", under_force},
      {"single-point", most_points},
  };
}

}  // namespace plumbline::verify
