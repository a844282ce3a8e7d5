#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <plumbline/chain/linearised.hpp>

#include "benchmarks/peers.hpp"

extern "C" {
void dpttrf_(const int* n, double* d, double* e, int* info);
void dpttrs_(const int* n, const int* nrhs, const double* d, const double* e, double* b, const int* ldb,
             int* info);
void dstebz_(const char* range, const char* order, const int* n, const double* vl, const double* vu,
             const int* il, const int* iu, const double* abstol, const double* d, const double* e, int* m,
             int* nsplit, double* w, int* iblock, int* isplit, double* work, int* iwork, int* info);
void dsbgvx_(const char* jobz, const char* range, const char* uplo, const int* n, const int* ka,
             const int* kb, double* ab, const int* ldab, double* bb, const int* ldbb, double* q,
             const int* ldq, const double* vl, const double* vu, const int* il, const int* iu,
             const double* abstol, int* m, double* w, double* z, const int* ldz, double* work, int* iwork,
             int* ifail, int* info);
void dlasq1_(const int* n, double* d, double* e, double* work, int* info);
void dsygv_(const int* itype, const char* jobz, const char* uplo, const int* n, double* a, const int* lda,
            double* b, const int* ldb, double* w, double* work, const int* lwork, int* info);
void dggev_(const char* jobvl, const char* jobvr, const int* n, double* a, const int* lda, double* b,
            const int* ldb, double* alphar, double* alphai, double* beta, double* vl, const int* ldvl,
            double* vr, const int* ldvr, double* work, const int* lwork, int* info);
}

namespace plumbline::bench {
namespace {

std::size_t count(int n) {
  return static_cast<std::size_t>(n);
}
void require(int info, const char* routine) {
  if (info != 0) throw Error(routine, "info = " + std::to_string(info), "0");
}
double stiffness_behind(const detail::StringPiece<double>& string, std::size_t i) {
  return i < string.spacing.size() ? 1 / string.spacing[i] : 0;
}

Forces dstebz(const Chain<double>& chain, const char* range) {
  const detail::BeadString<double> whole(chain);
  const Tridiagonal T = tridiagonal(whole.pieces()[0]);
  const int n = static_cast<int>(T.diagonal.size()), first = 1, last = 1;
  const double none = 0;
  int found = 0, blocks = 0, info = 0;
  std::vector<double> w(count(n)), work(4 * count(n));
  std::vector<int> block(count(n)), split(count(n)), iwork(3 * count(n));
  dstebz_(range, "E", &n, &none, &none, &first, &last, &none, T.diagonal.data(), T.beside.data(), &found,
          &blocks, w.data(), block.data(), split.data(), work.data(), iwork.data(), &info);
  require(info, "dstebz");
  w.resize(count(found));
  return w;
}

}  // namespace

Tridiagonal tridiagonal(const detail::StringPiece<double>& string) {
  Tridiagonal T{std::vector<double>(string.size()), std::vector<double>(string.size())};
  double left = string.slope;
  for (std::size_t i = 0; i < string.size(); ++i) {
    const double right = stiffness_behind(string, i);
    T.diagonal[i] = (left + right) / string.mass[i];
    if (i + 1 < string.size()) T.beside[i] = -right / std::sqrt(string.mass[i] * string.mass[i + 1]);
    left = right;
  }
  return T;
}

Forces dpttrf_inverse_iteration(const StraightChain<double>& chain) {
  const detail::BeadString<double> whole(chain);
  Tridiagonal T = tridiagonal(whole.pieces()[0]);
  const int n = static_cast<int>(T.diagonal.size()), one = 1;
  int info = 0;
  dpttrf_(&n, T.diagonal.data(), T.beside.data(), &info);
  require(info, "dpttrf");
  std::vector<double> x(count(n), 1 / std::sqrt(static_cast<double>(n))), y;
  double force = 0;
  for (int iteration = 0; iteration < 1000; ++iteration) {
    y = x;
    dpttrs_(&n, &one, T.diagonal.data(), T.beside.data(), y.data(), &n, &info);
    double xy = 0, yy = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      xy += x[i] * y[i];
      yy += y[i] * y[i];
    }
    const double before = std::exchange(force, xy / yy), scale = 1 / std::sqrt(yy);
    for (std::size_t i = 0; i < y.size(); ++i) x[i] = y[i] * scale;
    if (std::abs(force - before) < 1e-14 * force) break;
  }
  return {force};
}

Forces dstebz_lowest(const Chain<double>& chain) {
  return dstebz(chain, "I");
}
Forces dstebz_all(const Chain<double>& chain) {
  return dstebz(chain, "A");
}

Forces dsbgvx_lowest(const Chain<double>& chain) {
  const detail::BeadString<double> whole(chain);
  const auto string = whole.pieces()[0];
  const int n = static_cast<int>(string.size()), one = 1, two = 2, band = 1, diagonal = 0;
  std::vector<double> K(2 * count(n)), M(string.mass.begin(), string.mass.end());
  double left = string.slope;
  for (std::size_t i = 0; i < string.size(); ++i) {
    const double right = stiffness_behind(string, i);
    K[2 * i + 1] = left + right;
    K[2 * i] = -left;  // above the diagonal; the first is not used
    left = right;
  }
  const double none = 0;
  int found = 0, info = 0;
  std::vector<double> w(count(n)), work(7 * count(n)), q(1), z(1);
  std::vector<int> iwork(5 * count(n)), fail(count(n));
  dsbgvx_("N", "I", "U", &n, &band, &diagonal, K.data(), &two, M.data(), &one, q.data(), &one, &none, &none,
          &one, &one, &none, &found, w.data(), z.data(), &one, work.data(), iwork.data(), fail.data(), &info);
  require(info, "dsbgvx");
  return {w[0]};
}

