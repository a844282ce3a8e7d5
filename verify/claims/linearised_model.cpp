/// \file
/// Section 4.2, the linearised model: equations (21) to (33) and the sentences around them.

#include <fmt/core.h>

#include <plumbline/chain/linearised.hpp>

#include "proofs/symbolic_statics.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

constexpr unsigned n = 4;  // printed general formulas are read for four links

/// Symbols L1…L4, k1…k4, q1…q4, Fx, Fy, lambda.
const proofs::Formulas& formulas() {
  static const proofs::Formulas instance([] {
    std::vector<std::string> names{"Fx", "Fy", "lambda"};
    for (unsigned i = 1; i <= n; ++i) {
      for (const char* name : {"L", "k", "q"}) names.push_back(fmt::format("{}{}", name, i));
    }
    return names;
  }());
  return instance;
}

std::vector<ex> symbols(const std::string& name) {
  std::vector<ex> result;
  for (unsigned i = 1; i <= n; ++i) result.push_back(formulas().symbol(fmt::format("{}{}", name, i)));
  return result;
}

proofs::SymbolicShape general_shape() {
  return {symbols("L"), symbols("k"), symbols("q")};
}

/// All joint angles multiplied by one symbol, to read orders of smallness.
struct Scaled {
  ex epsilon = GiNaC::realsymbol("epsilon");
  proofs::SymbolicShape shape = general_shape();
  Scaled() {
    for (ex& angle : shape.q) angle *= epsilon;
  }
  [[nodiscard]] ex leading(const ex& e) const {
    return proofs::series_coefficient(e, epsilon, proofs::leading_order(e, epsilon));
  }
};

ex derivative(const ex& e, const ex& symbol) {
  return e.diff(GiNaC::ex_to<GiNaC::symbol>(symbol));
}

std::vector<std::string> grid_names(const std::string& matrix, unsigned rows, unsigned columns) {
  std::vector<std::string> names;
  for (unsigned i = 1; i <= rows; ++i) {
    for (unsigned j = 1; j <= columns; ++j) names.push_back(fmt::format("{}({},{})", matrix, i, j));
  }
  return names;
}

/// Shortening and lateral deflection of the straight chain's end point.
std::vector<ex> deflections(const proofs::SymbolicShape& shape) {
  proofs::SymbolicShape straight = shape;
  straight.q.assign(n, 0);
  const GiNaC::matrix from = end_point(straight);
  const GiNaC::matrix to = end_point(shape);
  return {from(0, 0) - to(0, 0), to(1, 0) - from(1, 0)};
}

Judgement geometry(const Printed& printed, int) {
  return judge_formulas(formulas(), printed, deflections(general_shape()), {"delta_x", "delta_y"},
                        "end point of the straight chain against that of the bent one, n = 4");
}

Judgement full_jacobian(const Printed& printed, int) {
  const proofs::SymbolicShape shape = general_shape();
  std::vector<ex> computed;
  for (unsigned row = 0; row < 2; ++row) {
    for (const ex& q : shape.q) computed.push_back(derivative(end_point(shape)(row, 0), q));
  }
  return judge_formulas(formulas(), printed, computed, grid_names("J", 2, n),
                        "derivatives of the end point by the joint angles, n = 4");
}

/// Virtual work: E - F.p is stationary; its derivative is K q - J^T F = -(M + J^T F) with M of (24).
Judgement equilibrium(const Printed& printed, int) {
  const proofs::SymbolicShape shape = general_shape();
  const ex Fx = formulas().symbol("Fx");
  const ex Fy = formulas().symbol("Fy");
  ex potential = -Fx * end_point(shape)(0, 0) - Fy * end_point(shape)(1, 0);
  for (unsigned i = 0; i < n; ++i) potential += shape.stiffness[i] * pow(shape.q[i], 2) / 2;
  const int sign = std::stoi(printed.at(0) + "1");  // of M = ∓ K q
  const GiNaC::matrix J = jacobian(shape);
  bool right = true;
  for (unsigned i = 0; i < n; ++i) {
    const ex residual = sign * shape.stiffness[i] * shape.q[i] + J(0, i) * Fx + J(1, i) * Fy;
    right = right && proofs::identical(residual, -derivative(potential, shape.q[i]));
  }
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "with F the force on the end point, M = -K q: the springs resist",
          {{EvidenceKind::symbolic, "gradient of the potential E - F.p, n = 4: zero where J^T F - K q = 0"}},
          ""};
}

