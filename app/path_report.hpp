#pragma once
/// \file
/// A loaded path as text for a person, CSV, JSON and drawing.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "proofs/paths/followed_path.hpp"
#include "verify/figures/branch_curves.hpp"

namespace plumbline::app {

/// The force-deflection curve in a few lines, and every event.
std::string as_text(const proofs::PathReport& report);
/// `branch,point,load,x,y,Fx,Fy,energy,stiffness,negative_directions,event,q1,…`: a row a point, events among
/// them.
std::string as_csv(const proofs::PathReport& report);
nlohmann::ordered_json as_json(const proofs::PathReport& report);
/// Force over deflection, and the shapes.
std::vector<page::Panel> as_drawing(const proofs::PathReport& report, const Chain<double>& chain);

}  // namespace plumbline::app
