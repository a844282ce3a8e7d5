#pragma once
/// \file
/// Chains under loadings, for the tests of what is proved of their paths.

#include <doctest/doctest.h>

#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>

#include "proofs/exact/as_double.hpp"
#include "proofs/paths/certified_path.hpp"

namespace plumbline::proofs::test {

using Nominal = NominalModel<double>;

inline Interval decimal(int digits, int unit) {
  return Interval(Rational(digits, unit));
}

inline std::vector<Interval> random_decimals(std::mt19937& random, std::size_t n, int low, int high,
                                             int unit) {
  std::uniform_int_distribution<int> any(low, high);
  std::vector<Interval> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(decimal(any(random), unit));
  return values;
}

/// A chain under a loading, enclosed and in double precision.
struct Loaded {
  Chain<Interval> chain;
  Loading<Interval> loading;
  Nominal model;
  Vector<double> shape;
  Brancher<Nominal> brancher;

  Loaded(Chain<Interval> chain_, Loading<Interval> loading_, const std::vector<double>& q)
      : chain(std::move(chain_)),
        loading(std::move(loading_)),
        model(convert<double>(chain, as_double)),
        shape(absolute_angles(q)),
        brancher(model,
                 {loading.control,
                  {as_double(loading.start.x), as_double(loading.start.y)},
                  {as_double(loading.direction.x), as_double(loading.direction.y)}},
                 shape) {}
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;

  Branch<double> follow(double to) {
    return Tracer<Nominal>(brancher, {0, to}).run(brancher.start(0, shape));
  }
  [[nodiscard]] PathCertificate certificate(const Branch<double>& branch) const {
    return certify(chain, loading, branch);
  }
};

inline std::vector<double> rest_of(const Chain<Interval>& chain) {
  std::vector<double> q;
  for (const Interval& angle : chain.rest()) q.push_back(as_double(angle));
  return q;
}

/// Pushed along -x from its unloaded shape.
inline Loaded compressed(const Chain<Interval>& chain) {
  return {chain,
          {Control::end_point, end_point(chain, chain.rest()), {Interval(-1), Interval(0)}},
          rest_of(chain)};
}

inline Loaded z_chain() {
  return {Chain<Interval>(
              {1, 1, 1, 1}, {1, 1, 1, 1},
              {decimal(-2417, 10000), decimal(6821, 10000), decimal(-7958, 10000), decimal(517, 1000)}),
          {Control::end_point, {decimal(38, 10), Interval(0)}, {Interval(-1), Interval(0)}},
          {-0.2417, 0.6821, -0.7958, 0.5170}};
}

/// The zigzag with a passive base of Fig. 8, its end point on the x axis; off the symmetric one by an angle.
inline Loaded zigzag(double off) {
  const Interval angle = Interval::pi() / Interval(10), first = angle + Interval::from_double(off);
  const Chain<Interval> chain({1, 1, 1}, {0, 1, 1}, {0, first, -angle});
  const Point<Interval> p = end_point(chain, chain.rest());
  std::vector<double> q = rest_of(chain);
  q[0] = -std::atan2(as_double(p.y), as_double(p.x));
  return {
      chain, {Control::end_point, {sqrt(sqr(p.x) + sqr(p.y)), Interval(0)}, {Interval(-1), Interval(0)}}, q};
}

/// One unit link under the compression 6/5, pushed aside.
inline Loaded one_link() {
  return {Chain<Interval>({1}, {1}),
          {Control::force, {decimal(-6, 5), Interval(0)}, {Interval(0), Interval(-1)}},
          {1}};
}

}  // namespace plumbline::proofs::test