Judgement torque_sign(const Printed& printed, int) {
  const std::string coefficient = equilibrium({"-"}, 0).verdict == Verdict::confirmed ? "-1" : "1";
  const std::string opposite = coefficient == "1" ? "-1" : "1";  // what it is for the opposite force
  const Verdict verdict = printed.at(0) == coefficient ? Verdict::confirmed
                          : printed.at(0) == opposite  ? Verdict::convention
                                                       : Verdict::refuted;
  return {verdict,
          verdict == Verdict::confirmed ? ""
                                        : "M = +K q in J^T F + M = 0, as in (6), (14), (18), (29), makes F "
                                          "the force that the chain exerts on its "
                                          "surroundings (compression positive); M = -K q, as in (24), makes "
                                          "it the force on the chain (compression "
                                          "negative). The paper uses both",
          {{EvidenceKind::symbolic,
            "gradient of E - F.p: for the force on the end point M = " + coefficient + " K q"}},
          ""};
}

Judgement counts(const Printed& printed, int) {
  const Chain<Rational> chain(std::vector<Rational>(n, 1), std::vector<Rational>(n, 1));
  const Eigen::Index equations = matrix_A(chain).rows();
  const Eigen::Index unknowns = matrix_A(chain).cols() + 1;  // v and F_x
  const std::string found = fmt::format("n+{} equations, n+{} unknowns", equations - n, unknowns - n);
  const bool right = printed.at(0) == found;
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : found,
          {{EvidenceKind::exact, fmt::format("n = 4: A and B are {} x {}, the unknowns are q, F_y and F_x",
                                             equations, matrix_A(chain).cols())}},
          ""};
}

Judgement nonlinear_counts(const Printed& printed, int) {
  const proofs::SymbolicShape shape = general_shape();
  const std::size_t balances =
      proofs::torque_balance(shape, formulas().symbol("Fx"), formulas().symbol("Fy")).rows();
  const std::size_t equations = balances + deflections(shape).size();
  const std::size_t unknowns = shape.q.size() + 2;
  const std::string found = fmt::format("n+{} equations, n+{} unknowns", equations - n, unknowns - n);
  const bool right = printed.at(0) == found;
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : found,
          {{EvidenceKind::exact, fmt::format("n = 4: {} torque balances and {} deflections for q, F_x, F_y",
                                             balances, equations - balances)}},
          ""};
}

Judgement small_geometry(const Printed& printed, int) {
  const Scaled scaled;
  std::vector<ex> computed;
  for (const ex& deflection : deflections(scaled.shape)) computed.push_back(scaled.leading(deflection));
  return judge_formulas(
      formulas(), printed, computed, {"delta_x", "delta_y"},
      "lowest-order terms of (21) in the joint angles, n = 4; 0 <= delta_x(25) - delta_x(21) <= sum L "
      "theta^4/24 since 1 - cos x lies between x^2/2 - x^4/24 and x^2/2");
}

Judgement linear_word(const Printed& printed, int) {
  const Scaled scaled;
  const std::vector<ex> d = deflections(scaled.shape);
  const int order_x = proofs::leading_order(d[0], scaled.epsilon);
  const int order_y = proofs::leading_order(d[1], scaled.epsilon);
  const bool right = printed.at(0) == std::to_string(order_x) && printed.at(1) == std::to_string(order_y);
  const bool nearly = printed.at(1) == std::to_string(order_y);
  return {right    ? Verdict::confirmed
          : nearly ? Verdict::imprecise
                   : Verdict::refuted,
          right
              ? ""
              : fmt::format(
                    "delta_x in (25) is of order {}, not linear; its linear part vanishes, which is why the "
                    "straight chain does not yield before it buckles. delta_y is of order {}",
                    order_x, order_y),
          {{EvidenceKind::symbolic,
            fmt::format("lowest orders of (21) in the joint angles: {} and {}", order_x, order_y)}},
          ""};
}

Judgement small_jacobian_entries(const Printed& printed, int) {
  const Scaled scaled;
  std::vector<ex> computed;
  const GiNaC::matrix J = jacobian(scaled.shape);
  for (std::size_t i = 0; i < J.nops(); ++i) computed.push_back(scaled.leading(J.op(i)));
  return judge_formulas(formulas(), printed, computed, grid_names("J", 2, n),
                        "lowest-order terms of (23), n = 4");
}

