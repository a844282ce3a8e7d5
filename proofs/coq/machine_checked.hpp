#pragma once
/// \file
/// Which theorems Coq has checked when this program was built: the list that the check itself wrote.

#include <span>
#include <string_view>

namespace plumbline::proofs {

/// Version of the Coq that checked them; empty where the proofs were not checked in this build.
std::string_view coq_version();

/// Names such as "definite.M_definite", the file first; in order, none of them resting on an axiom.
std::span<const std::string_view> machine_checked();

}  // namespace plumbline::proofs
