#pragma once
/// \file
/// Checks that a paper's folder names: what papers on chains state, judged without a function of their own.
///
/// `check = { is = "formula", … }` in a claim; `chain` is the id of a premise among its `given`.
/// verify/papers/README.md has every kind with its parameters. A kind is a function of the parameters, the
/// print and the premises, in the file of its name.

#include "verify/judging/claim.hpp"

namespace plumbline::verify {

/// What a check is told: its parameters.
class Parameters {
 public:
  explicit Parameters(const StatedCheck& stated) : stated_(stated) {}

  /// The list of a parameter; empty where it is not given.
  [[nodiscard]] Printed list(const std::string& name) const;
  /// Its one text. \throws Error where it is not given and there is no other
  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& name, const std::string& otherwise) const;
  [[nodiscard]] bool has(const std::string& name) const { return stated_.with.contains(name); }
  /// \throws Error that names the first parameter that is not among the known ones
  void known(const std::vector<std::string>& names) const;
  /// \throws Error at the check's place
  [[noreturn]] void wrong(const std::string& found, const std::string& expected) const;

 private:
  const StatedCheck& stated_;
};

namespace generic {

/// Formulas that are what the model of a chain has (formula.cpp).
Judgement formula(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// Numbers to their digits, and the sign of a number (values.cpp).
Judgement value(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// The sign of a formula on a range (values.cpp).
Judgement sign(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// How many names one thing has, or meanings one name (values.cpp).
Judgement names(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// Critical forces, modes and eigenvalues of a straight chain (straight.cpp).
Judgement modes(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// How the force begins to change along the bent shapes of a mode (straight.cpp).
Judgement post_buckling(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// A closed form of the critical forces of a family of chains (straight.cpp).
Judgement closed_form(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// Whether the straight chain is stable under a force (straight.cpp).
Judgement stability(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// Where chains with any ends, loads and masses give way (structures.cpp).
Judgement critical(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// All equilibria under a load: how many, which, which are stable (equilibria.cpp).
Judgement equilibria(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// What a slowly compressed chain does (path.cpp).
Judgement path(const Parameters& with, const Printed& printed, const Premises& given, int digits);
/// Where something happens to it (path.cpp).
Judgement event(const Parameters& with, const Printed& printed, const Premises& given, int digits);

}  // namespace generic

/// The check that a claim states. \throws Error at a kind that there is not
Check generic_check(const StatedCheck& stated);

}  // namespace plumbline::verify
