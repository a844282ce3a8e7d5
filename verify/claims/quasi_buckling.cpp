/// \file
/// Section 3.2, Fig. 14: where and how the Z-chain of Table 1 softens, and what is said of quasi-buckling.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "proofs/census.hpp"
#include "verify/claims/claims.hpp"
#include "verify/claims/loaded_chains.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

std::string located(const proofs::Located& number, int digits) {
  return number.str(std::min(digits, proofs::located_digits));
}

Judgement z_smooth(const Printed& printed, int) {
  const bool smooth = z_path().regular();
  const std::string found = smooth ? "smooth" : "not smooth";
  Judgement result{
      Verdict::confirmed,
      "",
      {z_path().evidence(),
       {EvidenceKind::interval,
        "there the Hessian on the tangent space is definite, so by the implicit function theorem "
        "shape and force are analytic in the deflection"}},
      ""};
  if (printed.at(0) == found) return result;
  result.verdict = printed.at(0) == "not very smooth" && smooth ? Verdict::imprecise : Verdict::refuted;
  result.truth = "the curve is " + found + ": it bends sharply, but has no kink and no jump";
  return result;
}

Judgement z_soft(const Printed& printed, int) {
  const std::vector<Interval> slopes =
      mean_stiffnesses(z_path(), {Rational(1, 100), Rational(1, 50), Rational(1, 2), Rational(7, 10)});
  const bool low = certainly_less(Interval(20) * slopes[2], slopes[0]);
  return judge_word(
      printed.at(0), low ? "very low" : "not low", {"very low", "not low"},
      "the stiffness does not become low",
      {{EvidenceKind::interval,
        fmt::format("certified censuses: mean stiffness {} k/L^2 between 0.01 and 0.02 L, {} between 0.5 "
                    "and 0.7 L",
                    certified_decimal(slopes[0], 5), certified_decimal(slopes[2], 5))}});
}

/// Whether the path has two parts, one steep and one flat.
Judgement z_two_parts(const Printed& printed, int) {
  const std::vector<Interval> slopes =
      mean_stiffnesses(z_path(), {Rational(1, 100), Rational(3, 20), Rational(1, 5), Rational(3, 2)});
  const bool two = z_path().stiff() && certainly_less(Interval(10) * slopes[2], slopes[0]);
  return judge_word(
      printed.at(0), two ? "fast, then very slow" : "even", {"fast, then very slow", "even"},
      "the force grows evenly",
      {{EvidenceKind::interval, fmt::format("certified censuses at 0.01, 0.15, 0.2 and 1.5 L: mean stiffness "
                                            "between them {}, {} and {} k/L^2",
                                            certified_decimal(slopes[0], 4), certified_decimal(slopes[1], 4),
                                            certified_decimal(slopes[2], 4))},
       z_path().evidence()});
}

/// How fast the links of the Z-chain turn where it softens and beyond, against the beginning.
Judgement fast(const Printed& printed, int) {
  const std::vector<proofs::CertifiedEquilibrium> at = states(
      z_path(), {Rational(1, 20), Rational(1, 10), Rational(17, 100), Rational(19, 100), Rational(2, 5)});
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
  const bool faster = certainly_less(Interval(2) * slow, quick) &&
                      certainly_less(Interval(10) * slow_by_force, quick_by_force);
  const std::string found = !z_path().regular() ? "instant" : faster ? "fast, not instant" : "slow";
  return judge_word(printed.at(0), found, {"fast, not instant", "instant", "slow"},
                    "the shape does not change faster, or it jumps",
                    {{EvidenceKind::interval,
                      fmt::format("certified censuses at 0.05, 0.1, 0.17, 0.19 and 0.4 L: the links turn by "
                                  "{} rad per L between the "
                                  "first two, {} from 0.17 to 0.19 L; by {} rad per k/L of the force between "
                                  "the first two, {} from "
                                  "0.19 to 0.4 L",
                                  certified_decimal(slow, 4), certified_decimal(quick, 4),
                                  certified_decimal(slow_by_force, 4), certified_decimal(quick_by_force, 4))},
                     z_path().evidence()});
}

/// The variable by which the compression F_x has a positive derivative.
Judgement stiffness_variable(const Printed& printed, int) {
  const std::string positive = z_path().stiff() ? "delta_x" : "x",
                    negative = positive == "x" ? "delta_x" : "x";
  return {printed.at(0) == positive   ? Verdict::confirmed
          : printed.at(0) == negative ? Verdict::convention
                                      : Verdict::refuted,
          printed.at(0) == positive
              ? ""
              : "x = const - delta_x by (12): with F_x positive in compression, as in Fig. 14, the stiffness "
                "coefficient is d F_x / d " +
                    positive + "; d F_x / d " + negative + " is negative",
          {z_path().evidence()},
          ""};
}

