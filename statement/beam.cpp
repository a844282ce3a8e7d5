#include "statement/beam.hpp"

#include <plumbline/structure/beam.hpp>

#include "statement/ends.hpp"

namespace plumbline::statement {
namespace {

/// The spring at the chain's end of what holds the rod's end against turning: half a bar bends between them.
Rational behind_half_bar(const Restraint<Rational>& turn, const Rational& half_bar) {
  if (turn.is_free()) return 0;
  return turn.is_held() ? half_bar : turn.stiffness * half_bar / (turn.stiffness + half_bar);
}

Structure<Rational> read_rod(const TypedTable& table, const Beam& beam, std::size_t links) {
  Support<Rational> clamped_base = pinned<Rational>();
  clamped_base.turn = Restraint<Rational>::held();
  const auto base = read_end(table, "base", {{"pinned", pinned<Rational>()}, {"clamped", clamped_base}},
                             pinned<Rational>());
  const auto end = read_end(table, "end_point",
                            {{"pinned", guided<Rational>()},
                             {"guided", guided<Rational>()},
                             {"clamped", clamped<Rational>()},
                             {"free", {}}},
                            guided<Rational>());
  const Rational half_bar = 2 * beam.EI / beam.bar;
  std::vector<Rational> stiffness(links, beam.EI / beam.bar);
  stiffness[0] = behind_half_bar(base.turn, half_bar);
  Structure<Rational> structure(
      Chain<Rational>(std::vector<Rational>(links, beam.bar), std::move(stiffness)));
  structure.base = base;
  structure.base.turn = {};
  structure.end_point = end;
  if (!end.turn.is_free())
    structure.end_point.turn = Restraint<Rational>::sprung(behind_half_bar(end.turn, half_bar));
  return structure;
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
  const Rational links = said.positive("links");
  if (mp::denominator(links) != 1 || links > 1000000)
    throw Error(said.place("links"), as_written(said.node("links")), "a whole number up to a million");
  beam.bar = said.positive("length") / links;
  return read_rod(table, beam, links.convert_to<std::size_t>());
}

}  // namespace plumbline::statement