/// S1 from the kinematics, not from (28): the first row of J^T is S1 q to first order.
ex s1_entry(unsigned i, unsigned j) {
  const Scaled scaled;
  const ex first = proofs::series_coefficient(jacobian(scaled.shape)(0, i), scaled.epsilon, 1);
  return derivative(first, symbols("q")[j]);
}

Judgement s1_matrix(const Printed& printed, int) {
  std::vector<ex> computed;
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < n; ++j) computed.push_back(s1_entry(i, j));
  }
  return judge_formulas(formulas(), printed, computed, grid_names("S1", n, n),
                        "first-order part of the first row of (23), n = 4");
}

Judgement s0_vector(const Printed& printed, int) {
  const GiNaC::matrix at_zero = [] {
    proofs::SymbolicShape straight = general_shape();
    straight.q.assign(n, 0);
    return jacobian(straight);
  }();
  std::vector<ex> computed;
  for (unsigned i = 0; i < n; ++i) computed.push_back(at_zero(1, i));
  return judge_formulas(formulas(), printed, computed, grid_names("S0", n, 1),
                        "second row of (23) at q = 0, n = 4");
}

/// (22) with (24), to first order: row i of -K q + S1 q F_x + S0 F_y.
Judgement linear_equilibrium(const Printed& printed, int) {
  const ex Fx = formulas().symbol("Fx");
  const ex Fy = formulas().symbol("Fy");
  const std::vector<ex> q = symbols("q");
  ex torque = 0;
  for (unsigned j = 0; j < n; ++j) torque += s1_entry(0, j) * q[j];
  const ex spring = symbols("k")[0] * q[0];
  const ex load = torque * Fx + (symbols("L")[0] + symbols("L")[1] + symbols("L")[2] + symbols("L")[3]) * Fy;
  const int sign = std::stoi(printed.at(0) + "1");
  const ex row = sign * spring + load;
  const bool right = proofs::proportional(row, load - spring);
  const bool other_convention = proofs::proportional(row, load + spring);
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? ""
                : "from (22), (24) and (27) follows -K q + S1 q F_x + S0 F_y = 0; (29) as printed holds for "
                  "the opposite "
                  "force, compression positive, that is with M = +K q as in (6)",
          {{EvidenceKind::symbolic, fmt::format("first row for n = 4: the printed one is a multiple of (22) "
                                                "with (24): {}; of (22) with M = +K q: {}",
                                                right, other_convention)}},
          ""};
}

Judgement constraint(const Printed& printed, int) {
  const Scaled scaled;
  return judge_formulas(formulas(), printed, {scaled.leading(deflections(scaled.shape)[1])}, {"delta_y"},
                        "first-order part of delta_y in (21), n = 4");
}

/// (A F_x ± B) v against the left sides of (29) and (30), computed from S1, S0 and K one by one.
Judgement blocks(const Printed& printed, int) {
  const Chain<Rational> chain({2, 3, 5, 7}, {1, 4, 6, 9});
  const Matrix<Rational> A = matrix_A(chain);
  const Matrix<Rational> B = matrix_B(chain);
  const Matrix<Rational> S1 = matrix_S1(chain);
  const Vector<Rational> S0 = matrix_S0(chain);
  Vector<Rational> v(5);
  v << 3, -1, 4, 1, -5;
  const Rational Fx(7, 2);
  const Vector<Rational> q = v.head(4);
  Vector<Rational> expected(5);
  for (Eigen::Index i = 0; i < 4; ++i) {
    expected(i) = chain.stiffness()[static_cast<std::size_t>(i)] * q(i) + (S1 * q)(i)*Fx + S0(i) * v(4);
  }
  expected(4) = S0.dot(q);
  const int sign = std::stoi(printed.at(0) + "1");
  const bool right = Vector<Rational>((A * Fx + Rational(sign) * B) * v) == expected;
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "(A F_x + B) v = 0",
          {{EvidenceKind::exact,
            "L = (2,3,5,7), k = (1,4,6,9), v = (3,-1,4,1,-5), F_x = 7/2: (A F_x + B) v equals the left "
            "sides of (29) and (30)"}},
          ""};
}

}  // namespace

