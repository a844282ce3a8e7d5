// One structure said in two ways is one structure: whatever a chain file may say, on random chains.

#include <plumbline/space/bent_equilibrium.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/straight_space.hpp"
#include "proofs/exact/straight_structure.hpp"
#include "statement/chain_file.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::statement;

namespace {

std::string list(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return "[" + text + "]";
}

/// Hundredths as they stand in a file.
std::string decimal(int low, int high) {
  return proofs::to_exact(Rational(*rc::gen::inRange(low, high), 100));
}

bool one_in(int cases) {
  return *rc::gen::inRange(0, cases) == 0;
}

/// What a chain file says, key by key, each of which a test may write otherwise.
struct Draft {
  std::vector<std::string> lengths, stiffness, loads, supports;
  std::string base, end, foundation;

  [[nodiscard]] std::size_t links() const { return lengths.size(); }
  [[nodiscard]] std::string rest() const {
    std::string text;
    for (const auto& [key, value] :
         {std::pair("base", &base), std::pair("end_point", &end), std::pair("foundation", &foundation)}) {
      if (!value->empty()) text += std::string(key) + " = " + *value + "\n";
    }
    if (!supports.empty()) text += "supports = " + list(supports) + "\n";
    return text;
  }
  [[nodiscard]] std::string text() const {
    return "lengths = " + list(lengths) + "\nstiffness = " + list(stiffness) + "\n" + rest() +
           "loads = " + list(loads) + "\n";
  }
};

std::string restraint() {
  const int kind = *rc::gen::inRange(0, 3);
  return kind == 0 ? "\"free\"" : kind == 1 ? "\"held\"" : decimal(10, 400);
}

/// Two to six links, any ends that keep the base in place, supports, a bed and forces along the chain.
Draft random_draft() {
  Draft draft;
  const int n = *rc::gen::inRange(2, 7);
  for (int i = 0; i < n; ++i) {
    draft.lengths.push_back(decimal(20, 300));
    draft.stiffness.push_back(decimal(10, 400));
  }
  if (one_in(3)) draft.stiffness[0] = "0", draft.base = one_in(2) ? "\"clamped\"" : "\"pinned\"";
  draft.end = "{ across = " + restraint() + ", turn = " + restraint() + " }";
  for (int joint = 2; joint <= n; ++joint) {
    if (one_in(4))
      draft.supports.push_back("{ at = " + std::to_string(joint) + ", across = " + restraint() + " }");
  }
  if (one_in(4)) draft.foundation = decimal(1, 100);
  draft.loads.push_back("{ force = [-" + decimal(10, 200) +
                        ", 0], at = " + std::to_string(*rc::gen::inRange(2, n + 1)) + " }");
  draft.loads.push_back("{ force = [-" + decimal(10, 200) + ", 0] }");
  if (one_in(4)) draft.loads.push_back("{ force = [-" + decimal(1, 5) + ", 0], fixed = true }");
  return draft;
}

/// Critical factors to fifteen digits, or why there are none.
std::vector<std::string> factors(const std::string& text) {
  std::vector<std::string> found;
  try {
    const StatedChain chain = parse_chain(text, "c");
    if (const auto* plane = std::get_if<PlaneChain>(&chain)) {
      for (const auto& mode : proofs::StraightStructure(plane->structure).in_decimals(99, 15, false))
        found.push_back(mode.force);
    } else {
      for (const auto& mode :
           proofs::StraightSpace(std::get<SpaceStructure<Rational>>(chain)).in_decimals(99, 15))
        found.push_back(mode.force);
    }
  } catch (const Error& error) {
    found.emplace_back(error.what());
  }
  return found;
}

void same(const Draft& one, const Draft& other) {
  RC_LOG() << one.text() << "\n" << other.text();
  RC_ASSERT(factors(one.text()) == factors(other.text()));
}

/// The same chain with joints about z.
std::string as_in_space(const Draft& draft) {
  std::vector<std::string> joints, loads;
  for (const std::string& k : draft.stiffness)
    joints.push_back("{ axes = [[0, 0, 1]], stiffness = [" + k + "] }");
  for (std::string load : draft.loads) loads.push_back(load.replace(load.find(", 0]"), 4, ", 0, 0]"));
  Draft rest = draft;
  if (rest.base == "\"pinned\"") rest.base = "\"jointed\"";
  return "lengths = " + list(draft.lengths) + "\njoints = " + list(joints) + "\n" + rest.rest() +
         "loads = " + list(loads) + "\n";
}

}  // namespace

