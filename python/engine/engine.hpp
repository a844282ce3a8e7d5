#pragma once
/// \file
/// The extension module behind the Python package: what the modules in python/plumbline call. Numbers come as
/// arrays of doubles or as decimals in text; everything else about Python's side is decided there.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <nlohmann/json_fwd.hpp>
#include <plumbline/chain/chain.hpp>
#include <string>
#include <vector>

namespace plumbline::python {

namespace py = pybind11;

using Decimals = std::vector<std::string>;

void add_straight(py::module_& module);
void add_structures(py::module_& module);
void add_loaded(py::module_& module);
void add_diagnosis(py::module_& module);
void add_models(py::module_& module);

/// A chain of decimals, each taken exactly.
/// \throws Error that names list and entry
Chain<Rational> exact_chain(const Decimals& lengths, const Decimals& stiffness, const Decimals& rest = {});

/// A whole file of certificates, one of them in it.
/// \param command  that makes it again
std::string certificate_text(const char* format, const std::string& command, const nlohmann::json& one);

/// An array that takes over what a list holds, without a copy.
py::array_t<double> array_of(std::vector<double> values);

/// A table from rows of so many columns, if any.
template <class Rows>
py::array_t<double> table_of(const Rows& rows, std::size_t columns) {
  py::array_t<double> table({rows.size(), columns});
  double* to = table.mutable_data();
  for (const auto& row : rows) to = std::copy(row.begin(), row.end(), to);
  return table;
}

/// What is computed without Python's lock: other threads go on meanwhile.
template <class Work>
auto unlocked(const Work& work) {
  const py::gil_scoped_release released;
  return work();
}

}  // namespace plumbline::python
