#include <nlohmann/json.hpp>
#include <plumbline/straight/buckling_mode.hpp>
#include <plumbline/straight/critical_force_batch.hpp>

#include "proofs/certificates/certificate.hpp"
#include "proofs/exact/critical_modes.hpp"
#include "python/engine/engine.hpp"

namespace plumbline::python {
namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

py::array_t<double> lowest_forces(const Array& lengths, const Array& stiffness, unsigned threads) {
  const auto links = static_cast<std::size_t>(lengths.shape(1));
  const auto all = [](const Array& array) {
    return std::span<const double>(array.data(), static_cast<std::size_t>(array.size()));
  };
  const ChainBatch batch{links, all(lengths), all(stiffness)};
  return array_of(unlocked([&] {
    return threads > 0 ? plumbline::lowest_forces(batch, threads) : plumbline::lowest_forces(batch);
  }));
}

py::array_t<double> forces(std::vector<double> lengths, std::vector<double> stiffness, std::size_t lowest) {
  return array_of(unlocked(
      [&] { return critical_forces(Chain<double>(std::move(lengths), std::move(stiffness)), lowest); }));
}

py::dict modes(std::vector<double> lengths, std::vector<double> stiffness, std::size_t lowest) {
  const std::size_t links = lengths.size();
  const auto found = unlocked(
      [&] { return critical_modes(Chain<double>(std::move(lengths), std::move(stiffness)), lowest); });
  std::vector<double> force, fy;
  std::vector<std::vector<double>> q;
  std::vector<std::string> signs, shapes;
  for (const Mode<double>& mode : found) {
    force.push_back(mode.force), fy.push_back(mode.fy), q.push_back(mode.q);
    signs.push_back(sign_pattern(mode.q)), shapes.push_back(shape_name(signs.back()));
  }
  py::dict all;
  all["force"] = array_of(force), all["fy"] = array_of(fy), all["q"] = table_of(q, links);
  all["signs"] = signs, all["shape"] = shapes;
  return all;
}

Decimals exact_forces(const Decimals& lengths, const Decimals& stiffness, std::size_t lowest, int digits) {
  return unlocked([&] {
    Decimals all;
    for (const proofs::CriticalMode& mode :
         proofs::modes_in_decimals(exact_chain(lengths, stiffness), lowest, digits))
      all.push_back(mode.force);
    return all;
  });
}

std::string certificate(const std::string& name, const Decimals& lengths, const Decimals& stiffness,
                        std::size_t lowest, int digits, const std::string& command) {
  return unlocked([&] {
    const Chain<Rational> chain = exact_chain(lengths, stiffness);
    const std::size_t shapes = digits > 1 ? lowest : 0;
    return certificate_text(proofs::critical_certificates, command,
                            proofs::certificate(name, chain, proofs::certify(chain, lowest, shapes, digits)));
  });
}

}  // namespace

void add_straight(py::module_& module) {
  module.def("lowest_forces", &lowest_forces);
  module.def("critical_forces", &forces);
  module.def("critical_modes", &modes);
  module.def("exact_forces", &exact_forces);
  module.def("critical_certificate", &certificate);
}

}  // namespace plumbline::python
