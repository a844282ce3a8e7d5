#pragma once
/// \file
/// Other ways to critical forces: LAPACK and Spectra on the string's form of the problem, which this project
/// found (bead_string.hpp), and general solvers on the paper's form.

#include <plumbline/straight/bead_string.hpp>
#include <plumbline/straight/pencil.hpp>
#include <vector>

namespace plumbline::bench {

using Forces = std::vector<double>;

/// 50 digits as Boost hands them out, on the heap; Mpfr50 is kept in place.
using StockMpfr50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;

/// The symmetric tridiagonal matrix M^-1/2 K M^-1/2 of a string.
struct Tridiagonal {
  std::vector<double> diagonal, beside;
};
Tridiagonal tridiagonal(const detail::StringPiece<double>& string);

// lapack.cpp: lowest force, each from a chain without interior passive joint
Forces dpttrf_inverse_iteration(const StraightChain<double>& chain);
Forces dstebz_lowest(const Chain<double>& chain);
Forces dsbgvx_lowest(const Chain<double>& chain);
// lapack.cpp: all forces
Forces dlasq1_all(const Chain<double>& chain);
Forces dstebz_all(const Chain<double>& chain);
Forces dsygv_all(const Chain<double>& chain);
Forces dggev_all(const Chain<double>& chain);  ///< of the pencil (33)

// lapack.cpp: factors of a structure's pencil
Forces dsbgvx_lowest_of_pencil(const StraightPencil<double>& pencil);
Forces dsbgvx_all_of_pencil(const StraightPencil<double>& pencil);
Forces dsygv_all_of_pencil(const StraightPencil<double>& pencil);

// algorithm1_peers.cpp
Forces spectra_lowest(const Chain<double>& chain);               ///< shift and invert about 0
Forces eigen_self_adjoint_all(const Chain<double>& chain);       ///< generalised, on (K, M)
Forces eigen_algorithm1_all(const Chain<double>& chain);         ///< eigenvalues only
double eigen_algorithm1_four_links(const Chain<double>& chain);  ///< the lowest, with matrices of fixed size
double eigen_algorithm1_lowest(const Chain<Mpfr50>& chain);      ///< eigenvalues only
double eigen_algorithm1_lowest(const Chain<StockMpfr50>& chain);

}  // namespace plumbline::bench

template <>
struct Eigen::NumTraits<plumbline::bench::StockMpfr50>
    : plumbline::EigenScalar<plumbline::bench::StockMpfr50> {};
