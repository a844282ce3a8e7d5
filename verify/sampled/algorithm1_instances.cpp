#include <plumbline/straight/algorithm1.hpp>

namespace plumbline {

template Matrix<Rational> algorithm1_matrix(const Chain<Rational>&);
template Matrix<Mpfr50> algorithm1_matrix(const Chain<Mpfr50>&);
template std::vector<Mode<double>> algorithm1(const Chain<double>&);
template std::vector<Mode<Mpfr50>> algorithm1(const Chain<Mpfr50>&);

}  // namespace plumbline