Judgement z_keeps(const Printed& printed, int) {
  std::string found;
  for (const auto& one : states(
           z_path(), {Rational(1, 20), Rational(1, 10), Rational(3, 20), Rational(2, 5), Rational(7, 10)})) {
    const std::string here = signs(one);
    found = found.empty() || found == here ? here : "changing";
  }
  return judge_word(printed.at(0), found, {printed.at(0), found},
                    "the signs of the joint angles are " + found,
                    {{EvidenceKind::interval,
                      "certified censuses at 0.05, 0.1, 0.15, 0.4 and 0.7 L: the state of the "
                      "slowly compressed chain has the signs " +
                          found}});
}

Judgement z_quasi(const Printed& printed, int digits) {
  const auto points = z_path().of_kind(EventKind::quasi_buckling);
  const std::string count = std::to_string(z_path().softest());
  Judgement result = judge_word(printed.at(0), count, {printed.at(0), count},
                                count + " points of least stiffness up to 1.5 L", {z_path().evidence()});
  if (points.empty()) return result;
  const Interval at(points[0].point.load, points[0].point.load), off(Rational(1, 100));
  const std::string before = extrema(held_at(z_shaped_chain(), table_1_reach() - at + off)),
                    after = extrema(held_at(z_shaped_chain(), table_1_reach() - at - off));
  result.evidence.push_back(
      {EvidenceKind::interval,
       fmt::format(
           "certified censuses 0.01 L before ({}) and after ({}) the value: no equilibrium comes or goes",
           before, after)});
  result.evidence.push_back(
      {EvidenceKind::mp50, fmt::format("zero of the stiffness's derivative in 64 digits: stiffness {} k/L^2",
                                       points[0].point.stiffness.str(8))});
  result.value = located(points[0].point.load, digits);
  return result;
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
Judgement under_force(const Printed& printed, int) {
  std::vector<std::string> unstable;
  for (const auto& [name, path] : {std::pair{"U", &u_path()}, {"Z", &z_path()}}) {
    const std::vector<Rational> deflections{Rational(1, 10), Rational(2, 5), Rational(6, 5)};
    const std::vector<proofs::CertifiedEquilibrium> at = states(*path, deflections);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (unstable_under_force(path->enclosed, at[i]))
        unstable.push_back(fmt::format("{} at {:.1f} L", name, static_cast<double>(deflections[i])));
    }
  }
  const std::string list = fmt::format("{}", fmt::join(unstable, ", "));
  Judgement result{
      Verdict::confirmed,
      "",
      {{EvidenceKind::theorem,
        "Held and loaded: with and without the constraint the equations of equilibrium are the same; "
        "what is stable under the force is stable with its end point held"},
       {EvidenceKind::interval,
        "certified censuses: under the force that holds them, as a dead load, the second "
        "variation is negative for "
        "some turns of the links of " +
            (list.empty() ? "none" : list)}},
      ""};
  if (printed.at(0) == (unstable.empty() ? "similar" : "the same equilibria, stable less often"))
    return result;
  result.verdict = printed.at(0) == "similar" ? Verdict::imprecise : Verdict::refuted;
  result.truth =
      "the same equilibria, but fewer of them are stable under the dead force; unstable are " + list;
  return result;
}

Judgement several(const Printed& printed, int digits) {
  const Chain<Interval> chain({1, 1, 1}, {0, 1, 2},
                              {0, Interval(Rational(11, 10)), Interval(Rational(-3, 2))});
  const SlowPath path = compress_slowly(chain, unloaded_reach(chain), 1.4);
  const auto points = path.of_kind(EventKind::quasi_buckling);
  const std::string count = std::to_string(path.softest());
  Judgement result = judge_word(
      printed.at(0), path.softest() > 1 ? "possible" : "open", {"possible", "open", "impossible"},
      "they exist",
      {{EvidenceKind::interval, "three links, passive base, k = (0, 1, 2), rest angles 1.1 and -1.5: " +
                                    count + " minima of the tangent stiffness up to 1.4 L"},
       path.evidence(),
       {EvidenceKind::mp50,
        fmt::format("{} points of least stiffness located in 64 digits", points.size())}});
  for (const auto& event : points)
    result.value += (result.value.empty() ? "" : "; ") + located(event.point.load, digits);
  return result;
}

