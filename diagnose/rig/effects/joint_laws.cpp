/// \file
/// Joint torque laws with several parameters: piecewise springs, stops, hysteresis, plastic set, relaxation
/// spectra.

#include <array>
#include <cmath>
#include <utility>

#include "diagnose/priors.hpp"
#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/onsets.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

// ------------------------------------------------------------------------------------------- hysteresis

/// The search begins with three elements and continues to lower and higher orders.
constexpr std::size_t fewest_elements = 1, first_elements = 3, most_elements = 5;
/// A stiffer element slips within one reading and is dry friction.
constexpr double stiffest = 4;

/// An element is fitted by the deflection at which it slips instead of its slip torque, so that its torque is
/// proportional to r.
std::vector<ParameterRange> element_ranges(std::size_t elements, const Place& at) {
  std::vector<ParameterRange> all;
  for (std::size_t e = 0; e < elements; ++e) {
    all.push_back(of(ParameterKind::spring_part, numbered("r", e), at).within(0, stiffest));
    all.push_back(of(ParameterKind::slip_deflection, numbered("d", e), at));
  }
  return all;
}

/// Slip deflections in geometric progression, from where few readings see an element to where it hardly
/// slips.
InitialGuesses element_guesses(std::size_t elements, double deflection) {
  InitialGuesses guesses{{}, 2};
  for (const auto& [least, most] : {std::pair{0.02, 0.5}, {0.05, 1.0}}) {
    std::vector<double> start;
    for (std::size_t e = 0; e < elements; ++e) {
      const double way = elements > 1 ? static_cast<double>(e) / static_cast<double>(elements - 1) : 0.5;
      start.push_back(0.3 / static_cast<double>(elements));
      start.push_back(least * std::pow(most / least, way) * deflection);
    }
    guesses.points.push_back(std::move(start));
  }
  return guesses;
}

/// \param stiffness  of the joint's spring
void add_elements(std::vector<Slider>& sliders, std::size_t elements, double stiffness, const double* value) {
  for (std::size_t e = 0; e < elements; ++e) {
    const double ratio = value[2 * e], turn = value[2 * e + 1];
    sliders.push_back({ratio, ratio * stiffness * turn});
  }
}

std::vector<const Effect*> hystereses(bool at_joint);

/// Common part of both hysteresis rows.
Effect hysteresis_of(std::size_t elements, bool at_joint) {
  Effect row;
  row.id = "hysteresis";
  row.at_joint = at_joint;
  row.dissipates = true;
  row.parameters = [=](const Place& at) { return element_ranges(elements, at); };
  for (std::size_t e = 0; e < elements; ++e) row.perturbation.growing.push_back(2 * e);
  row.perturbation.large_step = true;
  row.element_size = 2;
  row.orders = [=] { return hystereses(at_joint); };
  return row;
}

Effect hysteresis_at_all(std::size_t elements) {
  Effect row = hysteresis_of(elements, false);
  row.words = "hysteresis in the joints";
  row.add = [=](const Addition& to) {
    for (auto& sliders : to.rig.sliders) add_elements(sliders, elements, to.scales.stiffness, to.value);
  };
  row.possible = [](const Place& at) { return turns_back(at) && several_elastic(at); };
  row.initial_guesses = [=](const Place&, const Excitation& nominal) {
    return element_guesses(elements, nominal.largest);
  };
  return row;
}

Effect hysteresis_at_one(std::size_t elements) {
  Effect row = hysteresis_of(elements, true);
  row.words = "hysteresis in joint {}";
  row.add = [=](const Addition& to) {
    add_elements(to.rig.sliders[to.joint], elements, to.scales.stiffness_at(to.joint), to.value);
  };
  row.possible = [](const Place& at) { return turns_back(at) && is_elastic(at); };
  row.initial_guesses = [=](const Place& at, const Excitation& nominal) {
    return element_guesses(elements, nominal.deflection[at.joint]);
  };
  return row;
}

