#include "diagnose/exchange/ways.hpp"

#include <map>
#include <plumbline/base/error.hpp>
#include <string>

namespace plumbline::exchange {
namespace {

constexpr Way stiffness{true, "as the stiffness of the joints", true};
constexpr Way springref{true, "as the angles at which the springs are at ease"};
constexpr Way rest_shape{true,
                         "as the angles at which the springs are at ease, in the rest shape of the file"};
constexpr Way body_places{true, "as the places of the bodies", true};
constexpr Way masses{true, "as masses and gravity", true, true};
constexpr Way scaled_masses{true, "as masses and gravity", true};
constexpr Way centres{true, "as the centres of mass of the bodies", true};
constexpr Way payload{true, "as masses and gravity", false, true};
constexpr Way base_slides{true, "as slides on springs under the base"};
constexpr Way base_slide{true, "as a slide on a spring under the base, which answers the same"};
constexpr Way two_hinges{true, "as two hinges in series, one of them with a range"};
constexpr Way frictionloss{true, "as the dry friction of the joints", true};
constexpr Way stop{true, "as a hinge with a range and a spring between it and the joint"};
constexpr Way range{true, "as the range of the joint, which yields by the stop's stiffness"};
constexpr Way side{true, "as a hinge held on one side and a spring between it and the joint"};
constexpr Way maxwell{true, "as a damped hinge and a spring between it and the joint"};
constexpr Way jenkins{true, "as a hinge with dry friction and a spring between it and the joint"};
constexpr Way quartic{true,
                      "as a slide under a constant force that follows the fourth power of the deflection"};
constexpr Way ramps{true, "as forces that go with the joint's angle from knot to knot"};
constexpr Way shared{true, "as springs on sums of joint angles"};
constexpr Way stretch{true, "as a slide on a spring in every link"};
constexpr Way beam{true, "as three hinges on springs in every link, at the points of Gauss"};
constexpr Way load_site{true, "as the site load, where forces act"};
constexpr Way offset{true, "as the place of the base"};

constexpr Way cell_scale{true, "as a load cell on the drive: the coefficients of the tendons that read it"};
constexpr Way cell_zero{true, "as a load cell on the drive: where its slides are at ease"};
constexpr Way cell_drift{true, "as a load cell on the drive, one joint of whose tendons goes with time"};
constexpr Way cell_limit{true, "as a load cell on the drive: the cutoff of its sensors"};
constexpr Way cell_lag{true, "as a load cell on the drive, read where damped slides follow it"};
constexpr Way rail{true, "as the frame of the drive's slides"};
constexpr Way guide{true, "as dry friction on the way of the drive and its load cell"};
constexpr Way no_bench{false,
                       "of the bench, for which this format has no sensors or drives that could carry it"};
constexpr Way runs{false, "differs from run to run"};
constexpr Way linear{false, "springs of this format are linear"};
constexpr Way constant{false, "dry friction of this format is a constant"};
constexpr Way no_curve{false, "sensors of this format show in proportion"};
constexpr Way no_presliding{false, "dry friction of this format does not give before it slips"};
constexpr Way no_camera{false, "of the camera, not of the chain"};
constexpr Way no_second_sensor{false, "of a second sensor, not of the chain"};
constexpr Way no_pulley{false, "of the pulley, not of the chain"};
constexpr Way no_tendon{false, "of the tendons or pressures that load the chain, not of the chain"};
constexpr Way no_set{false, "rest angles of this format do not move"};
constexpr Way no_servo{false, "of the servos, not of the chain"};
constexpr Way no_counterweight{false, "this format has no torque that goes with the cosine of an angle"};
constexpr Way no_joint_sensor{false, "of the sensors of the joints, not of the chain"};
constexpr Way no_coupling{false, "joints of this format are not coupled"};
constexpr Way no_travel{false, "the range of the joint, which is left as it is"};
constexpr Way no_slip{false, "springs of this format do not slip at their fixture"};
constexpr Way no_delay{false, "sensors of this file follow, and have no delay"};
constexpr Way no_covariate{false, "of the sensors of covariates, not of the chain"};
constexpr Way no_creep{false, "sensors of this format do not creep"};
constexpr Way no_point{false, "this format has no place for where a force acts"};

constexpr Way no_range{false, "a range of this format has no stiffness"};

/// A row of the catalogue, by its id; or one of several forms of it, by a parameter that this form alone has.
struct Row {
  constexpr Row(const char* of, const char* own = "") : id(of), parameter(own) {}
  constexpr Row(std::string_view of, std::string_view own) : id(of), parameter(own) {}
  std::string_view id, parameter;
  auto operator<=>(const Row&) const = default;
};

/// Those of the three formats of simulators. MJCF couples joints, and drives and reads them.
struct Ways {
  constexpr Ways(const Way& all) : Ways(all, all) {}
  constexpr Ways(const Way& of_mjcf, const Way& others) : Ways(of_mjcf, others, others) {}
  constexpr Ways(const Way& of_mjcf, const Way& of_sdf, const Way& of_urdf)
      : mjcf(of_mjcf), sdf(of_sdf), urdf(of_urdf) {}
  Way mjcf, sdf, urdf;
};

std::map<Row, Ways> table_of_ways() {
  std::map<Row, Ways> all{
      {"joint_stiffness", stiffness},
      {"stiffness_scale", stiffness},
      {"stiffness_spread", stiffness},
      {"rest_angle", springref},
      {"rest_offset", springref},
      {"rest_spread", springref},
      {"tendon_friction", rest_shape},
      {"link_length", body_places},
      {"length_scale", body_places},
      {"length_spread", body_places},
      {"gravity", masses},
      {"mass_scale", scaled_masses},
      {"tip_payload", payload},
      {"base_compliance", base_slides},
      {"train_compliance", base_slide},
      {"backlash", two_hinges},
      {"play", two_hinges},
      {"joint_friction", frictionloss},
      {"friction_spread", frictionloss},
      {"axial_compliance", stretch},
      {"link_bending", beam},
      {"position_offset", offset},
      {"pulley_friction", no_pulley},
      {"moment_arm", no_tendon},
      {"capstan_friction", no_tendon},
      {"camera_scale", no_camera},
      {"camera_turn", no_camera},
      {"run_rest", runs},
      {"run_tare", runs},
      {"load_friction", constant},
      {"direction_friction", constant},
      {"speed_friction", constant},
      {"cell_curvature", no_curve},
      {"second_zero", no_second_sensor},
      {"second_gain", no_second_sensor},
      {"link_mass", masses},
      {"link_centre", centres},
      {"joint_scale", no_servo},
      {"gear_coupling", no_servo},
      {"gravity_compensation", no_servo},
      {"encoder_ripple", no_servo},
      {"command_delay", no_servo},
      {"joint_balance", no_counterweight},
      {"command_drift", no_servo},
      {"second_drift", no_second_sensor},
      {"second_cross_talk", no_second_sensor},
      {"second_lag", no_second_sensor},
      {"place_drift", no_camera},
      {"place_lag", no_camera},
      {"camera_skew", no_camera},
      {"upper_limit", no_travel},
      {"lower_limit", no_travel},
      {"series_friction", no_slip},
      {"sensor_creep", no_creep},
      {"plastic_set", no_set},
      {"nonlinear_spring", {quartic, linear}},
      {"hardening_spread", {quartic, linear}},
      {"joint_stop", {stop, range, no_range}},
      {"joint_stops", {stop, range, no_range}},
      {"joint_coupling", {shared, no_coupling}},
      {"tip_stiffness", {shared, no_coupling}},
      {"viscoelasticity", {maxwell, no_coupling}},
      {"asymmetric_spring", {side, linear}},
      {"relaxation_spectrum", {maxwell, no_coupling}},
      {"hysteresis", {jenkins, no_coupling}},
      {"eccentric_load", {load_site, no_point}},
      {"force_bias", {cell_zero, no_bench}},
      {"force_gain", {cell_scale, no_bench}},
      {"cross_talk", {cell_scale, no_bench}},
      {"sensor_drift", {cell_drift, no_bench}},
      {"saturation", {cell_limit, no_bench}},
      {"sensor_lag", {cell_lag, no_bench}},
      {"rail_misalignment", {rail, no_bench}},
      {"guide_friction", {guide, no_bench}},
      {"piecewise_spring", {ramps, linear}},
      {{"joint_friction", "d_s"}, {jenkins, no_presliding}},
      {{"sensor_lag", "delay"}, {no_delay, no_bench}},
      {"command_scale", no_servo},
      {"applied_bias", no_tendon},
      {"applied_scale", no_tendon},
      {"applied_drift", no_tendon},
      {"applied_lag", no_tendon},
      {"covariate_lag", no_covariate},
  };
  for (const char* id : {"angle_bias", "angle_scale", "angle_drift", "angle_cross_talk", "angle_lag",
                         "tilt_bias", "tilt_scale", "tilt_drift", "tilt_cross_talk", "tilt_lag",
                         "torque_bias", "torque_scale", "torque_drift", "torque_cross_talk", "torque_lag"})
    all.emplace(id, no_joint_sensor);
  return all;
}

const std::map<Row, Ways>& ways() {
  static const std::map<Row, Ways> all = table_of_ways();
  return all;
}

/// \throws Error for an id that no row has
const Ways& ways_of(const diagnose::NominalEffect& effect) {
  for (const auto& [parameter, value] : effect.parameters)
    if (const auto form = ways().find({effect.id, parameter}); form != ways().end()) return form->second;
  const auto row = ways().find({effect.id, ""});
  if (row == ways().end()) throw Error("effect", effect.id, "an id of the effect catalogue");
  return row->second;
}

}  // namespace

bool adds_weight(std::string_view effect) {
  const auto row = ways().find({effect.substr(0, effect.find('(')), ""});
  return row != ways().end() && row->second.mjcf.weighs;
}

Way way_of(Format format, const diagnose::NominalEffect& effect) {
  const Ways& all = ways_of(effect);
  switch (format) {
    case Format::mjcf:
      return all.mjcf;
    case Format::sdf:
      return all.sdf;
    case Format::urdf:
      return all.urdf;
    case Format::toml:
      break;
  }
  return {true, "as [[nominal.effect]]"};
}

}  // namespace plumbline::exchange