std::vector<Claim> claims::linearised_model() {
  const Printed tails{"L1+L2+L3+L4", "L2+L3+L4", "L3+L4", "L4"};
  const Printed s1{
      "-(L1+L2+L3+L4)", "-(L2+L3+L4)", "-(L3+L4)", "-L4", "-(L2+L3+L4)", "-(L2+L3+L4)", "-(L3+L4)", "-L4",
      "-(L3+L4)",       "-(L3+L4)",    "-(L3+L4)", "-L4", "-L4",         "-L4",         "-L4",      "-L4"};
  return {
      {"eq-21",
       "4.2, (21)",
       "deflections (delta_x, delta_y) of the straight chain's end point",
       {"L1+L2+L3+L4-L1*cos(q1)-L2*cos(q1+q2)-L3*cos(q1+q2+q3)-L4*cos(q1+q2+q3+q4)",
        "L1*sin(q1)+L2*sin(q1+q2)+L3*sin(q1+q2+q3)+L4*sin(q1+q2+q3+q4)"},
       geometry},
      {"eq-22-24",
       "4.2, (22), (24)",
       "equilibrium is M + J^T F = 0 with M = -(k_1 q_1, …, k_n q_n)",
       {"-"},
       equilibrium},
      {"torque-sign",
       "4.1, (14), and 2, (6)",
       "equilibrium is M + J^T F = 0 with M = +(0, k q_1, k q_2)",
       {"1"},
       torque_sign},
      {"eq-23",
       "4.2, (23)",
       "kinematic Jacobian of n links",
       {"-L1*sin(q1)-L2*sin(q1+q2)-L3*sin(q1+q2+q3)-L4*sin(q1+q2+q3+q4)",
        "-L2*sin(q1+q2)-L3*sin(q1+q2+q3)-L4*sin(q1+q2+q3+q4)", "-L3*sin(q1+q2+q3)-L4*sin(q1+q2+q3+q4)",
        "-L4*sin(q1+q2+q3+q4)", "L1*cos(q1)+L2*cos(q1+q2)+L3*cos(q1+q2+q3)+L4*cos(q1+q2+q3+q4)",
        "L2*cos(q1+q2)+L3*cos(q1+q2+q3)+L4*cos(q1+q2+q3+q4)", "L3*cos(q1+q2+q3)+L4*cos(q1+q2+q3+q4)",
        "L4*cos(q1+q2+q3+q4)"},
       full_jacobian},
      {"linearised",
       "4.2, before (25)",
       "for small angles the geometry (21) can be linearized, which gives (25)",
       {"1", "1"},
       linear_word},
      {"eq-25",
       "4.2, (25)",
       "delta_x = sum L_j (q_1+…+q_j)^2 / 2, delta_y = sum L_j (q_1+…+q_j)",
       {"(L1*q1^2+L2*(q1+q2)^2+L3*(q1+q2+q3)^2+L4*(q1+q2+q3+q4)^2)/2",
        "L1*q1+L2*(q1+q2)+L3*(q1+q2+q3)+L4*(q1+q2+q3+q4)"},
       small_geometry},
      {"eq-26",
       "4.2, (26)",
       "Jacobian for small angles",
       {"-L1*q1-L2*(q1+q2)-L3*(q1+q2+q3)-L4*(q1+q2+q3+q4)", "-L2*(q1+q2)-L3*(q1+q2+q3)-L4*(q1+q2+q3+q4)",
        "-L3*(q1+q2+q3)-L4*(q1+q2+q3+q4)", "-L4*(q1+q2+q3+q4)", tails[0], tails[1], tails[2], tails[3]},
       small_jacobian_entries},
      {"eq-28-S1", "4.2, (27), (28)", "S1 has the entries -(L_m + … + L_n), m = max(i, j)", s1, s1_matrix},
      {"eq-28-S0", "4.2, (27), (28)", "S0 has the entries L_i + … + L_n", tails, s0_vector},
      {"eq-29", "4.2, (29)", "(22) becomes K q + S1 q F_x + S0 F_y = 0", {"+"}, linear_equilibrium},
      {"eq-30",
       "4.2, (30)",
       "delta_y = 0 is S0^T q = 0",
       {"(L1+L2+L3+L4)*q1+(L2+L3+L4)*q2+(L3+L4)*q3+L4*q4"},
       constraint},
      {"unknowns-nonlinear",
       "4.2, before (25)",
       "(22) with (21) are n+2 equations for n+2 unknowns",
       {"n+2 equations, n+2 unknowns"},
       nonlinear_counts},
      {"unknowns",
       "4.2, before (31)",
       "(29) and (30) are n+1 equations with n+2 unknowns",
       {"n+1 equations, n+2 unknowns"},
       counts},
      {"eq-31-33",
       "4.2, (31) to (33)",
       "(29) and (30) are (A F_x + B) v = 0 with the blocks of (33)",
       {"+"},
       blocks},
  };
}

}  // namespace plumbline::verify
