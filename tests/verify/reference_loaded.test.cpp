#include "verify/reference/loaded.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace plumbline;
using namespace plumbline::verify;

namespace {

LoadedCase named(const std::string& name) {
  const auto cases = loaded_cases(ReferenceSize::compact, reference_seed);
  return *std::find_if(cases.begin(), cases.end(), [&](const LoadedCase& c) { return c.task.name == name; });
}
Mpfr50 number(const nlohmann::json& text) {
  return Mpfr50(text.get<std::string>());
}

}  // namespace

TEST_CASE("two unit links on a passive base, shortened to 1.6: the angles are acos 0.8, by hand") {
  const auto found = equilibria_entry(named("paper-two-link"));
  REQUIRE(found);
  const auto& entry = found->entry;
  const Mpfr50 turn = acos(Mpfr50(4) / 5), unit("1e-49");
  REQUIRE(entry["equilibria"].size() == 2);
  for (const auto& state : entry["equilibria"]) {
    CHECK(abs(number(state["energy"]) - 2 * turn * turn) <= unit);
    CHECK(abs(abs(number(state["angles"][0])) - turn) <= unit);
    // k (2 turn) = |F| L sin(turn), and sin(turn) = 0.6
    CHECK(abs(number(state["force"][0]) + 10 * turn / 3) <= 10 * unit);
    CHECK(state["force"][1] == "0");
    CHECK(state["negative_directions"] == 0);
  }
}

TEST_CASE("events are equilibria at their load, and the compact cases are among the full ones") {
  const auto full = loaded_cases(ReferenceSize::full, reference_seed);
  std::size_t events = 0;
  for (const LoadedCase& loaded : loaded_cases(ReferenceSize::compact, reference_seed)) {
    INFO(loaded.task.name);
    CHECK(std::any_of(full.begin(), full.end(), [&](const LoadedCase& c) {
      return c.task.name == loaded.task.name && c.task.chain.length() == loaded.task.chain.length();
    }));
    if (loaded.window == 0 || loaded.task.rest_in_pi) continue;
    const auto entry = events_entry(loaded);
    REQUIRE(entry);
    for (const auto& event : (*entry)["events"]) {
      // k_i (q_i - rest_i) = [J^T F]_i, with the moment arms from the end point
      Mpfr50 x(0), y(0), theta(0);
      std::vector<Point<Mpfr50>> joints;
      for (std::size_t i = 0; i < loaded.task.chain.size(); ++i) {
        joints.push_back({x, y});
        theta += number(event["angles"][i]);
        x += from_rational<Mpfr50>(loaded.task.chain.length()[i]) * cos(theta);
        y += from_rational<Mpfr50>(loaded.task.chain.length()[i]) * sin(theta);
      }
      const Mpfr50 fx = number(event["force"][0]), fy = number(event["force"][1]);
      for (std::size_t i = 0; i < joints.size(); ++i) {
        const Mpfr50 spring =
            from_rational<Mpfr50>(loaded.task.chain.stiffness()[i]) *
            (number(event["angles"][i]) - from_rational<Mpfr50>(loaded.task.chain.rest()[i]));
        CHECK(abs(spring - ((x - joints[i].x) * fy - (y - joints[i].y) * fx)) < Mpfr50("1e-37"));
      }
      ++events;
    }
  }
  CHECK(events > 3);
}
