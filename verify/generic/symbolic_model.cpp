#include "verify/generic/symbolic_model.hpp"

#include <fmt/core.h>

#include <plumbline/base/error.hpp>
#include <regex>
#include <set>

#include "verify/judging/formula_value.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

const std::regex a_name("[A-Za-z][A-Za-z0-9]*");

std::set<std::string> names_in(const std::string& formula) {
  return {std::sregex_token_iterator(formula.begin(), formula.end(), a_name), std::sregex_token_iterator()};
}

Printed part_of(const Premise& chain, const std::string& name) {
  const auto found = chain.parts.find(name);
  return found == chain.parts.end() ? Printed{} : found->second;
}

proofs::Formulas declared(const Premise& chain, const Printed& symbols) {
  static const std::set<std::string> known{"sin", "cos", "tan", "sqrt", "Pi", "pi"};
  std::set<std::string> all(symbols.begin(), symbols.end());
  for (const auto& [name, entries] : chain.parts) {
    for (const std::string& entry : entries) all.merge(names_in(entry));
  }
  for (std::size_t i = 1; i <= part_of(chain, "length").size(); ++i) all.insert(fmt::format("q{}", i));
  all.insert({"Fx", "Fy"});
  for (const std::string& function : known) all.erase(function);
  return proofs::Formulas({all.begin(), all.end()});
}

/// The entry of a matrix of a name such as "J12".
ex entry(const GiNaC::matrix& m, const std::string& digits) {
  if (digits.size() != 2) throw Error("formula", "the entry " + digits, "a row and a column");
  const auto row = static_cast<unsigned>(digits[0] - '1'), column = static_cast<unsigned>(digits[1] - '1');
  if (row >= m.rows() || column >= m.cols())
    throw Error("formula", "the entry " + digits, "one of the matrix");
  return m(row, column);
}

}  // namespace

SymbolicModel::SymbolicModel(const Premise& chain, const Printed& symbols, const Printed& shape)
    : formulas_(declared(chain, symbols)) {
  const auto read = [&](const Printed& texts) {
    std::vector<ex> list;
    for (const std::string& text : texts) list.push_back(formulas_.parse(with_fractions(text)));
    return list;
  };
  length_ = read(part_of(chain, "length"));
  stiffness_ = read(part_of(chain, "stiffness"));
  rest_ = read(part_of(chain, "rest"));
  if (rest_.empty()) rest_.assign(length_.size(), 0);
  q_ = read(shape);
  if (q_.empty())
    for (std::size_t i = 1; i <= length_.size(); ++i) q_.push_back(formulas_.symbol(fmt::format("q{}", i)));
  if (stiffness_.size() != length_.size() || rest_.size() != length_.size() || q_.size() != length_.size())
    throw Error("premise " + chain.id, "lists of different lengths",
                "a length, a stiffness, an angle a link");
}

ex SymbolicModel::value(const std::string& formula) const {
  const std::string exact = with_fractions(formula);
  std::vector<std::string> all;
  GiNaC::exmap meaning;
  std::set<std::string> used = names_in(exact);
  for (const std::string& name : used) all.push_back(name);
  const proofs::Formulas reader(all);
  const ex parsed = reader.parse(exact);
  for (const std::string& name : all) {
    const ex symbol = reader.symbol(name);
    if (parsed.has(symbol)) meaning[symbol] = named(name);
  }
  return parsed.subs(meaning);
}

proofs::SymbolicShape SymbolicModel::shape_at(const std::vector<ex>& q) const {
  proofs::SymbolicShape shape{length_, stiffness_, {}};
  for (std::size_t i = 0; i < size(); ++i) shape.q.push_back(rest_[i] + q[i]);
  return shape;
}

ex SymbolicModel::named(const std::string& name) const {
  const proofs::SymbolicShape shape = shape_at(q_), at_rest = shape_at(std::vector<ex>(size(), 0));
  if (name == "x") return end_point(shape)(0, 0);
  if (name == "y") return end_point(shape)(1, 0);
  if (name == "x0") return end_point(at_rest)(0, 0);
  if (name == "y0") return end_point(at_rest)(1, 0);
  if (name == "pi") return GiNaC::Pi;
  if (name == "E") {
    ex energy = 0;
    for (std::size_t i = 0; i < size(); ++i) energy += stiffness_[i] * q_[i] * q_[i] / 2;
    return energy;
  }
  const std::string digits = name.substr(1);
  const bool numbered = !digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos;
  const proofs::SymbolicChain straight{length_, stiffness_};
  if (name.starts_with("chi") && name.size() == 4) {
    const ex lambda = GiNaC::realsymbol("lambda");
    return proofs::characteristic_polynomial(straight, lambda).expand().coeff(lambda, name[3] - '0').normal();
  }
  if (numbered && name[0] == 'J') return entry(jacobian(shape), digits);
  if (numbered && name[0] == 'S') return entry(proofs::matrix_S1(straight), digits);
  if (numbered && name[0] == 'A') return entry(proofs::matrix_A(straight), digits);
  if (numbered && name[0] == 'B') return entry(proofs::matrix_B(straight), digits);
  if (numbered && name[0] == 'z') return entry(proofs::matrix_S0(straight), digits + "1");
  if (numbered && name[0] == 'T') {
    const GiNaC::matrix J = jacobian(shape);
    const std::size_t i = std::stoul(digits) - 1;
    if (i >= size()) throw Error("formula", name, "a joint of the chain");
    const auto joint = static_cast<unsigned>(i);
    return J(0, joint) * formulas_.symbol("Fx") + J(1, joint) * formulas_.symbol("Fy") +
           stiffness_[i] * q_[i];
  }
  return formulas_.symbol(name);
}

}  // namespace plumbline::verify
