#include "diagnose/report/effect_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <plumbline/base/error.hpp>
#include <string>

namespace plumbline::diagnose {
namespace {

struct Words {
  EffectId effect;
  std::string_view meaning;                              ///< {} is the joint
  std::array<std::array<std::string_view, 2>, 2> units;  ///< parameter and its unit
};

constexpr std::array<Words, effect_count> all{{
    {EffectId::joint_stiffness, "a wrong stiffness of joint {}", {{{"a", "ratio"}}}},
    {EffectId::link_length, "a wrong length of link {}", {{{"a", "ratio"}}}},
    {EffectId::rest_angle, "a wrong rest angle of joint {}", {{{"a", "rad"}}}},
    {EffectId::nonlinear_spring,
     "joint springs that harden or soften with their deflection",
     {{{"c", "1/rad²"}}}},
    {EffectId::backlash, "play in joint {}", {{{"b", "rad"}}}},
    {EffectId::joint_friction, "dry friction in the joints", {{{"tau_c", "N m"}}}},
    {EffectId::joint_stop, "a stop at joint {}", {{{"s", "rad"}, {"k_s", "N m/rad"}}}},
    {EffectId::joint_coupling, "springs that neighbouring joints share", {{{"kappa", "N m/rad"}}}},
    {EffectId::gravity, "the weight of the links", {{{"rho", "kg/m"}}}},
    {EffectId::tip_payload, "a weight at the end point", {{{"weight", "N"}}}},
    {EffectId::base_compliance, "a base that yields", {{{"c_x", "m/N"}, {"c_y", "m/N"}}}},
    {EffectId::axial_compliance, "links that stretch and shorten", {{{"c_a", "1/N"}}}},
    {EffectId::link_bending, "links that bend", {{{"EI", "N m²"}}}},
    {EffectId::rail_misalignment, "a rail that is turned from where it should point", {{{"eps", "rad"}}}},
    {EffectId::eccentric_load, "a load that acts beside the end point", {{{"e", "m"}}}},
    {EffectId::tip_stiffness, "an end pivot that is not free", {{{"k_t", "N m/rad"}}}},
    {EffectId::guide_friction, "dry friction in the guide", {{{"f_c", "N"}}}},
    {EffectId::force_bias, "a tare error of the load cell", {{{"b_x", "N"}, {"b_y", "N"}}}},
    {EffectId::force_gain, "a scale error of the load cell", {{{"g", "ratio"}}}},
    {EffectId::position_offset,
     "an end point that is not where it was commanded",
     {{{"d_x", "m"}, {"d_y", "m"}}}},
    {EffectId::train_compliance, "a load train that yields", {{{"c_t", "m/N"}}}},
    {EffectId::viscoelasticity, "springs that relax in time", {{{"m", "ratio"}, {"tau", "s"}}}},
    {EffectId::sensor_drift, "a load cell that drifts in time", {{{"r_x", "N/s"}, {"r_y", "N/s"}}}},
}};

const Words& words(EffectId effect) {
  return *std::find_if(all.begin(), all.end(), [&](const Words& one) { return one.effect == effect; });
}

}  // namespace

std::string in_words(const EffectAt& at) {
  return fmt::format(fmt::runtime(words(at.effect).meaning), at.joint);
}

std::string_view unit(EffectId effect, std::string_view parameter) {
  for (const auto& [name, its_unit] : words(effect).units)
    if (name == parameter) return its_unit;
  throw Error("unit", "a parameter " + std::string(parameter), "one of " + std::string(effect_name(effect)));
}

}  // namespace plumbline::diagnose
