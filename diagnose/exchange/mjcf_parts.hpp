#pragma once
/// \file
/// The elements of MJCF that a tree is written with.

#include <vector>

#include "diagnose/exchange/tree.hpp"
#include "diagnose/exchange/xml.hpp"

namespace plumbline::exchange {

/// Within a time step or two: what is constrained is as good as rigid.
inline constexpr double mjcf_timestep = response_time / 5;
/// Attributes solref… and solimp… of what is as good as rigid.
std::string rigid_reference();
std::string rigid_impedance();

Xml mjcf_joint(const Hinge& hinge);
/// A point that weighs, or next to nothing.
Xml mjcf_inertial(double mass, Pair middle = {0, 0});

/// The sections of what couples joints and acts on them: tendons, equality constraints, actuators.
std::vector<Xml> mjcf_couplings(const Tree& tree);

/// What MJCF cannot carry, as numbers in <custom>.
Xml mjcf_beside(const Model& model, const std::vector<Carried>& effects);

/// The rail with the drive and the cell on it, in the plane of the chain.
/// \param reference  where the end point is in the model's reference configuration
Xml mjcf_rail(const Drive& drive, Pair reference);
/// A body beside it that is as far along z as seconds have passed, where the cell drifts.
std::optional<Xml> mjcf_clock(const Drive& drive);
/// The sections of the drive and the cell: the grip, what they are led by, what they read.
/// \param tip  the body that the cell holds, at this point of it
std::vector<Xml> mjcf_drive(const Drive& drive, const std::string& tip, const std::vector<double>& grip);

}  // namespace plumbline::exchange
