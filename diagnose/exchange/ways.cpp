#include "diagnose/exchange/ways.hpp"

#include <map>
#include <plumbline/base/error.hpp>
#include <set>

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
constexpr Way no_creep{false, "sensors of this format do not creep"};
constexpr Way no_point{false, "this format has no place for where a force acts"};

/// Rows that any simulator of bodies carries, or none.
const std::map<std::string_view, Way>& everywhere() {
  static const std::map<std::string_view, Way> all{{"joint_stiffness", stiffness},
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
                                                   {"angle_bias", no_joint_sensor},
                                                   {"angle_scale", no_joint_sensor},
                                                   {"torque_bias", no_joint_sensor},
                                                   {"torque_scale", no_joint_sensor},
                                                   {"angle_drift", no_joint_sensor},
                                                   {"angle_cross_talk", no_joint_sensor},
                                                   {"angle_lag", no_joint_sensor},
                                                   {"tilt_bias", no_joint_sensor},
                                                   {"tilt_scale", no_joint_sensor},
                                                   {"tilt_drift", no_joint_sensor},
                                                   {"tilt_cross_talk", no_joint_sensor},
                                                   {"tilt_lag", no_joint_sensor},
                                                   {"torque_drift", no_joint_sensor},
                                                   {"torque_cross_talk", no_joint_sensor},
                                                   {"torque_lag", no_joint_sensor},
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
                                                   {"plastic_set", no_set}};
  return all;
}

/// What takes a format that couples joints, and drives and reads them.
const std::map<std::string_view, Way>& coupled() {
  static const std::map<std::string_view, Way> all{
      {"nonlinear_spring", quartic}, {"hardening_spread", quartic}, {"joint_stop", stop},
      {"joint_stops", stop},         {"joint_coupling", shared},    {"tip_stiffness", shared},
      {"viscoelasticity", maxwell},  {"asymmetric_spring", side},   {"relaxation_spectrum", maxwell},
      {"hysteresis", jenkins},       {"eccentric_load", load_site}, {"force_bias", cell_zero},
      {"force_gain", cell_scale},    {"cross_talk", cell_scale},    {"sensor_drift", cell_drift},
      {"saturation", cell_limit},    {"sensor_lag", cell_lag},      {"rail_misalignment", rail},
      {"guide_friction", guide},     {"piecewise_spring", ramps}};
  return all;
}

/// Effects of the bench, not of the chain.
const std::set<std::string_view>& of_the_bench() {
  static const std::set<std::string_view> all{"force_bias",        "force_gain",    "cross_talk",
                                              "sensor_drift",      "saturation",    "sensor_lag",
                                              "rail_misalignment", "guide_friction"};
  return all;
}

Way without_coupling(Format format, std::string_view effect) {
  if (effect == "joint_stop" || effect == "joint_stops")
    return format == Format::sdf ? range : Way{false, "a range of this format has no stiffness"};
  static const std::set<std::string_view> springs{"nonlinear_spring", "hardening_spread", "asymmetric_spring",
                                                  "piecewise_spring"};
  if (springs.contains(effect)) return linear;
  if (of_the_bench().contains(effect)) return no_bench;
  return effect == "eccentric_load" ? no_point : no_coupling;
}

}  // namespace

bool adds_weight(std::string_view effect) {
  const auto found = everywhere().find(effect.substr(0, effect.find('(')));
  return found != everywhere().end() && found->second.weighs;
}

Way way_of(Format format, const diagnose::NominalEffect& effect) {
  if (format == Format::toml) return {true, "as [[nominal.effect]]"};
  const bool gives = effect.id == "joint_friction" && effect.parameters.contains("d_s");
  if (gives) return format == Format::mjcf ? jenkins : no_presliding;
  const bool late = effect.id == "sensor_lag" && effect.parameters.contains("delay");
  if (late && format == Format::mjcf) return no_delay;
  if (const auto found = everywhere().find(effect.id); found != everywhere().end()) return found->second;
  const auto found = coupled().find(effect.id);
  if (found == coupled().end()) throw Error("effect", effect.id, "an id of the effect catalogue");
  return format == Format::mjcf ? found->second : without_coupling(format, effect.id);
}

}  // namespace plumbline::exchange
