#pragma once
/// \file
/// Printed formulas as symbolic expressions, and decisions about them.
///
/// GiNaC is not thread-safe: use it from one thread.

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace plumbline::proofs {

/// A set of named symbols in which printed formulas are read.
class Formulas {
 public:
  /// \param names the symbols that may occur, such as {"F", "L", "phi"}
  explicit Formulas(const std::vector<std::string>& names);

  /// The symbol of that name.
  /// \throws Error for a name that was not declared
  [[nodiscard]] GiNaC::ex symbol(const std::string& name) const;

  /// Reads a formula in the usual notation (+ - * / ^, sin, cos, Pi).
  /// \throws Error that quotes the text where it cannot be read or uses another symbol
  [[nodiscard]] GiNaC::ex parse(const std::string& text) const;

 private:
  GiNaC::symtab symbols_;
};

/// Whether a and b are equal for all values of their symbols. Decided exactly for rational functions of the
/// symbols and of the sines and cosines of integer combinations of them: each symbol's half-angle tangent
/// makes those rational, and symbol and tangent are algebraically independent.
/// \throws Error for other
/// functions of the symbols
bool identical(const GiNaC::ex& a, const GiNaC::ex& b);

/// Whether a = c b for a number c other than zero.
bool proportional(const GiNaC::ex& a, const GiNaC::ex& b);

/// The coefficient of x^power in the Laurent series of e around x = 0.
GiNaC::ex series_coefficient(const GiNaC::ex& e, const GiNaC::ex& x, int power);

/// The limit for x → 0.
/// \throws Error where it is infinite
GiNaC::ex limit_at_zero(const GiNaC::ex& e, const GiNaC::ex& x);

/// The power of the lowest-order term of e in x around 0; `none` where no term up to that order is left.
int leading_order(const GiNaC::ex& e, const GiNaC::ex& x, int none = 16);

/// The expression as text that Formulas::parse reads. Terms and factors stand in an order of our own: that of
/// GiNaC is another one at every run.
std::string text(const GiNaC::ex& e);

}  // namespace plumbline::proofs