TEST_CASE("a weight is a force of half of it at either end of its link, and forces at one joint add up") {
  check_property("loads", [] {
    Draft draft = random_draft(), forces = draft;
    std::vector<std::string> weights;
    std::vector<Rational> at(draft.links() + 1, Rational(0));
    for (std::size_t link = 0; link < draft.links(); ++link) {
      weights.push_back(decimal(1, 100));
      at[link] += *proofs::parse_decimal(weights.back()) / 2;
      at[link + 1] += *proofs::parse_decimal(weights.back()) / 2;
    }
    draft.loads.push_back("{ weight = " + list(weights) + " }");
    for (std::size_t node = 1; node <= draft.links(); ++node) {
      const std::string place = node < draft.links() ? std::to_string(node + 1) : "\"end_point\"";
      // in two parts, the first of which is a third too large
      const Rational first = at[node] * Rational(4, 3) * 3;
      forces.loads.push_back("{ force = [-" + proofs::to_exact(first) + ", 0], at = " + place + " }");
      forces.loads.push_back("{ force = [" + proofs::to_exact(Rational(first - at[node])) +
                             ", 0], at = " + place + " }");
    }
    same(draft, forces);
  });
}

TEST_CASE("a bed is a spring at each joint of half of its links' shares") {
  check_property("bed", [] {
    Draft draft = random_draft(), springs = draft;
    draft.supports.clear(), springs.supports.clear();
    draft.end = springs.end = "{ across = \"held\" }";
    draft.foundation = decimal(1, 100);
    springs.foundation.clear();
    const Rational bed = *proofs::parse_decimal(draft.foundation);
    for (std::size_t node = 1; node < draft.links(); ++node) {
      const Rational share =
          bed *
          (*proofs::parse_decimal(draft.lengths[node - 1]) + *proofs::parse_decimal(draft.lengths[node])) / 2;
      springs.supports.push_back("{ at = " + std::to_string(node + 1) +
                                 ", across = " + proofs::to_exact(share) + " }");
    }
    same(draft, springs);
  });
}

TEST_CASE("a clamp is a spring that is stiff beyond bounds") {
  check_property("clamp", [] {
    Draft clamp = random_draft();
    clamp.stiffness[0] = "0", clamp.base = "\"clamped\"";
    Draft spring = clamp;
    spring.stiffness[0] = "1e30", spring.base.clear();
    const auto held = factors(clamp.text()), sprung = factors(spring.text());
    RC_PRE(proofs::parse_decimal(held[0]).has_value());
    // a spring k lowers a factor by order F L / k of it, 1e-25 here; another factor is of order k
    RC_ASSERT(std::abs(std::stod(sprung[0]) / std::stod(held[0]) - 1) < 1e-14);
  });
}

TEST_CASE("a chain in the plane is a chain in space whose axes are all alike") {
  check_property("space", [] {
    Draft draft = random_draft();
    const bool held = one_in(2);
    draft.end = "{ across = " + restraint() + (held ? ", turn = \"held\" }" : " }");
    RC_LOG() << draft.text() << "\n" << as_in_space(draft);
    const auto plane = factors(draft.text());
    if (proofs::parse_decimal(plane[0])) {
      RC_ASSERT(plane == factors(as_in_space(draft)));
    } else {
      RC_ASSERT(!proofs::parse_decimal(factors(as_in_space(draft))[0]));
    }
  });
}

TEST_CASE("a support where a clamp already holds the chain changes nothing") {
  check_property("support", [] {
    Draft draft = random_draft();
    draft.stiffness[0] = "0", draft.base = "\"clamped\"";
    std::erase_if(draft.supports, [](const std::string& one) { return one.starts_with("{ at = 2,"); });
    Draft more = draft;
    more.supports.push_back("{ at = 2, across = " + restraint() + " }");
    same(draft, more);
  });
}

TEST_CASE("a path counts the negative directions of the straight line as the critical factors do") {
  check_property("verbs", [] {
    Draft draft = random_draft();
    const bool spatial = one_in(2);
    if (spatial) draft.end = "{ across = " + restraint() + (one_in(2) ? " }" : ", turn = \"held\" }");
    const std::string text = spatial ? as_in_space(draft) : draft.text();
    RC_LOG() << text;
    const StatedChain chain = parse_chain(text, "c");
    const auto found = factors(text);
    RC_PRE(proofs::parse_decimal(found[0]).has_value());
    const double factor = std::stod(decimal(1, 2000)) * std::stod(found[0]) / 4;
    std::size_t below = 0;
    for (const std::string& one : found) {
      below += std::stod(one) < factor ? 1 : 0;
      RC_PRE(std::abs(std::stod(one) / factor - 1) > 1e-6);
    }
    const auto index = [&](const BentStructure<double>& model) {
      BentSolver<double> solver(model);
      const auto at = solver.at_factor(model.rest(), factor, Vector<double>::Constant(model.held(), 0.0));
      RC_ASSERT(at.has_value());
      return at->negative_directions;
    };
    if (const auto* plane = std::get_if<PlaneChain>(&chain))
      RC_ASSERT(index(bent_structure(from_rational<double>(plane->structure))) == below);
    else
      RC_ASSERT(index(bent_structure(from_rational<double>(std::get<SpaceStructure<Rational>>(chain)))) ==
                below);
  });
}
