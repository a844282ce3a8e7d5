#include "diagnose/rig/parameter_range.hpp"

#include <cmath>

namespace plumbline::diagnose {

double catalogue_value(Coordinate coordinate, double fitted) {
  switch (coordinate) {
    case Coordinate::logarithm:
      return std::exp(fitted);
    case Coordinate::reciprocal:
      return 1 / fitted;
    case Coordinate::growth:
      return std::expm1(fitted);
    case Coordinate::plain:
      break;
  }
  return fitted;
}

double fitted_value(Coordinate coordinate, double catalogue_units) {
  switch (coordinate) {
    case Coordinate::logarithm:
      return std::log(catalogue_units);
    case Coordinate::reciprocal:
      return 1 / catalogue_units;
    case Coordinate::growth:
      return std::log1p(catalogue_units);
    case Coordinate::plain:
      break;
  }
  return catalogue_units;
}

}  // namespace plumbline::diagnose
