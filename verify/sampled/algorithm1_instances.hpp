#pragma once
/// \file
/// Algorithm 1 in the number types of the checks, compiled once: Eigen's eigenvalues in 50 digits take a
/// compiler longer than everything else in a file.

#include <plumbline/straight/algorithm1.hpp>

namespace plumbline {

extern template Matrix<Rational> algorithm1_matrix(const Chain<Rational>&);
extern template Matrix<Mpfr50> algorithm1_matrix(const Chain<Mpfr50>&);
extern template std::vector<Mode<double>> algorithm1(const Chain<double>&);
extern template std::vector<Mode<Mpfr50>> algorithm1(const Chain<Mpfr50>&);

}  // namespace plumbline