/// The rows of all orders, from one element on; the one with `first_elements` is in the catalogue.
std::vector<const Effect*> hystereses(bool at_joint) {
  static const auto rows = [] {
    std::array<std::vector<Effect>, 2> all;
    for (std::size_t elements = fewest_elements; elements <= most_elements; ++elements) {
      all[0].push_back(hysteresis_at_all(elements));
      all[1].push_back(hysteresis_at_one(elements));
    }
    return all;
  }();
  std::vector<const Effect*> numbers;
  for (const Effect& row : rows[at_joint ? 1 : 0]) numbers.push_back(&row);
  numbers[first_elements - fewest_elements] = &effect("hysteresis", at_joint ? 1 : 0);
  return numbers;
}

std::vector<Effect> hysteresis() {
  return {hysteresis_at_all(first_elements), hysteresis_at_one(first_elements)};
}

// ---------------------------------------------------------------------------------------------- springs

std::vector<Effect> springs() {
  return {
      {.id = "asymmetric_spring",
       .words = "springs that are stiffer in one direction",
       .parameters = one_of(ParameterKind::asymmetry, "e"),
       .add =
           [](const Addition& to) {
             for (double& e : to.rig.asymmetry) e += to.value[0];
           },
       .possible = any_elastic},
      {.id = "asymmetric_spring",
       .words = "springs that are stiffer in one direction, each by its own amount",
       .parameters =
           [](const Place& at) {
             return each(at, {"e", "ratio", priors::asymmetry_tolerance, -0.9, 0.9});
           },
       .add =
           [](const Addition& to) {
             for_each_elastic(to, [&](std::size_t i, double e) { to.rig.asymmetry[i] += e; });
           },
       .possible = several_elastic,
       .nested = {"asymmetric_spring"},
       .form = "each its own",
       .within_values = {"asymmetric_spring"}},
  };
}

std::vector<ParameterRange> piecewise_ranges(const Place& at) {
  constexpr double most_give = 2;  // relative loss of stiffness beyond the knee: beyond 1 the torque falls
  return {of(ParameterKind::onset_angle, "s", at),
          of(ParameterKind::spring_part, "a", at).within(0, most_give)};
}

InitialGuesses piecewise_guesses(double reach) {
  return onset_guesses({0.2, 0.6}, [&](double share, double give) {
    return std::vector{share * reach, give};
  });
}

/// Piecewise springs: a common threshold, one joint.
std::vector<Effect> piecewise_springs() {
  return {
      {.id = "piecewise_spring",
       .words = "springs that soften beyond an angle",
       .parameters = piecewise_ranges,
       .add =
           [](const Addition& to) {
             to.rig.knee.assign(to.rig.knee.size(), to.value[0]);
             to.rig.give.assign(to.rig.give.size(), to.value[1]);
           },
       .possible = several_elastic,
       .initial_guesses = [](const Place&,
                             const Excitation& nominal) { return piecewise_guesses(nominal.largest); },
       .perturbation = {.growing = {1}}},
      {.id = "piecewise_spring",
       .words = "a spring of joint {} that softens beyond an angle",
       .at_joint = true,
       .parameters = piecewise_ranges,
       .add =
           [](const Addition& to) {
             to.rig.knee[to.joint] = to.value[0];
             to.rig.give[to.joint] = to.value[1];
           },
       .possible = is_elastic,
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             return piecewise_guesses(nominal.deflection[at.joint]);
           },
       .perturbation = {.growing = {1}}},
  };
}

/// That of stops at all joints, by the mean spring.
ParameterRange stiffness_of_stops(const Place& at) {
  const ParameterRange own = of(ParameterKind::stop_stiffness, "k_s", at);
  const double ratio = at.scales.stiffness / at.scales.stiffness_at(at.joint);
  return {own.name, own.unit, own.coordinate, ratio * own.scale, own.low, ratio * own.high};
}

bool several_that_turn(const Place& at) {
  return std::count(at.scales.rigid.begin(), at.scales.rigid.end(), false) > 1;
}

