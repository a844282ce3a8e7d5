// The theorems of proofs/theorems.md that go beyond the linearised chain, against expansions of the exact
// equations.

#include <doctest/doctest.h>

#include <plumbline/straight/buckling_mode.hpp>

#include "proofs/exact/symbolic_chain.hpp"

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::possymbol;
using GiNaC::symbol;

namespace {

ex coefficient(const ex& e, const symbol& x, int power) {
  return GiNaC::series_to_poly(e.series(x == 0, power + 1)).expand().coeff(x, power).normal();
}

bool equal(const ex& a, const ex& b) {
  return (a - b).normal().expand().is_zero();
}

/// F^(2) of theorem "Supercritical" for the mode as it is scaled.
double initial_curvature(const Chain<double>& chain, const Mode<double>& mode) {
  double phi = 0, square = 0, cube = 0, fourth = 0;
  for (std::size_t j = 0; j < chain.size(); ++j) {
    phi += mode.q[j];
    square += chain.length()[j] * phi * phi;
    cube += chain.length()[j] * phi * phi * phi;
    fourth += chain.length()[j] * phi * phi * phi * phi;
  }
  const double c = chain.stiffness()[0] * mode.q[0] / distance_to_end(chain)[0];
  return (mode.force * fourth / 6 + 2 * c * cube / 3) / square;
}

/// x_i = phi + a of the proof of "Equal links are supercritical", a = c / F.
struct FreeEnd {
  FreeEnd(const Chain<double>& chain, const Mode<double>& mode)
      : a(chain.stiffness()[0] * mode.q[0] / static_cast<double>(chain.size()) / mode.force) {
    for (const double phi : orientations(mode.q)) {
      x.push_back(phi + a);
      square += phi * phi / static_cast<double>(chain.size());
    }
  }
  [[nodiscard]] double mean(int power) const {
    double sum = 0;
    for (const double one : x) sum += std::pow(one, power);
    return sum / static_cast<double>(x.size());
  }

  double a, square = 0;
  std::vector<double> x;
};

}  // namespace

TEST_CASE("Equal links are supercritical: the polynomials of two, three and four links above F = 4") {
  const symbol z("z");
  const std::vector<ex> turns{1, -(3 + 2 * z), 5 + 10 * z + 4 * pow(z, 2),
                              -(7 + 28 * z + 28 * pow(z, 2) + 8 * pow(z, 3))};
  for (int n = 2; n <= 4; ++n) {
    const auto mean = [&](int power) {
      ex sum = 0;
      for (int i = 0; i < n; ++i) sum += pow(turns[static_cast<std::size_t>(i)], power);
      return ex(sum / n);
    };
    const ex a = mean(1), sign = (mean(4) - 6 * pow(a, 2) * mean(2) + 5 * pow(a, 4)).expand();
    for (int power = 0; power <= sign.degree(z); ++power)
      CHECK(sign.coeff(z, power).info(GiNaC::info_flags::positive));
    if (n == 2) CHECK((sign - pow(2 + z, 4)).expand().is_zero());
    if (n > 2) CHECK(sign.coeff(z, 0) == (n == 3 ? ex(512) / 3 : ex(656)));
  }
}

TEST_CASE("Equal links are supercritical: every mode, on a base of any stiffness") {
  for (std::size_t n = 2; n <= 100; ++n) {
    for (const double base : {0.0, 1e-6, 0.3, 1.0, 1.9, 2.0}) {
      CAPTURE(n);
      CAPTURE(base);
      std::vector<double> stiffness(n, 1);
      stiffness[0] = base;
      const Chain<double> chain(std::vector<double>(n, 1), stiffness);
      bool positive = true;
      for (const auto& mode : critical_modes(chain, n)) {
        const FreeEnd w(chain, mode);
        const double means = w.mean(4) - 6 * w.a * w.a * w.mean(2) + 5 * std::pow(w.a, 4);
        // a mode of 100 links is exact to a few thousand roundings
        CHECK(6 * initial_curvature(chain, mode) * w.square / mode.force == close_to(means).epsilon(1e-9));
        positive = positive && initial_curvature(chain, mode) > 0 && w.mean(2) > 5 * w.a * w.a &&
                   mode.force * static_cast<double>(n * n) > 8 - 1e-9 && mode.force < 4;
      }
      CHECK(positive);
    }
  }
  // a stiffer base: in its highest mode links turn against each other, the last the most
  for (std::size_t n = 2; n <= 40; ++n) {
    for (const double base : {2.001, 2.5, 4.0, 4.001, 7.0, 100.0, 1e4}) {
      CAPTURE(n);
      CAPTURE(base);
      std::vector<double> stiffness(n, 1);
      stiffness[0] = base;
      const Chain<double> chain(std::vector<double>(n, 1), stiffness);
      bool positive = true;
      for (const auto& mode : critical_modes(chain, n)) {
        const FreeEnd w(chain, mode);
        positive = positive && initial_curvature(chain, mode) > 0 && (n < 5 || w.mean(2) > 5 * w.a * w.a);
      }
      CHECK(positive);
    }
  }
  const Chain<double> falling({2, 1}, {1, 0.1});
  CHECK(initial_curvature(falling, critical_modes(falling, 1)[0]) < 0);
}

