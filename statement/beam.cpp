#include "statement/beam.hpp"

#include <plumbline/structure/beam.hpp>

namespace plumbline::statement {
namespace {

RodEnd rod_end(const TypedTable& table, std::string_view key, const std::vector<std::string_view>& words) {
  if (!table.has(key)) return RodEnd::pinned;
  const std::string word = table.word(key, words);
  return word == "clamped" ? RodEnd::clamped : word == "free" ? RodEnd::free : RodEnd::pinned;
}

}  // namespace

Structure<Rational> read_beam(const TypedTable& table, Beam& beam) {
  for (const char* key : {"lengths", "stiffness", "link_length", "joint_stiffness", "rest"}) {
    if (table.has(key))
      throw Error(table.place(key), "a list beside a beam", "one of the two: a beam has its own");
  }
  const TypedTable said = table.table("beam", {"E", "I", "EI", "length", "links"});
  if (said.has("EI") == (said.has("E") || said.has("I")))
    throw Error(table.place("beam"), "not one of EI and E with I", "EI, or both E and I");
  beam.EI = said.has("EI") ? said.positive("EI") : said.positive("E") * said.positive("I");
  const Rational length = said.positive("length"), links = said.positive("links");
  if (mp::denominator(links) != 1 || links > 1000000)
    throw Error(said.place("links"), as_written(said.node("links")), "a whole number up to a million");
  beam.bar = length / links;
  return rod<Rational>(beam.EI, length, links.convert_to<std::size_t>(),
                       rod_end(table, "base", {"pinned", "clamped"}),
                       rod_end(table, "end_point", {"pinned", "guided", "clamped", "free"}));
}

}  // namespace plumbline::statement
