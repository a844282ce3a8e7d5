#pragma once
/// \file
/// Branches and shapes as lines of a drawing.

#include <plumbline/branch/trace.hpp>
#include <utility>
#include <vector>

#include "support/page/plot.hpp"

namespace plumbline::verify {

/// The curve of some quantity along a branch, cut where stability changes: stable parts solid, others dashed.
template <class X, class Y>
void add_curves(std::vector<page::Curve>& curves, const Branch<double>& branch, int colour, X x, Y y,
                const std::string& title) {
  bool first = true;
  for (const auto& point : branch.points) {
    const bool dashed = point.negative_directions > 0;
    if (first || curves.back().dashed != dashed) {
      page::Curve curve{{}, colour, dashed, first ? title : "", 1.6};
      if (!first) curve.points.push_back(curves.back().points.back());
      curves.push_back(std::move(curve));
      first = false;
    }
    curves.back().points.emplace_back(x(point), y(point));
  }
}

/// The links of a chain as a line from the base to the end point.
std::vector<std::pair<double, double>> outline(const Chain<double>& chain, const Vector<double>& theta);

}  // namespace plumbline::verify
