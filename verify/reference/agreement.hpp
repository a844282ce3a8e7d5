#pragma once
/// \file
/// Somebody else's critical forces against certified ones.

#include <plumbline/chain/chain.hpp>
#include <string>
#include <vector>

namespace plumbline::verify {

/// A critical force as somebody computed it.
struct SubmittedForce {
  std::size_t line;  ///< of the file that it stands in
  std::size_t mode;  ///< from 1
  std::string text;  ///< a decimal, or what a program prints for none: nan, inf
};

/// What of a chain makes trouble for methods that are not careful.
struct Trait {
  static constexpr unsigned passive_base = 1, passive_interior = 2, graded = 4, long_chain = 8,
                            upper_half = 16, close_pair = 32;
};

struct ForceAgreement {
  std::string chain;
  SubmittedForce submitted;
  std::string reference;  ///< certified, 20 digits
  double digits;          ///< that agree: -log10 of the relative error
  double condition;       ///< of the force (condition.hpp)
  double permitted;       ///< digits that a stable method keeps in double precision
  std::string finding;    ///< what the value looks like where it does not agree
  unsigned traits;

  [[nodiscard]] bool agrees() const { return digits >= permitted; }
};

/// Compares forces of one chain; their modes lie between 1 and n - 1.
///
/// A stable method in double precision finds the force of a chain whose n links and springs differ by up to n
/// units of 2^-52, relatively: n, because the distances to the end point are sums of so many lengths. Hence
/// `permitted` is -log10(condition n 2^-52).
std::vector<ForceAgreement> compare(const std::string& name, const Chain<Rational>& chain,
                                    const std::vector<SubmittedForce>& forces);

/// Worst first: by how many digits are missing from those permitted.
void sort_worst_first(std::vector<ForceAgreement>& values);

/// What the chains and modes of values that do not agree have in common, the most telling first.
std::vector<std::string> where_to_look(const std::vector<ForceAgreement>& values);

}  // namespace plumbline::verify
