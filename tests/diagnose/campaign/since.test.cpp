#include "diagnose/campaign/since.hpp"

#include <doctest/doctest.h>

#include <string>

#include "diagnose/campaign/report.hpp"

using namespace plumbline::campaign;

namespace {

Outcome naming(const std::string& name, const std::vector<std::string>& effects,
               const std::vector<std::vector<std::string>>& equivalent = {}) {
  Outcome one{name, {}, "", {}};
  one.report.verdict = effects.empty() ? "none" : equivalent.empty() ? "identified" : "ambiguous";
  one.report.effects = effects;
  one.report.equivalent = equivalent;
  return one;
}

std::string begins(const std::vector<Outcome>& outcomes) {
  std::string text;
  for (const Since& one : since_when(outcomes)) text += one.effect + " " + outcomes[one.first].name + "; ";
  return text;
}

}  // namespace

TEST_CASE("an effect is there since the first from which on all name it") {
  CHECK(begins({naming("a", {}), naming("b", {"play"}), naming("c", {"play"})}) == "play b; ");
  // One that went in between begins again after that; one that is gone at the end is none.
  CHECK(begins({naming("a", {"play"}), naming("b", {}), naming("c", {"play"})}) == "play c; ");
  CHECK(begins({naming("a", {"play"}), naming("b", {})}).empty());
  CHECK(begins({}).empty());
}

TEST_CASE("a name in a class counts, and a diagnosis that failed neither begins nor ends anything") {
  Outcome failed{"b", {}, "exit status 2", {}};
  CHECK(begins({naming("a", {"drag"}, {{"play"}}), failed, naming("c", {"play"}), failed}) == "play a; ");
}

TEST_CASE("several stand in the order of their beginnings") {
  const std::vector<Outcome> days{naming("a", {"play"}), naming("b", {"play", "drag"})};
  CHECK(begins(days) == "play a; drag b; ");
  CHECK(as_text(since_when(days), days) == "Since when?\n  play since a\n  drag since b\n");
}
