#include "verify/reference/chains.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <map>

#include "proofs/exact/certified_modes.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/working_precision.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using namespace plumbline::verify;

TEST_CASE("the compact set is part of the full one, and names are unique") {
  std::map<std::string, Chain<Rational>> full;
  for (const auto& c : reference_chains({ReferenceSize::full, reference_seed})) {
    INFO(c.name);
    CHECK(full.emplace(c.name, c.chain).second);
    CHECK(c.modes <= c.chain.size() - 1);
    CHECK(c.shapes <= c.modes);
  }
  CHECK(full.size() > 3000);
  for (const auto& c : reference_chains({ReferenceSize::compact, reference_seed})) {
    INFO(c.name);
    REQUIRE(full.count(c.name) == 1);
    CHECK(full.at(c.name).length() == c.chain.length());
    CHECK(full.at(c.name).stiffness() == c.chain.stiffness());
  }
}

TEST_CASE("another seed gives other random chains and the same named ones") {
  const auto ours = reference_chains({ReferenceSize::compact, 1}),
             others = reference_chains({ReferenceSize::compact, 2});
  REQUIRE(ours.size() == others.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    INFO(ours[i].name);
    const bool same = ours[i].chain.length() == others[i].chain.length();
    const bool fixed = ours[i].name.starts_with("paper") || ours[i].name.starts_with("uniform") ||
                       ours[i].name.starts_with("geometric");
    CHECK(same == fixed);
  }
}

TEST_CASE("uniform chains with a passive base have the closed form 4 sin^2(m pi / 2n)") {
  for (const auto& c : reference_chains({ReferenceSize::compact, reference_seed})) {
    if (!c.name.starts_with("uniform-pinned")) continue;
    INFO(c.name);
    const WorkingPrecision precision(90);
    for (const ForceEnclosure& force :
         enclose_critical_forces(c.chain, std::min<std::size_t>(c.modes, 9), 50)) {
      const Mpfr pi = boost::math::constants::pi<Mpfr>();
      const Mpfr s = sin(Mpfr(Mpfr(static_cast<unsigned>(force.index)) * pi / Mpfr(2 * c.chain.size())));
      const Rational closed_form = exactly(Mpfr(4 * s * s));
      CHECK(force.low < closed_form);
      CHECK(closed_form < force.high);
    }
  }
}

TEST_CASE("ties tie exactly and near-ties do not") {
  for (const auto& c : reference_chains({ReferenceSize::compact, reference_seed})) {
    const bool near = c.name.starts_with("near-tie"), tie = c.name.starts_with("tie");
    if (!near && !tie) continue;
    INFO(c.name);
    const CertifiedModes modes = certify(c.chain, c.modes, 0, 50);
    CHECK(modes.ties.empty() == near);
  }
}
