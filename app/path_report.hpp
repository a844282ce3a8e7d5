#pragma once
/// \file
/// A loaded path as text for a person, CSV, JSON and drawing.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/loaded_paths.hpp"
#include "app/plot.hpp"

namespace plumbline {

std::string_view name(BranchEnd end);

/// The force-deflection curve in a few lines, and every event.
std::string as_text(const PathReport& report);
/// `branch,point,load,x,y,Fx,Fy,energy,stiffness,negative_directions,event,q1,…`: a row a point, events among
/// them.
std::string as_csv(const PathReport& report);
nlohmann::ordered_json as_json(const PathReport& report);
/// Force over deflection, and the shapes.
std::vector<Panel> as_drawing(const PathReport& report, const Chain<double>& chain);

/// The curve of some quantity along a branch, cut where stability changes: stable parts solid, others dashed.
template <class X, class Y>
void add_curves(std::vector<Curve>& curves, const Branch<double>& branch, int colour, X x, Y y,
                const std::string& title) {
  bool first = true;
  for (const auto& point : branch.points) {
    const bool dashed = point.negative_directions > 0;
    if (first || curves.back().dashed != dashed) {
      Curve curve{{}, colour, dashed, first ? title : "", 1.6};
      if (!first) curve.points.push_back(curves.back().points.back());
      curves.push_back(std::move(curve));
      first = false;
    }
    curves.back().points.emplace_back(x(point), y(point));
  }
}

/// The links of a chain as a line from the base to the end point.
std::vector<std::pair<double, double>> outline(const Chain<double>& chain, const Vector<double>& theta);

}  // namespace plumbline
