#include "benchmarks/flint_peers.hpp"

#include <acb_mat.h>
#include <arb_fmpz_poly.h>
#include <arb_poly.h>
#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>

#include <algorithm>
#include <cmath>

namespace plumbline::bench {
namespace {

slong bits_of(int digits) {
  return static_cast<slong>(std::ceil(digits * std::log2(10.0))) + 2;
}

/// Complex balls.
class ComplexBalls {
 public:
  explicit ComplexBalls(slong count) : data_(_acb_vec_init(count)), count_(count) {}
  ~ComplexBalls() { _acb_vec_clear(data_, count_); }
  ComplexBalls(const ComplexBalls&) = delete;
  ComplexBalls& operator=(const ComplexBalls&) = delete;

  [[nodiscard]] acb_ptr data() const { return data_; }
  /// The real parts, of what is known to be real.
  [[nodiscard]] Balls real_parts() const;

 private:
  acb_ptr data_;
  slong count_;
};

/// A square matrix of them.
struct ComplexMatrix {
  explicit ComplexMatrix(slong size) { acb_mat_init(data, size, size); }
  ~ComplexMatrix() { acb_mat_clear(data); }
  ComplexMatrix(const ComplexMatrix&) = delete;
  ComplexMatrix& operator=(const ComplexMatrix&) = delete;

  acb_mat_t data;
};

struct IntegerPolynomial {
  IntegerPolynomial() { fmpz_poly_init(data); }
  ~IntegerPolynomial() { fmpz_poly_clear(data); }
  IntegerPolynomial(const IntegerPolynomial&) = delete;
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;

  fmpz_poly_t data;
};

struct FlintInteger {
  explicit FlintInteger(const Integer& x) {
    fmpz_init(data);
    fmpz_set_mpz(data, x.backend().data());
  }
  ~FlintInteger() { fmpz_clear(data); }
  FlintInteger(const FlintInteger&) = delete;
  FlintInteger& operator=(const FlintInteger&) = delete;

  fmpz_t data;
};

/// Lengths and stiffnesses, multiplied by their common denominator, which leaves the critical forces alone.
struct IntegerChain {
  std::vector<Integer> length, stiffness, distance;

  explicit IntegerChain(const Chain<Rational>& chain) : distance(chain.size()) {
    Integer common(1);
    for (const auto* list : {&chain.length(), &chain.stiffness()}) {
      for (const Rational& x : *list) common = lcm(common, mp::denominator(x));
    }
    const auto cleared = [&](const Rational& x) { return Integer(mp::numerator(Rational(x * common))); };
    std::transform(chain.length().begin(), chain.length().end(), std::back_inserter(length), cleared);
    std::transform(chain.stiffness().begin(), chain.stiffness().end(), std::back_inserter(stiffness),
                   cleared);
    Integer sum(0);
    for (std::size_t i = length.size(); i-- > 0;) distance[i] = sum += length[i];
  }
};

/// D(F), up to a factor, by the recursion of proofs/exact/exact_count.hpp.
void characteristic(IntegerPolynomial& result, const Chain<Rational>& given) {
  const IntegerChain chain(given);
  IntegerPolynomial h, M, t, part;
  fmpz_poly_set_fmpz(h.data, FlintInteger(chain.distance[0]).data);
  fmpz_poly_set_fmpz(M.data, FlintInteger(chain.stiffness[0]).data);
  for (std::size_t i = 0; i + 1 < chain.length.size(); ++i) {
    const FlintInteger L(chain.length[i]), z(chain.distance[i]), behind(chain.distance[i + 1]),
        k(chain.stiffness[i + 1]);
    fmpz_poly_scalar_mul_fmpz(t.data, M.data, behind.data);
    fmpz_poly_scalar_mul_fmpz(part.data, h.data, L.data);
    fmpz_poly_shift_left(part.data, part.data, 1);
    fmpz_poly_sub(t.data, t.data, part.data);
    fmpz_poly_scalar_mul_fmpz(h.data, h.data, z.data);
    fmpz_poly_scalar_mul_fmpz(h.data, h.data, k.data);
    fmpz_poly_scalar_addmul_fmpz(h.data, t.data, behind.data);
    fmpz_poly_scalar_mul_fmpz(M.data, t.data, k.data);
  }
  fmpz_poly_primitive_part(result.data, h.data);
}

void set(acb_ptr ball, const Rational& x, slong precision) {
  fmpq_t fraction;
  fmpq_init(fraction);
  fmpq_set_mpq(fraction, x.backend().data());
  acb_set_fmpq(ball, fraction, precision);
  fmpq_clear(fraction);
}

/// M^-1 K of the string with beads (<plumbline/straight/bead_string.hpp>).
void set_string_matrix(ComplexMatrix& matrix, const Chain<Rational>& chain, slong precision) {
  const auto z = distance_to_end(chain);
  const auto tension = [&](std::size_t i) { return Rational(chain.stiffness()[i] / (z[i] * z[i])); };
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Rational per_mass = z[i] * z[i + 1] / chain.length()[i], left = tension(i), right = tension(i + 1);
    const auto row = static_cast<slong>(i);
    set(acb_mat_entry(matrix.data, row, row), (left + right) * per_mass, precision);
    if (i > 0) set(acb_mat_entry(matrix.data, row, row - 1), -left * per_mass, precision);
    if (i + 2 < chain.size()) set(acb_mat_entry(matrix.data, row, row + 1), -right * per_mass, precision);
  }
}

}  // namespace

