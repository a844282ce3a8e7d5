#include "statement/stated.hpp"

#include <nlohmann/json.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_list.hpp"
#include "statement/chain_file.hpp"
#include "statement/decimal_toml.hpp"

namespace plumbline::statement {
namespace {

using nlohmann::json;

/// Decimals that a list joins by ';' are entries of it.
void append(json& list, const std::string& decimals) {
  for (std::size_t at = 0; at <= decimals.size();) {
    const std::size_t end = std::min(decimals.find(';', at), decimals.size());
    const std::string item = decimals.substr(at, end - at);
    const auto number = proofs::parse_decimal(item);
    list.push_back(number ? proofs::to_exact(*number) : item);
    at = end + 1;
  }
}

json to_json(const toml::node& node) {
  if (const toml::table* table = node.as_table()) {
    json object = json::object();
    for (const auto& [key, value] : *table) object[std::string(key.str())] = to_json(value);
    return object;
  }
  if (const toml::array* array = node.as_array()) {
    json list = json::array();
    for (const toml::node& item : *array) {
      if (const auto decimals = decimals_in(item))
        append(list, *decimals);
      else
        list.push_back(to_json(item));
    }
    return list;
  }
  if (const auto flag = node.value_exact<bool>())
    return *flag ? 1 : 0;  // what certificates have in their place
  const auto decimals = decimals_in(node);
  if (!decimals) return node.value_or(std::string());
  json list = json::array();
  append(list, *decimals);
  return list[0];
}

json to_json(const Restraint<Rational>& restraint) {
  if (restraint.is_held()) return "held";
  return restraint.is_free() ? "free" : proofs::to_exact(restraint.stiffness);
}

json to_json(const Support<Rational>& support) {
  return {{"along", to_json(support.along)},
          {"across", to_json(support.across)},
          {"turn", to_json(support.turn)}};
}

json to_json(const Load<Rational>& load, std::size_t links) {
  json result{{"at", load.node == links ? "end_point" : std::to_string(load.node + 1)}};
  if (load.kind == LoadKind::follower)
    result["follower"] = proofs::to_exact(Rational(-load.force.x));
  else
    result["force"] = proofs::exact_list({load.force.x, load.force.y});
  if (!load.multiplied) result["fixed"] = 1;
  return result;
}

}  // namespace

json stated(const std::string& text, const std::string& source) {
  const toml::table file = parse_decimal_toml(text, source);
  json chain = to_json(file);
  if (file.contains("nominal")) chain = json(chain["nominal"]);
  for (const auto& [here, there] :
       {std::pair("lengths", "link_length"), std::pair("stiffness", "joint_stiffness")}) {
    if (!chain.contains(there)) continue;
    chain[here] = chain[there];
    chain.erase(there);
  }
  for (const char* of_model : {"link_mass", "gravity"}) chain.erase(of_model);
  return chain;
}

json stated(const Structure<Rational>& structure) {
  const std::size_t n = structure.chain.size();
  json chain{{"lengths", proofs::exact_list(structure.chain.length())},
             {"stiffness", proofs::exact_list(structure.chain.stiffness())},
             {"base", to_json(structure.base)},
             {"end_point", to_json(structure.end_point)},
             {"loads", json::array()}};
  for (std::size_t node = 1; node < n; ++node) {
    const Restraint<Rational> across = structure.across_at(node);
    if (!across.is_free())
      chain["supports"].push_back({{"at", std::to_string(node + 1)}, {"across", to_json(across)}});
  }
  for (const Load<Rational>& load : structure.loads) {
    if (load.node > 0) chain["loads"].push_back(to_json(load, n));  // what is at the base, the ground takes
  }
  if (!structure.mass.empty())
    chain["masses"] = proofs::exact_list({structure.mass.begin() + 1, structure.mass.end()});
  return chain;
}

}  // namespace plumbline::statement
