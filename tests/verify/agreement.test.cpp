#include "verify/reference/agreement.hpp"

#include <plumbline/straight/buckling_mode.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/enclosure.hpp"
#include "tests/close_to.hpp"
#include "tests/property.hpp"
#include "verify/reference/condition.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using namespace plumbline::verify;

namespace {

const Chain<Rational> four_links({1, 1, 1, 1}, {1, 1, 1, 1});

ForceAgreement judged(const std::string& force, std::size_t mode = 1) {
  return compare("four", four_links, {{2, mode, force}}).at(0);
}

/// Sum over all inputs of the relative change of a critical force per relative change of that input, by
/// differences of certified forces.
Rational condition_by_differences(const Chain<Rational>& chain, std::size_t mode) {
  const Rational step = *parse_decimal("1e-25");
  const auto force = [&](const Chain<Rational>& changed) {
    const auto enclosed = enclose_critical_forces(changed, mode, 60).back();
    return Rational((enclosed.low + enclosed.high) / 2);
  };
  const Rational unchanged = force(chain);
  Rational sum(0);
  for (std::size_t i = 0; i < 2 * chain.size(); ++i) {
    std::vector<Rational> length = chain.length(), stiffness = chain.stiffness();
    (i < chain.size() ? length[i] : stiffness[i - chain.size()]) *= 1 + step;
    const Rational change = force(Chain<Rational>(length, stiffness)) / unchanged - 1;
    sum += change < 0 ? Rational(-change) : change;
  }
  return sum / step;
}

}  // namespace

TEST_CASE("the condition number is the sum of the relative derivatives") {
  const Chain<Rational> chains[] = {
      four_links,
      Chain<Rational>({1, 2, Rational(1, 1000), 5}, {0, 3, 100, Rational(1, 7)}),
      Chain<Rational>({3, 1, 2, 1}, {1, 2, 0, 5}),
  };
  for (const auto& chain : chains) {
    const auto modes = critical_modes(from_rational<Mpfr50>(chain), 3);
    for (std::size_t m = 1; m <= 3; ++m) {
      const double condition =
          condition_number(from_rational<Mpfr50>(chain), modes[m - 1]).convert_to<double>();
      // forces to 60 digits and steps of 1e-25: the differences have 25 digits and more
      CHECK(condition == close_to(from_rational<double>(condition_by_differences(chain, m))).epsilon(1e-14));
      CHECK(condition >= 2);
      CHECK(condition <= 6);
    }
  }
}

TEST_CASE("digits of agreement count from the certified force") {
  // the four-link chain: 0.92402759129590...
  const auto all = judged(compare("four", four_links, {{2, 1, "1"}}).at(0).reference);
  CHECK(all.digits > 19);
  CHECK(all.agrees());
  CHECK(judged("0.924027591295903").agrees() == (judged("0.924027591295903").digits >= all.permitted));
  CHECK(judged("0.92").digits == close_to(2.36).epsilon(0.01));  // relative error 0.00436
  CHECK(!judged("0.92").agrees());
}

TEST_CASE("a wrong value is told what it looks like") {
  CHECK(judged("-0.9240275912959").finding == "wrong sign: compression counts as positive");
  CHECK(judged("-1.08222659").finding == "the eigenvalue lambda = -1 / F, not the force");
  CHECK(judged("0.9240").finding == "right as far as it is written, 4 digits: print 17");
  CHECK(judged("2.305736876").finding == "the force of mode 2");
  CHECK(judged("1.84805518259").finding == "2 times too large");
  CHECK(judged("nan").finding == "not a number");
  CHECK(judged("0").finding == "zero");
  CHECK(judged("0.9240275913959031").finding == "rounding errors");
}

TEST_CASE("what disagreeing values have in common is named") {
  const Chain<Rational> pinned({1, 1, 1, 1}, {0, 1, 1, 1});
  auto values = compare("four", four_links, {{2, 1, "0.92402759129590256"}, {3, 2, "2.3057"}});
  const auto more = compare("pinned", pinned, {{4, 1, "0.58578643762"}, {5, 2, "2.00000000001"}});
  values.insert(values.end(), more.begin(), more.end());
  sort_worst_first(values);
  CHECK(values.front().submitted.line == 3);
  const auto places = where_to_look(values);
  REQUIRE(!places.empty());
  const bool named = std::any_of(places.begin(), places.end(), [](const std::string& place) {
    return place.find("passive base") != std::string::npos;
  });
  CHECK(named);
}
