#include <memory>
#include <nlohmann/json.hpp>

#include "proofs/certificates/certificate.hpp"
#include "proofs/exact/decimal.hpp"
#include "python/engine/engine.hpp"

namespace plumbline::python {
namespace {

std::vector<Rational> exactly(const Decimals& texts, const std::string& list) {
  std::vector<Rational> values;
  for (const std::string& text : texts) {
    const auto value = proofs::parse_decimal(text);
    if (!value)
      throw Error(list + ", entry " + std::to_string(values.size() + 1), text.empty() ? "nothing" : text,
                  "a decimal number");
    values.push_back(*value);
  }
  return values;
}

}  // namespace

Chain<Rational> exact_chain(const Decimals& lengths, const Decimals& stiffness, const Decimals& rest) {
  return Chain<Rational>(exactly(lengths, "lengths"), exactly(stiffness, "stiffness"), exactly(rest, "rest"));
}

std::string certificate_text(const char* format, const std::string& command, const nlohmann::json& one) {
  const proofs::Provenance provenance{command, "plumbline " PLUMBLINE_VERSION, ""};
  return proofs::certificate_file(format, provenance, {one}).dump(1, ' ', true) + "\n";
}

py::array_t<double> array_of(std::vector<double> values) {
  auto held = std::make_unique<std::vector<double>>(std::move(values));
  const py::capsule owner(held.get(), [](void* list) { delete static_cast<std::vector<double>*>(list); });
  const std::vector<double>& list = *held.release();
  return py::array_t<double>(list.size(), list.data(), owner);
}

}  // namespace plumbline::python

PYBIND11_MODULE(_engine, module) {
  namespace python = plumbline::python;
  module.doc() = "The computations of the package plumbline, in C++.";
  module.attr("version") = PLUMBLINE_VERSION;
  // Earlier releases of pybind11 misread the array type of NumPy 2, without an error.
  constexpr int first_for_numpy_2 = 0x020C0000;
  module.attr("newest_numpy") = PYBIND11_VERSION_HEX >= first_for_numpy_2 ? 2 : 1;
  pybind11::register_exception<plumbline::Error>(module, "Error", PyExc_ValueError);
  python::add_straight(module);
  python::add_structures(module);
  python::add_loaded(module);
  python::add_diagnosis(module);
  python::add_models(module);
}
