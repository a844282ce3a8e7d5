#include "proofs/certificates/equilibria_certificate.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "proofs/census/covering.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_list.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/units.hpp"

namespace plumbline::proofs {
namespace {

using nlohmann::json;

const char* name(Given given) {
  return given == Given::force ? "force" : given == Given::end_point ? "end_point" : "deflection";
}

/// Numbers that are right to so many digits of a scale.
class Rounding {
 public:
  Rounding(const CensusTask& task, int most) : digits_(most) {
    length_ = *std::max_element(task.chain.length().begin(), task.chain.length().end());
    stiffness_ = *std::max_element(task.chain.stiffness().begin(), task.chain.stiffness().end());
    if (stiffness_ == 0) stiffness_ = 1;
  }
  [[nodiscard]] Rational force() const { return stiffness_ / length_; }
  [[nodiscard]] const Rational& length() const { return length_; }
  [[nodiscard]] const Rational& stiffness() const { return stiffness_; }
  [[nodiscard]] int digits() const { return digits_; }

  /// Fewer digits where an enclosure does not have them.
  void fit(const Interval& x, const Rational& scale) {
    const Rational width = exactly(x.upper()) - exactly(x.lower());
    while (digits_ > 1 && width * 4 > shifted(scale, -digits_)) --digits_;
  }
  [[nodiscard]] std::string operator()(const Interval& x, const Rational& scale) const {
    const Rational middle = exactly(x.middle()), last = shifted(scale, -digits_ - 1);
    if (abs(middle) < last) return "0";
    return to_decimal(middle, significant(middle, last));
  }

 private:
  /// Digits of x down to a place as small as `last`.
  static int significant(const Rational& x, const Rational& last) {
    int digits = 1;
    while (unit_in_digit(abs(x), digits) > last) ++digits;
    return digits;
  }

  Rational length_, stiffness_;
  int digits_;
};

/// The largest ball around an equilibrium that Krawczyk's operator proves to hold no other, to three digits.
struct Radii {
  std::string angle, force;
};

Radii radii(const EquilibriumBox& system, const Midpoint& centre, const Interval& force_unit) {
  constexpr int halvings = 38;
  for (int h = 0; h <= halvings; ++h) {
    const double radius = std::ldexp(0.4, -h), force = system.force_of(radius);
    if (!system.contracts(centre, radius, force)) continue;
    return {to_decimal(exactly(Interval::from_double(radius).middle()), 3),
            to_decimal(exactly((Interval::from_double(force) * force_unit).middle()), 3)};
  }
  throw Error("certificate", "an equilibrium that double precision cannot isolate",
              "equilibria farther from a fold");
}

/// What a checker that reads the decimals takes the ball to be, a little less.
Box ball_of(const EquilibriumBox& system, const Midpoint& centre, const Radii& r,
            const Interval& force_unit) {
  constexpr double certainly = 1 - 1e-6;
  const auto value = [](const std::string& text) { return Interval(*parse_decimal(text)); };
  const double angle = Span(value(r.angle)).low * certainly,
               force = Span(value(r.force) / force_unit).low * certainly;
  Box ball;
  for (std::size_t j = 0; j < system.unknowns(); ++j) {
    const double radius = j < system.links() ? angle : force;
    ball[j] = Span(centre[j] - radius, centre[j] + radius);
  }
  return ball;
}

Midpoint centre_of(const CertifiedEquilibrium& one, const Interval& force_unit) {
  Midpoint centre{};
  Interval theta(0);
  std::size_t j = 0;
  for (const Interval& q : one.q) centre[j++] = Span(theta += q).middle();
  centre[j++] = Span(one.fx / force_unit).middle();
  centre[j] = Span(one.fy / force_unit).middle();
  return centre;
}

Rounding rounding_of(const CensusTask& task, const Census& census, int digits) {
  Rounding text(task, digits);
  const bool held = task.control() == Control::end_point;
  for (const CertifiedEquilibrium& one : census.equilibria) {
    for (const Interval& q : one.q) text.fit(q, 1);
    for (const Interval& x : {one.fx, one.fy}) text.fit(x, text.force());
    if (!held) {
      for (const Interval& x : {one.x, one.y}) text.fit(x, text.length());
    }
    text.fit(one.energy, text.stiffness());
  }
  return text;
}

json stated(const CertifiedEquilibrium& one, const Rounding& text, bool held, const Radii& r) {
  json angles = json::array();
  for (const Interval& q : one.q) angles.push_back(text(q, 1));
  json entry{{"q", angles},
             {"energy", text(one.energy, text.stiffness())},
             {"negative_directions", one.negative_directions.value()},
             {"radius", r.angle}};
  if (held) {
    entry["response"] = {text(one.fx, text.force()), text(one.fy, text.force())};
    entry["force_radius"] = r.force;
  } else {
    entry["response"] = {text(one.x, text.length()), text(one.y, text.length())};
  }
  return entry;
}

/// The joint angles that are nearest to rest among those of links in one line.
json window_of(const CensusTask& task, const Window& window) {
  json list = json::array();
  for (std::size_t i = 0; i < window.size(); ++i) {
    const Interval centre =
        (Interval(window[i].lower(), window[i].lower()) + Interval(window[i].upper(), window[i].upper())) /
        (Interval(2) * Interval::pi());
    const bool own = i == 0 || task.chain.passive_joint(i);
    list.push_back(own ? 0 : std::lround(static_cast<double>(centre.middle())));
  }
  return list;
}

}  // namespace

json equilibria_certificate(const CensusTask& task, const Census& census, int digits) {
  if (!census.complete()) throw Error("certificate", "places left undecided", "a complete census");
  const Chain<Interval> chain = enclosed_chain(task);
  const Units units = own_units(chain);
  const bool held = task.control() == Control::end_point;
  const EquilibriumBox system(in_units(chain, units), task.control(),
                              in_units(enclosed_load(task), task.control(), units), census.window);
  const Rounding text = rounding_of(task, census, digits);
  json equilibria = json::array();
  std::vector<Box> balls;
  for (const CertifiedEquilibrium& one : census.equilibria) {
    if (!one.negative_directions)
      throw Error("certificate", "an equilibrium of a type that stays open",
                  "equilibria farther from a fold");
    const Midpoint centre = centre_of(one, units.force());
    const Radii r = radii(system, centre, units.force());
    equilibria.push_back(stated(one, text, held, r));
    balls.push_back(ball_of(system, centre, r, units.force()));
  }
  json entry{{"case", task.name},
             {"lengths", exact_list(task.chain.length())},
             {"stiffness", exact_list(task.chain.stiffness())},
             {"rest", exact_list(task.chain.rest())},
             {"rest_unit", task.rest_in_pi ? "pi" : "rad"},
             {"control", name(task.given)},
             {"load", exact_list({task.load.x, task.load.y})},
             {"digits", text.digits()},
             {"equilibria", std::move(equilibria)},
             {"covering", covering(system, balls)}};
  if (held) {
    entry["turns"] = task.turns;
    entry["window"] = window_of(task, census.window);
  }
  return entry;
}

}  // namespace plumbline::proofs