/// K = L D L^T without a subtraction, so that the bidiagonal D^1/2 L^T M^-1/2 keeps all digits.
Forces dlasq1_all(const Chain<double>& chain) {
  const detail::BeadString<double> whole(chain);
  const auto string = whole.pieces()[0];
  const int n = static_cast<int>(string.size());
  std::vector<double> d(count(n)), e(count(n)), work(4 * count(n));
  double left = string.slope;
  for (std::size_t i = 0; i < string.size(); ++i) {
    const double right = stiffness_behind(string, i), pivot = left + right;
    d[i] = std::sqrt(pivot / string.mass[i]);
    if (i + 1 < string.size()) e[i] = right / std::sqrt(pivot * string.mass[i + 1]);
    left *= right / pivot;
  }
  int info = 0;
  dlasq1_(&n, d.data(), e.data(), work.data(), &info);
  require(info, "dlasq1");
  for (double& value : d) value *= value;
  std::reverse(d.begin(), d.end());
  return d;
}

namespace {

/// Factors of K - F G by dsbgvx on G w = w K / F, whose largest eigenvalues are those of the lowest F.
Forces dsbgvx(StraightPencil<double> pencil, const char* range) {
  const int n = static_cast<int>(pencil.size()), one = 1, three = 3, band = 2;
  const double none = 0;
  int found = 0, info = 0;
  std::vector<double> w(count(n)), work(7 * count(n)), q(1), z(1);
  std::vector<int> iwork(5 * count(n)), fail(count(n));
  dsbgvx_("N", range, "L", &n, &band, &band, pencil.load.data(), &three, pencil.stiffness.data(), &three,
          q.data(), &one, &none, &none, &n, &n, &none, &found, w.data(), z.data(), &one, work.data(),
          iwork.data(), fail.data(), &info);
  require(info, "dsbgvx");
  Forces factors;
  for (int i = found; i-- > 0 && w[count(i)] > 0;) factors.push_back(1 / w[count(i)]);
  return factors;
}

}  // namespace

Forces dsbgvx_lowest_of_pencil(const StraightPencil<double>& pencil) {
  return dsbgvx(pencil, "I");
}
Forces dsbgvx_all_of_pencil(const StraightPencil<double>& pencil) {
  return dsbgvx(pencil, "A");
}

Forces dsygv_all_of_pencil(const StraightPencil<double>& pencil) {
  const int n = static_cast<int>(pencil.size()), one = 1, room = 64 * n;
  const auto dense = [&](const Band<double, 2>& band) {
    std::vector<double> all(count(n) * count(n));
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index d = 0; d <= 2 && i + d < n; ++d)
        all[static_cast<std::size_t>(i * n + i + d)] = band(d, i);
    }
    return all;
  };
  std::vector<double> G = dense(pencil.load), K = dense(pencil.stiffness), w(count(n)), work(count(room));
  int info = 0;
  dsygv_(&one, "N", "L", &n, G.data(), &n, K.data(), &n, w.data(), work.data(), &room, &info);
  require(info, "dsygv");
  Forces factors;
  for (int i = n; i-- > 0 && w[count(i)] > 0;) factors.push_back(1 / w[count(i)]);
  return factors;
}

Forces dsygv_all(const Chain<double>& chain) {
  const detail::BeadString<double> whole(chain);
  const auto string = whole.pieces()[0];
  const int n = static_cast<int>(string.size()), one = 1, room = 64 * n;
  std::vector<double> K(count(n) * count(n)), M(K.size()), w(count(n)), work(count(room));
  double left = string.slope;
  for (std::size_t i = 0; i < string.size(); ++i) {
    const double right = stiffness_behind(string, i);
    K[i * string.size() + i] = left + right;
    if (i > 0) K[i * string.size() + i - 1] = -left;
    M[i * string.size() + i] = string.mass[i];
    left = right;
  }
  int info = 0;
  dsygv_(&one, "N", "U", &n, K.data(), &n, M.data(), &n, w.data(), work.data(), &room, &info);
  require(info, "dsygv");
  return w;
}

Forces dggev_all(const Chain<double>& chain) {
  Matrix<double> A = matrix_A(chain), B = matrix_B(chain);
  const int n = static_cast<int>(A.rows()), one = 1, room = 64 * n;
  std::vector<double> real(count(n)), imaginary(count(n)), beta(count(n)), work(count(room)), none(1);
  int info = 0;
  dggev_("N", "N", &n, A.data(), &n, B.data(), &n, real.data(), imaginary.data(), beta.data(), none.data(),
         &one, none.data(), &one, work.data(), &room, &info);
  require(info, "dggev");
  std::vector<double> lambda(count(n));
  for (std::size_t i = 0; i < lambda.size(); ++i) lambda[i] = real[i] / beta[i];
  std::sort(lambda.begin(), lambda.end());  // most negative first: F = -1 / lambda
  Forces forces;
  for (std::size_t m = 0; m + 2 < lambda.size(); ++m) forces.push_back(-1 / lambda[m]);
  return forces;
}

}  // namespace plumbline::bench