/// Which torques make (8) give no force in the unloaded shapes of Table 1.
Judgement torques_from_rest(const Printed& printed, int) {
  bool from_rest = true;
  std::vector<std::string> forces;
  for (const Chain<Interval>& chain : {u_shaped_chain(), z_shaped_chain()}) {
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

/// How many equations (8) are, for a given force.
Judgement equations_of_8(const Printed& printed, int) {
  const auto count = [](std::size_t n) {
    return static_cast<std::size_t>(Eigen::FullPivLU<Matrix<Rational>>(bent_jacobian(n)).rank());
  };
  return judge_count(
      printed.at(0), count,
      "(8) says J (J^T F + M) = 0: two equations for n unknowns. Equilibrium is (6), all n of them",
      EvidenceKind::exact, "rank of J in rationals, bent shape");
}

/// Points of least stiffness of all stable paths that sections 3.1 and 3.2 call free of buckling, and of
/// Fig. 14.
Judgement all_points(const Printed& printed, int digits) {
  std::size_t count = 0, deep = 0;
  std::vector<std::string> list;
  Judgement result;
  for (const auto& [name, path] :
       {std::pair{"Fig. 7", &fig7_path()}, {"Fig. 12", &u_path()}, {"Fig. 14", &z_path()}}) {
    const double first = path->stretches[0].points.front().stiffness;
    count += path->softest();
    result.evidence.push_back({EvidenceKind::interval, std::string(name) + ": " + path->evidence().detail});
    for (const auto& event : path->of_kind(EventKind::quasi_buckling)) {
      const double part = static_cast<double>(event.point.stiffness) / first;
      deep += part < 0.05 ? 1 : 0;
      list.push_back(fmt::format("{} at {} L, {:.3g} % of the initial stiffness", name,
                                 event.point.load.str(6), 100 * part));
      result.value += (result.value.empty() ? "" : "; ") + located(event.point.load, digits);
    }
  }
  result.evidence.push_back(
      {EvidenceKind::mp50,
       fmt::format("points of least stiffness on the stable paths of Figures 7, 12 and 14, "
                   "located in 64 digits: {}",
                   fmt::join(list, "; "))});
  result.verdict = printed.at(0) == std::to_string(count)  ? Verdict::confirmed
                   : printed.at(0) == std::to_string(deep) ? Verdict::imprecise
                                                           : Verdict::refuted;
  if (result.verdict != Verdict::confirmed)
    result.truth = fmt::format(
        "{} as minima of the tangent stiffness, {} of them below a twentieth of the initial one: {}", count,
        deep, fmt::join(list, "; "));
  return result;
}

}  // namespace

std::vector<Claim> claims::quasi_buckling() {
  return {
      {"fig-14-smooth",
       "3.2, Fig. 14",
       "the curve of the Z-chain is not very smooth",
       {"not very smooth"},
       z_smooth},
      {"fig-14-soft",
       "3.2, Fig. 14",
       "there is an area where the stiffness becomes very low",
       {"very low"},
       z_soft},
      {"fig-14-parts",
       "3.2, Fig. 14",
       "the resistance grows fast and monotonically, beyond a critical deflection very slowly",
       {"fast, then very slow"},
       z_two_parts},
      {"fig-14-shape", "3.2, Fig. 14", "the chain maintains its Z-shape", {"-+-+"}, z_keeps},
      {"fig-14-points", "3.2, Fig. 14", "a single quasi-buckling point was discovered", {"1"}, z_quasi},
      {"fig-14-fast",
       "3.2, last paragraph",
       "the shape changes very fast, but not instantly",
       {"fast, not instant"},
       fast},
      {"fig-14-sign",
       "3.2, after Fig. 13",
       "the stiffness coefficient is dF_x/dx",
       {"x"},
       stiffness_variable},
      {"eq-8-torques",
       "3.2, after (12)",
       "(8) with the angles q of (12) yields the force",
       {"q"},
       torques_from_rest},
      {"given-force-equations",
       "3.2, after Fig. 14",
       "the static equilibrium equations (8) are to be solved for n unknowns",
       {"n"},
       equations_of_8},
      {"given-force",
       "3.2, after Fig. 14",
       "solving for a given force instead of a given deflection gives similar results",
       {"similar"},
       under_force},
      {"single-point",
       "3.2, last paragraph",
       "in the presented simulations there is a single quasi-buckling point",
       {"1"},
       all_points},
      {"several-points",
       "3.2, last paragraph",
       "several quasi-buckling points may exist for some chains (an open question)",
       {"possible"},
       several},
  };
}

}  // namespace plumbline::verify
