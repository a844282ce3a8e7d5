#include "diagnose/exchange/planar_chain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numbers>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/exchange/series.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;

/// Angles and lengths to this share count as equal: models are written to six digits or so.
constexpr double rounding = 1e-5;
/// Simulators demand a mass, kg, of a body that weighs nothing.
constexpr double no_mass = 1e-4;

Plane plane_of(const ReadJoint& first) {
  Plane plane;
  plane.origin = first.anchor;
  const Vector3d axis = first.axis.normalized(), up(0, 0, 1);
  if (std::abs(axis.dot(up)) > 1 - rounding) return plane;
  plane.y = (up - axis.dot(up) * axis).normalized();
  plane.x = plane.y.cross(axis);
  if (plane.x.x() + rounding * plane.x.y() < 0) plane.x = -plane.x;
  return plane;
}

void require_planar(const std::vector<ReadJoint>& joints, const Plane& plane, const std::string& source,
                    const ReadModel& model) {
  for (const ReadJoint& joint : joints) {
    if (joint.stiffness < 0)
      throw Error(source, "joint " + joint.name + " with a negative stiffness", "zero or a positive one");
    if (joint.motion != JointMotion::hinge)
      throw Error(source, "joint " + joint.name + ", which is no hinge", "hinges alone" + how_to_keep(model));
    const double turned = std::acos(std::min(1.0, std::abs(joint.axis.normalized().dot(plane.normal()))));
    if (turned > std::sqrt(rounding))
      throw Error(source,
                  fmt::format("joint {}, whose axis is turned by {:.3g} degrees from that of joint {}",
                              joint.name, turned * 180 / std::numbers::pi, joints.front().name),
                  "a planar chain: parallel axes" + how_to_keep(model));
  }
}

/// A point of the last link: one that is named as an end, or else the farthest.
std::optional<ReadPoint> named_end(const ReadModel& model, const Series& series, const ReadJoint& last) {
  std::optional<ReadPoint> best;
  bool named = false;
  for (const ReadPoint& point : model.ends) {
    if (!series.at_the_end(point.carrier)) continue;
    const bool is_end = names_an_end(point.name);
    const auto reach = [&](const ReadPoint& one) { return (one.place - last.anchor).norm(); };
    if (best && (named != is_end ? named : reach(*best) >= reach(point))) continue;
    named = is_end;
    best = point;
  }
  return best;
}

/// Where the last link ends: where the model says, or as far beyond its centre of mass as that is from the
/// joint.
Vector3d end_of(const std::optional<ReadPoint>& end, const ReadJoint& last, const std::string& source,
                std::vector<std::string>& notes) {
  if (end) {
    notes.emplace_back("end point: " + end->kind + " " + end->name);
    return end->place;
  }
  if (!(last.mass > 0) || (last.middle - last.anchor).norm() < rounding)
    throw Error(source, "no end of the last link, " + last.name, "a site or frame at the end point");
  notes.emplace_back("end point: no site or frame names it; taken twice as far out as the centre of mass");
  return 2 * last.middle - last.anchor;
}

/// The words of a name: "endEffector_2" has "end" and "effector".
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  bool small = false;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalpha(letter) == 0 || (small && std::isupper(letter) != 0)) words.emplace_back();
    small = std::islower(letter) != 0;
    if (std::isalpha(letter) != 0) words.back() += static_cast<char>(std::tolower(letter));
  }
  return words;
}

/// Without what adding and turning leaves behind the twelfth digit: 0.1 + 0.2 is 0.3.
/// \param scale  that of the value, where it may be as good as nought; or 0
double rounded(double value, double scale) {
  constexpr double last = 1e-12;
  return std::abs(value) < last * scale ? 0 : std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr);
}

/// Numbers of a file are finite, but their squares and sums need not be.
void require_finite(const diagnose::NominalChain& chain, const std::string& source) {
  double sum = chain.gravity[0] + chain.gravity[1];
  for (const auto* list : {&chain.link_length, &chain.joint_stiffness, &chain.link_mass, &chain.rest})
    for (const double value : *list) sum += value;
  if (!std::isfinite(sum)) throw Error(source, "numbers too large to compute with", "SI units, radians");
}

/// The dry friction of a file's joints as the catalogue has it; passive joints have none there.
std::vector<diagnose::NominalEffect> friction_rows(const std::vector<ReadJoint>& joints) {
  std::map<std::string, double> each;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (!(joints[j].stiffness > 0)) continue;
    each[fmt::format("tau_{}", j + 1)] = joints[j].friction;
    least = std::min(least, joints[j].friction);
    most = std::max(most, joints[j].friction);
  }
  if (!(most > 0)) return {};
  if (least == most) return {{"joint_friction", 0, {{"tau_c", most}}}};
  return {{"friction_spread", 0, each}};
}

/// The centre of mass of a link as the catalogue has it, which adds it to the middle.
/// \param off  from there, along the link and across
diagnose::NominalEffect centre_row(std::size_t link, const Eigen::Vector2d& off, double length) {
  return {"link_centre", link, {{"d_x", rounded(off.x(), length)}, {"d_y", rounded(off.y(), length)}}};
}

