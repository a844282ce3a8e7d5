#pragma once
/// \file
/// The signs that sections 2 and 4 print for the force and for the torques, and the fewest of them that have
/// to be turned for all to agree.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "verify/judging/claim.hpp"

namespace plumbline::verify {

/// +1 or -1 by place, such as "(24)": of the springs' torques K q where J^T F stands with +, of 1/F_x, of
/// 1/lambda, of 1/max|lambda|, of the printed numbers.
using Signs = std::map<std::string, int>;

/// As printed in the paper.
Signs printed_signs();

/// Every set of places whose signs can be turned so that equations, method and tables agree, the smallest
/// first.
std::vector<std::set<std::string>> corrections(const Signs& printed);

/// Whether the sign at a place stands: confirmed where no smallest set turns it, refuted where all do,
/// convention where some do. `signs` are those of the paper, but for an altered print's own.
Judgement judge_place(const std::string& place, const Signs& signs);

/// The sign in front of a term in a printed formula.
/// \throws Error where the term is not there
int sign_before(const std::string& term, const std::string& formula);

}  // namespace plumbline::verify