/// Stops: a common angle, one angle a joint.
std::vector<Effect> stops() {
  return {
      {.id = "joint_stops",
       .words = "stops at every joint",
       .parameters =
           [](const Place& at) {
             return std::vector{of(ParameterKind::onset_angle, "s", at), stiffness_of_stops(at)};
           },
       .add =
           [](const Addition& to) {
             to.rig.stop.assign(to.rig.stop.size(), to.value[0]);
             to.rig.stop_stiffness.assign(to.rig.stop.size(), to.value[1]);
           },
       .possible = several_that_turn,
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             return stop_guesses([&](double share, double stiff) {
               return std::vector{share * nominal.largest, stiff * at.scales.stiffness};
             });
           },
       .perturbation = {.growing = {1}}},
      {.id = "joint_stops",
       .words = "stops at every joint, each at its own angle",
       .parameters =
           [](const Place& at) {
             std::vector<ParameterRange> all{stiffness_of_stops(at)};
             for (std::size_t i = 0; i < at.scales.link_length.size(); ++i)
               all.push_back(of(ParameterKind::onset_angle, numbered("s", i), at));
             return all;
           },
       .add =
           [](const Addition& to) {
             to.rig.stop_stiffness.assign(to.rig.stop.size(), to.value[0]);
             for (std::size_t i = 0; i < to.rig.stop.size(); ++i) to.rig.stop[i] = to.value[1 + i];
           },
       .possible = several_that_turn,
       .nested = {"joint_stops", "joint_stop"},
       .form = "each its own",
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             return stop_guesses([&](double share, double stiff) {
               std::vector<double> start{stiff * at.scales.stiffness};
               for (const double reach : nominal.deflection) start.push_back(share * reach);
               return start;
             });
           },
       .perturbation = {.growing = {0}}},
  };
}

// ----------------------------------------------------------------------------------------- time and set

std::vector<Effect> memory() {
  return {
      {.id = "relaxation_spectrum",
       .words = "springs that relax with two time constants",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{
                 of(ParameterKind::spring_part, "m_1", at), of(ParameterKind::decay_time, "tau_1", at),
                 of(ParameterKind::spring_part, "m_2", at), of(ParameterKind::decay_time, "tau_2", at)};
           },
       .add =
           [](const Addition& to) {
             to.rig.arms.push_back({to.value[0], to.value[1]});
             to.rig.arms.push_back({to.value[2], to.value[3]});
           },
       // Time constants are distinguishable where the sampling interval is much shorter than both.
       .possible =
           [](const Place& at) {
             return any_elastic(at) && at.scales.clock &&
                    at.scales.duration > 20 * at.scales.sampling_interval;
           },
       .nested = {"viscoelasticity"},
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             const double low = std::log(2 * at.scales.sampling_interval),
                          high = std::log(0.4 * at.scales.duration);
             return InitialGuesses{{{0.1, low, 0.1, high}}, 1};
           },
       .perturbation = {.growing = {0, 2}},
       .element_size = 2},
      {.id = "plastic_set",
       .words = "rest angles that shift plastically beyond a torque",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{of(ParameterKind::yield_torque, "tau_y", at),
                                of(ParameterKind::plastic_part, "slope", at)};
           },
       .add =
           [](const Addition& to) {
             to.rig.yield = to.value[0];
             to.rig.flow = to.value[1];
           },
       .possible = [](const Place& at) { return turns_back(at) && any_elastic(at); },
       .initial_guesses =
           [](const Place&, const Excitation& nominal) {
             InitialGuesses guesses{{}, 1};
             for (const double share : {0.2, 0.4, 0.6, 0.8})
               guesses.points.push_back({share * nominal.torque, 0.1});
             return guesses;
           },
       .perturbation = {.growing = {1}}},
      {.id = "tendon_friction",
       .words = "friction of the tendon that sets the rest angles",
       .parameters = one_of(ParameterKind::rope_friction, "mu"),
       .add = [](const Addition& to) { to.rig.capstan += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.bent_at_rest && at.scales.led_together; }},
  };
}

}  // namespace

std::vector<Effect> joint_law_effects() {
  std::vector<Effect> rows;
  for (const auto& group : {springs, piecewise_springs, stops, hysteresis, memory})
    for (Effect& row : group()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