/// What the model has and a chain in the plane has not.
std::vector<std::string> left_out_of(const ReadModel& model) {
  constexpr double once_around = 6.2;
  std::vector<std::string> out = model.left_out;
  for (const ReadJoint& joint : model.joints) {
    if (joint.friction > 0 && !(joint.stiffness > 0)) out.push_back("friction of " + joint.name);
    if (joint.motion == JointMotion::hinge && joint.range[1] - joint.range[0] < once_around)
      out.push_back("range of " + joint.name);
    if (!joint.follows.empty()) out.push_back("coupling of " + joint.name + " to " + joint.follows);
  }
  return out;
}

void add_notes(const ReadModel& model, const std::vector<ReadJoint>& joints, PlanarChain& result) {
  const Eigen::Vector2d base = result.plane.of(result.plane.origin);
  const diagnose::NominalChain& chain = result.chain;
  if (base.norm() > rounding)
    result.notes.push_back(fmt::format("joint {} is at {:.6g}, {:.6g} of the model: here at the origin",
                                       joints.front().name, base.x(), base.y()));
  result.notes.insert(result.notes.end(), model.notes.begin(), model.notes.end());
  const auto passive = std::count(chain.joint_stiffness.begin(), chain.joint_stiffness.end(), 0.0);
  if (passive > 0)
    result.notes.push_back(fmt::format("not elastic: {} of {} joints", passive, joints.size()));
  if (const std::vector<std::string> out = left_out_of(model); !out.empty())
    result.notes.push_back(fmt::format("left out: {}", fmt::join(out, ", ")));
}

}  // namespace

bool names_an_end(const std::string& name) {
  static const std::set<std::string> ends{"end", "endpoint", "effector", "endeffector", "tip",    "fingertip",
                                          "ee",  "eef",      "tcp",      "tool",        "tooltip"};
  const std::vector<std::string> words = words_of(name);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) { return ends.contains(word); });
}

Vector3d Plane::normal() const {
  return x.cross(y);
}

PlanarChain planar_chain(const ReadModel& model, const std::string& source,
                         const std::vector<std::string>& kept) {
  if (model.joints.empty()) throw Error(source, "no joint", "a chain of hinges");
  const Series series(model, source, kept);
  const std::vector<ReadJoint> joints = series.joints();
  const Plane plane = plane_of(joints.front());
  require_planar(joints, plane, source, model);
  PlanarChain result;
  result.plane = plane;
  for (const ReadJoint& joint : joints) result.names.push_back(joint.name);
  result.weighs = model.gravity.norm() > 0;
  result.notes.push_back(fmt::format("joints: {}", fmt::join(result.names, ", ")));
  if (const std::vector<std::string> held = series.held(); !held.empty())
    result.notes.push_back(fmt::format("held: {}", fmt::join(held, ", ")));
  result.end = named_end(model, series, joints.back());
  const Vector3d end = end_of(result.end, joints.back(), source, result.notes);
  const Eigen::Vector2d gravity = plane.of(model.gravity);
  double before = 0;
  diagnose::NominalChain& chain = result.chain;
  chain.gravity = {rounded(gravity.x(), 1), rounded(gravity.y(), 1)};
  chain.effects = friction_rows(joints);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const ReadJoint& joint = joints[j];
    const Vector3d far = j + 1 < joints.size() ? joints[j + 1].anchor : end;
    const Eigen::Vector2d link = plane.of(far - joint.anchor);
    if (!(link.norm() > rounding))
      throw Error(source, "joint " + joint.name + " and what follows in the same place",
                  "a serial chain of links with a length");
    const double direction = std::atan2(link.y(), link.x());
    const double sense = joint.axis.dot(plane.normal()) > 0 ? 1 : -1;
    chain.link_length.push_back(rounded(link.norm(), 0));
    chain.joint_stiffness.push_back(rounded(joint.stiffness, 0));
    chain.link_mass.push_back(joint.mass > no_mass ? rounded(joint.mass, 0) : 0);
    const double turned = std::remainder(direction - before, 2 * std::numbers::pi);
    chain.rest.push_back(rounded(turned + sense * joint.rest, 1));
    result.joints.push_back({series.order()[j], sense, rounded(turned, 1)});
    before = direction;
    const Eigen::Vector2d off =
        Eigen::Rotation2Dd(-direction) * (plane.of(joint.middle - joint.anchor) - link / 2);
    if (joint.mass > no_mass && off.norm() > rounding * link.norm() && gravity.norm() > 0)
      chain.effects.push_back(centre_row(j + 1, off, link.norm()));
    if (sense < 0)
      result.notes.emplace_back("joint " + joint.name + " turns the other way: its angles change sign");
  }
  require_finite(chain, source);
  add_notes(model, joints, result);
  return result;
}

}  // namespace plumbline::exchange
