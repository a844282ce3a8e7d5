#pragma once
/// \file
/// Exact numbers, as certificates list them.

#include <nlohmann/json.hpp>
#include <vector>

#include "proofs/exact/decimal.hpp"

namespace plumbline::proofs {

inline nlohmann::json exact_list(const std::vector<Rational>& values) {
  nlohmann::json list = nlohmann::json::array();
  for (const Rational& x : values) list.push_back(to_exact(x));
  return list;
}

}  // namespace plumbline::proofs