TEST_CASE("Supercritical: the initial slope of two links, from the exact energy") {
  const symbol t("t");  // theta_1
  const possymbol L1("L1"), L2("L2"), k1("k1"), k2("k2");
  // L1 sin t + L2 sin theta_2 = 0; theta_2 as a series of asin
  const ex sine = -(L1 / L2) * (t - pow(t, 3) / 6 + pow(t, 5) / 120);
  const ex theta2 = sine + pow(sine, 3) / 6 + 3 * pow(sine, 5) / 40;
  const ex energy = k1 * pow(t, 2) / 2 + k2 * pow(theta2 - t, 2) / 2;
  const ex shortening =
      L1 * (pow(t, 2) / 2 - pow(t, 4) / 24) + L2 * (pow(theta2, 2) / 2 - pow(theta2, 4) / 24);
  const ex force = energy.diff(t) / shortening.diff(t);  // good up to t^3
  const ex F1 = coefficient(force, t, 0), F2 = coefficient(force, t, 2);

  // the theorem, with phi = (1, -L1 / L2), that is a = theta_1 up to a^3
  const ex phi = -L1 / L2;
  const ex c = k1 / (L1 + L2);
  const ex square = L1 + L2 * pow(phi, 2), cube = L1 + L2 * pow(phi, 3), fourth = L1 + L2 * pow(phi, 4);
  CHECK(equal(F1, (k1 / pow(L1, 2) + k2 * pow(1 / L1 + 1 / L2, 2)) / (1 / L1 + 1 / L2)));
  CHECK(equal(F2, (F1 * fourth / 6 + ex(2) / 3 * c * cube) / square));
  CHECK_FALSE(equal(F2, (F1 * fourth / 6 + ex(1) / 2 * c * cube) / square));

  const ex rho = L1 / L2;
  CHECK(equal(F2.subs(k2 == 0), F1.subs(k2 == 0) * (ex(1) / 6 - rho * (rho - 1) / 2)));
  // the example: a = phi_1 t with phi_1 = 1 / L1 there
  const ex example = F2.subs(GiNaC::lst{L1 == 2, L2 == 1, k1 == 1}) / 4;
  CHECK(equal(example, (27 * k2 - 5) / 144));
  CHECK(example.subs(k2 == ex(1) / 10).info(GiNaC::info_flags::negative));
}

TEST_CASE("Supercritical: a mode of three links satisfies the expansion to third order") {
  // Unit lengths on a passive base, k_2 = k_3 = 1: phi = (1, 0, -1), F_1 = 1, c = 0. The theorem says F2 =
  // 1/6; psi solves the third-order equations.
  const symbol a("a"), p("p"), q("q"), r("r"), d("d");
  const std::vector<ex> theta{a + p * pow(a, 3), q * pow(a, 3), -a + r * pow(a, 3)};
  const auto residuals = [&](const ex& slope) {
    const ex F = 1 + slope * pow(a, 2), f = d * pow(a, 3);
    const std::vector<ex> torque{theta[0] - theta[1], 2 * theta[1] - theta[0] - theta[2],
                                 theta[2] - theta[1]};
    GiNaC::lst equations;
    ex y = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      y += sin(theta[j]);
      equations.append(coefficient(torque[j] - F * sin(theta[j]) - f * cos(theta[j]), a, 3) == 0);
    }
    equations.append(coefficient(y, a, 3) == 0);
    return GiNaC::lsolve(equations, GiNaC::lst{p, q, r, d});
  };
  CHECK(residuals(ex(1) / 6).nops() == 4);
  CHECK(residuals(ex(1) / 5).nops() == 0);
}

