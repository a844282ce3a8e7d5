#include "statement/ends.hpp"

#include <algorithm>

#include "proofs/exact/decimal.hpp"

namespace plumbline::statement {
namespace {

Restraint<Rational> read_restraint(const TypedTable& table, std::string_view key) {
  const std::string word = word_of(table.node(key));
  if (word == "free") return {};
  if (word == "held") return Restraint<Rational>::held();
  const auto decimals = decimals_in(table.node(key));
  const auto stiffness = decimals ? proofs::parse_decimal(*decimals) : std::nullopt;
  if (stiffness && *stiffness >= 0) return Restraint<Rational>::sprung(*stiffness);
  throw Error(table.place(key), as_written(table.node(key)),
              "\"free\", \"held\" or the stiffness of a spring");
}

}  // namespace

Support<Rational> read_end(const TypedTable& table, std::string_view key, const std::vector<EndWord>& words,
                           const Support<Rational>& otherwise) {
  if (!table.has(key)) return otherwise;
  if (table.node(key).is_table()) {
    const TypedTable end = table.table(key, {"along", "across", "turn"});
    Support<Rational> support = otherwise;
    for (const auto& [name, restraint] :
         {std::pair("along", &support.along), std::pair("across", &support.across),
          std::pair("turn", &support.turn)}) {
      if (end.has(name)) *restraint = read_restraint(end, name);
    }
    return support;
  }
  const std::string word = word_of(table.node(key));
  std::string expected;
  for (const auto& [name, support] : words) {
    if (word == name) return support;
    expected += '"' + std::string(name) + "\", ";
  }
  throw Error(table.place(key), as_written(table.node(key)),
              expected + "or a table with along, across, turn");
}

std::size_t read_node(const TypedTable& table, std::string_view key, std::size_t n) {
  if (word_of(table.node(key)) == "end_point") return n;
  const auto decimals = decimals_in(table.node(key));
  const auto joint = decimals ? proofs::parse_decimal(*decimals) : std::nullopt;
  if (!joint || mp::denominator(*joint) != 1 || *joint < 2 || *joint > n)
    throw Error(table.place(key), as_written(table.node(key)),
                n > 1 ? "\"end_point\" or the number of a joint from 2 to " + std::to_string(n)
                      : "\"end_point\", for a chain of one link");
  return joint->convert_to<std::size_t>() - 1;
}

std::vector<Restraint<Rational>> read_supports(const TypedTable& table, std::size_t n) {
  std::vector<Restraint<Rational>> across;
  if (!table.has("supports")) return across;
  across.resize(n - 1);
  std::vector<bool> said(n - 1, false);
  for (const TypedTable& one : table.tables("supports", {"at", "across"}, "{ at = 3, across = \"held\" }")) {
    const std::size_t node = read_node(one, "at", n);
    if (node == n)
      throw Error(one.place("at"), "the end point", "a joint; end_point = { across = … } for that");
    if (said[node - 1])
      throw Error(one.place("at"), "joint " + std::to_string(node + 1) + " again",
                  "one support for each joint");
    said[node - 1] = true;
    across[node - 1] = read_restraint(one, "across");
  }
  return across;
}

}  // namespace plumbline::statement