struct Balls::Data {
  explicit Data(std::size_t size) : count(static_cast<slong>(size)), ball(_arb_vec_init(count)) {}
  ~Data() { _arb_vec_clear(ball, count); }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;

  slong count;
  arb_ptr ball;
};

Balls ComplexBalls::real_parts() const {
  Balls result(static_cast<std::size_t>(count_));
  const arb_ptr ball = result.data().ball;
  for (slong i = 0; i < count_; ++i) arb_set(ball + i, acb_realref(data_ + i));
  std::sort(ball, ball + count_,
            [](const arb_struct& a, const arb_struct& b) { return arb_lt(&a, &b) != 0; });
  return result;
}

Balls::Balls(std::size_t count) : data_(std::make_shared<Data>(count)) {}

std::vector<double> Balls::middles() const {
  std::vector<double> result;
  for (slong i = 0; i < data_->count; ++i)
    result.push_back(arf_get_d(arb_midref(data_->ball + i), ARF_RND_NEAR));
  return result;
}

bool Balls::reach(int digits) const {
  return std::all_of(data_->ball, data_->ball + data_->count, [&](const arb_struct& ball) {
    return arb_rel_accuracy_bits(&ball) >= bits_of(digits) - 1;
  });
}

bool Balls::agree(const std::vector<std::string>& decimals, int digits) const {
  if (decimals.size() != static_cast<std::size_t>(data_->count)) return false;
  const slong precision = bits_of(digits) + 64;
  arb_t given, half_unit;
  arb_init(given);
  arb_init(half_unit);
  bool all = true;
  for (slong i = 0; i < data_->count; ++i) {
    arb_set_str(given, decimals[static_cast<std::size_t>(i)].c_str(), precision);
    // half a unit in the last digit is at most 5 units of 10^-digits, relatively
    arb_set_str(half_unit, ("5e-" + std::to_string(digits)).c_str(), precision);
    arb_mul(half_unit, half_unit, given, precision);
    arb_add_error(given, half_unit);
    all = all && arb_overlaps(given, data_->ball + i) != 0;
  }
  arb_clear(given);
  arb_clear(half_unit);
  return all;
}

Balls polynomial_roots(const Chain<Rational>& chain, int digits, long /*guard*/) {
  IntegerPolynomial D;
  characteristic(D, chain);
  const ComplexBalls roots(fmpz_poly_degree(D.data));
  arb_fmpz_poly_complex_roots(roots.data(), D.data, 0, bits_of(digits));
  return roots.real_parts();
}

Balls refined_roots(const Chain<Rational>& chain, int digits, long guard) {
  IntegerPolynomial D;
  characteristic(D, chain);
  const ComplexBalls roots(fmpz_poly_degree(D.data));
  arb_fmpz_poly_complex_roots(roots.data(), D.data, 0, guard);
  const Balls start = roots.real_parts();
  Balls result(static_cast<std::size_t>(start.data().count));
  const slong precision = bits_of(digits);
  arb_poly_t in_balls;
  arb_poly_init(in_balls);
  arb_poly_set_fmpz_poly(in_balls, D.data, precision + guard);
  arf_t factor;
  arf_init(factor);
  for (slong i = 0; i < start.data().count; ++i) {
    const arb_srcptr near = start.data().ball + i;
    arb_set(result.data().ball + i, near);
    _arb_poly_newton_convergence_factor(factor, in_balls->coeffs, in_balls->length, near, 2 * guard);
    if (arf_is_nan(factor) || arf_cmpabs_2exp_si(factor, guard) > 0) continue;
    if (arb_rel_accuracy_bits(near) >= precision) continue;
    _arb_poly_newton_refine_root(result.data().ball + i, in_balls->coeffs, in_balls->length, near, near,
                                 factor, guard, precision);
  }
  arf_clear(factor);
  arb_poly_clear(in_balls);
  return result;
}

Balls matrix_eigenvalues(const Chain<Rational>& chain, int digits, long guard) {
  const auto size = static_cast<slong>(chain.size()) - 1;
  const slong precision = bits_of(digits) + guard;
  ComplexMatrix matrix(size), vectors(size);
  set_string_matrix(matrix, chain, precision);
  const ComplexBalls near(size), values(size);
  acb_mat_approx_eig_qr(near.data(), nullptr, vectors.data, matrix.data, nullptr, 0, precision);
  acb_mat_eig_simple(values.data(), nullptr, nullptr, matrix.data, near.data(), vectors.data, precision);
  return values.real_parts();
}

}  // namespace plumbline::bench
