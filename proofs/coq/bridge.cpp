/// \file
/// What the C++ core makes of rational chains, for comparison with what Coq's definitions make of them. One
/// line a chain and force: lengths; stiffnesses; force; A of (33); B of (33); D(F), coefficients from the
/// constant up; number of critical forces below the force.

#include <iostream>
#include <plumbline/chain/linearised.hpp>
#include <plumbline/straight/critical_force.hpp>
#include <random>

#include "proofs/exact/exact_chain.hpp"
#include "proofs/exact/exact_count.hpp"
#include "proofs/exact/exact_matrix.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

template <class Values>
void print(const Values& values) {
  const char* between = "";
  for (const Rational& x : values) {
    std::cout << between << x;
    between = " ";
  }
  std::cout << ';';
}

void print_matrix(const Matrix<Rational>& matrix) {
  std::vector<Rational> entries;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) entries.push_back(matrix(i, j));
  }
  print(entries);
}

void print_chain(const Chain<Rational>& chain, const Rational& F) {
  print(chain.length());
  print(chain.stiffness());
  print(std::vector{F});
  print_matrix(matrix_A(chain));
  print_matrix(matrix_B(chain));
  if (chain.size() == 1) {  // no buckling mode: neither recursion nor count
    print(pencil_determinant(matrix_B(chain), matrix_A(chain)));
    std::cout << "0\n";
    return;
  }
  print(recursion_polynomial(chain));
  if (count_below(chain, F) != ExactCount(chain).below(F)) throw Error("count", "two results", "one");
  std::cout << count_below(chain, F) << '\n';
}

}  // namespace

int main() {
  std::mt19937 random(1);
  const auto fraction = [&] { return Rational(1 + random() % 999, 1 + random() % 99); };
  for (std::size_t n = 1; n <= 8; ++n) {
    for (std::size_t passive = 0; passive <= n; ++passive) {  // n: none is
      std::vector<Rational> length, stiffness;
      for (std::size_t i = 0; i < n; ++i) {
        length.push_back(fraction());
        stiffness.push_back(i == passive ? Rational(0) : fraction());
      }
      const Chain<Rational> chain(length, stiffness);
      const Rational all = n == 1 ? Rational(7) : sum_of_forces(chain);  // one link has none
      for (const int part : {1000, 30, 10, 5, 3, 2, 1}) print_chain(chain, all / part);
    }
  }
  // a force that is itself critical is not below itself
  const Chain<Rational> tie({1, 1, 1}, {3, 0, 1});
  for (const Rational& F : {Rational(1), Rational(2), Rational(3)}) print_chain(tie, F);
}