TEST_CASE("Decomposition: directions of links under axes in two orthogonal directions, in any order") {
  const symbol e("e");
  const auto about_z = [&](const ex& angle) {
    return matrix{{cos(e * angle), -sin(e * angle), 0}, {sin(e * angle), cos(e * angle), 0}, {0, 0, 1}};
  };
  const auto about_minus_y = [&](const ex& angle) {
    return matrix{{cos(e * angle), 0, -sin(e * angle)}, {0, 1, 0}, {sin(e * angle), 0, cos(e * angle)}};
  };
  const auto about_x = [&](const ex& angle) {
    return matrix{{1, 0, 0}, {0, cos(e * angle), -sin(e * angle)}, {0, sin(e * angle), cos(e * angle)}};
  };
  const symbol a1("a1"), b1("b1"), a2("a2"), b2("b2"), twist("twist");
  const matrix turn =
      about_z(a1).mul(about_minus_y(b1)).mul(about_x(twist)).mul(about_minus_y(b2)).mul(about_z(a2));
  const matrix direction = turn.mul(matrix{{1}, {0}, {0}});
  CHECK(equal(coefficient(direction(1, 0), e, 1), a1 + a2));
  CHECK(equal(coefficient(direction(2, 0), e, 1), b1 + b2));
  const ex shortening = coefficient(1 - direction(0, 0), e, 2);
  CHECK(equal(shortening, (pow(a1 + a2, 2) + pow(b1 + b2, 2)) / 2));
  CHECK_FALSE(equal(shortening, (pow(a1 + a2 + b1 + b2, 2)) / 2));
}

TEST_CASE("Prismatic joints: the bordered Hessian of two yielding links on a passive base") {
  const symbol t1("t1"), t2("t2"), e1("e1"), e2("e2");
  const possymbol L("L"), k("k"), kappa("kappa"), F("F");
  const ex potential = k * pow(t2 - t1, 2) / 2 + kappa * (pow(e1, 2) + pow(e2, 2)) / 2 +
                       F * ((L - e1) * cos(t1) + (L - e2) * cos(t2));
  const ex y = (L - e1) * sin(t1) + (L - e2) * sin(t2);
  const std::vector<symbol> free{t1, t2, e1, e2};
  const GiNaC::lst straight{t1 == 0, t2 == 0, e1 == F / kappa, e2 == F / kappa};
  matrix bordered(5, 5);
  for (unsigned i = 0; i < 4; ++i) {
    CHECK(potential.diff(free[i]).subs(straight).is_zero());  // an equilibrium without any lateral force
    for (unsigned j = 0; j < 4; ++j) bordered(i, j) = potential.diff(free[i]).diff(free[j]).subs(straight);
    bordered(i, 4) = bordered(4, i) = y.diff(free[i]).subs(straight);
  }
  const ex det = expanded_determinant(bordered);
  const ex length = L - F / kappa;
  CHECK(equal(det, 2 * pow(kappa, 2) * pow(length, 2) * (F * length - 2 * k)));
  CHECK_FALSE(equal(det, 2 * pow(kappa, 2) * pow(length, 2) * (F * L - 2 * k)));
  // F (L - F / kappa) = 2 k has no real root below kappa = 8 k / L^2, where it has a double one
  const ex discriminant = pow(L, 2) - 8 * k / kappa;
  CHECK(discriminant.subs(kappa == 8 * k / pow(L, 2)).is_zero());
  CHECK(equal((F * length).subs(F == kappa * L / 2), kappa * pow(L, 2) / 4));  // the largest left side
}

TEST_CASE("Axial gravity: critical force and lateral stiffness of two upright links") {
  const symbol t1("t1"), t2("t2"), f("f");
  const possymbol L1("L1"), L2("L2"), k1("k1"), k2("k2"), F("F"), G1("G1"), G2("G2"), r1("r1"), r2("r2");
  const ex weights = G1 * r1 * L1 * cos(t1) + G2 * (L1 * cos(t1) + r2 * L2 * cos(t2));
  const ex potential =
      k1 * pow(t1, 2) / 2 + k2 * pow(t2 - t1, 2) / 2 + weights + F * (L1 * cos(t1) + L2 * cos(t2));
  const GiNaC::lst straight{t1 == 0, t2 == 0};
  const auto hessian = [&](const symbol& a, const symbol& b) {
    return potential.diff(a).diff(b).subs(straight);
  };
  const matrix bordered{
      {hessian(t1, t1), hessian(t1, t2), L1}, {hessian(t2, t1), hessian(t2, t2), L2}, {L1, L2, 0}};
  const ex w1 = r1 * G1 + G2, w2 = r2 * G2;
  const ex without = (k1 / pow(L1, 2) + k2 * pow(1 / L1 + 1 / L2, 2)) / (1 / L1 + 1 / L2);
  const ex with = without - (w1 / L1 + w2 / L2) / (1 / L1 + 1 / L2);  // a mean of w_1 and w_2 less
  const ex det = expanded_determinant(bordered);
  CHECK(equal(det.subs(F == with), 0));
  CHECK_FALSE(equal(det.subs(F == without), 0));

  // one link: the lateral stiffness is the Hessian over L^2
  const ex one = k1 * pow(t1, 2) / 2 + r1 * G1 * L1 * cos(t1);
  CHECK(equal(one.diff(t1).diff(t1).subs(t1 == 0) / pow(L1, 2), (k1 - r1 * G1 * L1) / pow(L1, 2)));
}
