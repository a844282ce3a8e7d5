#pragma once
/// \file
/// What is asked about an experiment before any fit.

#include <plumbline/base/error.hpp>
#include <string>

#include "diagnose/screening/conventions.hpp"
#include "diagnose/screening/physical.hpp"

namespace plumbline::diagnose::test {

/// The first convention named before any fit, and its alternatives; empty where there is none.
inline std::string question(const Experiment& experiment) {
  try {
    require_physical(experiment);
    require_conventions(Study(experiment));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace plumbline::diagnose::test
