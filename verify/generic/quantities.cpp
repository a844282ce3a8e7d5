#include "verify/generic/quantities.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "proofs/exact/decimal.hpp"
#include "verify/judging/formula_value.hpp"

namespace plumbline::verify {
namespace {

bool is_premise(const std::string& text, const Premises& given) {
  return std::any_of(given.list().begin(), given.list().end(),
                     [&](const Premise& p) { return p.id == text; });
}

}  // namespace

Interval quantity(const std::string& text, const Premises& given) {
  return is_premise(text, given) ? given.value(text) : number(text);
}

Rational exact_quantity(const std::string& text, const Premises& given) {
  if (is_premise(text, given)) return given.exact(text);
  const auto decimal = proofs::parse_decimal(text);
  if (!decimal) throw Error("check", "'" + text + "'", "a decimal");
  return *decimal;
}

Premise with_links(const Premise& chain, std::size_t links) {
  Premise whole = chain;
  for (auto& [name, part] : whole.parts) {
    if (name != "end" && name != "value")
      part.resize(links, name == "rest" || part.empty() ? "0" : part.back());
  }
  whole.parts["rest"].resize(links, "0");
  return whole;
}

Premise chain_with_links(const Parameters& with, const Premises& given) {
  const Premise chain = given.guided(with.text("chain"));
  const auto length = chain.parts.find("length");
  const std::size_t stated = length == chain.parts.end() ? 0 : length->second.size();
  return with_links(chain, with.has("links") ? std::stoul(with.text("links")) : stated);
}

std::string with_index(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string in_words(const Premise& chain) {
  const auto part = [&](const char* const name) {
    const auto found = chain.parts.find(name);
    return found == chain.parts.end() ? Printed{} : found->second;
  };
  const Printed rest = part("rest");
  const bool straight =
      std::all_of(rest.begin(), rest.end(), [](const std::string& one) { return one == "0"; });
  return fmt::format("the {}chain with L = ({}) and k = ({}){}", straight ? "straight " : "",
                     fmt::join(part("length"), ", "), fmt::join(part("stiffness"), ", "),
                     straight ? "" : fmt::format(" and the rest angles ({})", fmt::join(rest, ", ")));
}

Chain<Rational> exact_chain(const Premise& chain) {
  return Premises({chain}).exact_chain(chain.id);
}

HeldChain held_chain(const Premise& chain) {
  return held(Premises({chain}), chain.id);
}

}  // namespace plumbline::verify
