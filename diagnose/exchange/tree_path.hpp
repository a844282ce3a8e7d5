#pragma once
/// \file
/// The serial chain within a tree.

#include <string>
#include <vector>

#include "diagnose/exchange/tree.hpp"

namespace plumbline::exchange {

/// The bodies from the base to the last link.
std::vector<const Body*> path_of(const Tree& tree);

/// The body that moves by a joint, if there is one.
const Body* carrier_of(const Tree& tree, const std::string& joint);

/// The name of joint j, from 0: "q1".
std::string chain_name(std::size_t j);

/// What of a tree belongs to a link of the chain.
struct LinkOf {
  double length = 0, mass = 0;
  Eigen::Vector2d centre{0, 0};  ///< of the mass, along the link and across
};
std::vector<LinkOf> links_of(const Tree& tree, std::size_t count);

}  // namespace plumbline::exchange
