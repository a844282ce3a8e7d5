#pragma once
/// \file
/// Critical forces as users submit them for a check.

#include <map>
#include <plumbline/chain/chain.hpp>
#include <string>
#include <vector>

#include "verify/reference/agreement.hpp"

namespace plumbline::app {

/// Chains by name.
using Chains = std::map<std::string, Chain<Rational>>;
/// Forces by the name of their chain.
using Submitted = std::map<std::string, std::vector<verify::SubmittedForce>>;

struct SubmittedValues {
  Submitted values;
  std::vector<std::string> errors;  ///< one line for each wrong row
};

/// Values from CSV text with the columns chain, mode and force among others. A row is wrong if its chain is
/// unknown, its mode does not exist or is repeated, or its force is no number.
/// \throws Error when a column is missing or no row follows the header
SubmittedValues parse_values(const std::string& text, const std::string& source, const Chains& chains);

}  // namespace plumbline::app
