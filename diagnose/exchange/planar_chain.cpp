#include "diagnose/exchange/planar_chain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <plumbline/base/error.hpp>

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;

/// Angles and lengths to this share count as equal: models are written to six digits or so.
constexpr double rounding = 1e-5;
/// Simulators demand a mass, kg, of a body that weighs nothing.
constexpr double no_mass = 1e-4;

/// From the base on.
/// \throws Error where one joint carries two, or none is at the base
std::vector<const ReadJoint*> in_series(const ReadModel& model, const std::string& source) {
  std::vector<const ReadJoint*> order;
  std::string carrier;
  while (order.size() < model.joints.size()) {
    std::vector<const ReadJoint*> next;
    for (const ReadJoint& joint : model.joints)
      if (joint.carrier == carrier) next.push_back(&joint);
    const std::string where = carrier.empty() ? "the base" : "joint " + carrier;
    if (next.size() > 1)
      throw Error(source, fmt::format("joints {} and {} at {}", next[0]->name, next[1]->name, where),
                  "a serial chain, one joint after the other");
    if (next.empty())
      throw Error(source, "no joint after " + where, "a serial chain, one joint after the other");
    order.push_back(next.front());
    carrier = next.front()->name;
  }
  return order;
}

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

void require_planar(const std::vector<const ReadJoint*>& joints, const Plane& plane,
                    const std::string& source) {
  for (const ReadJoint* joint : joints) {
    if (!joint->hinge) throw Error(source, "joint " + joint->name + ", which is no hinge", "hinges alone");
    const double turned = std::acos(std::min(1.0, std::abs(joint->axis.normalized().dot(plane.normal()))));
    if (turned > std::sqrt(rounding))
      throw Error(source,
                  fmt::format("joint {}, whose axis is turned by {:.3g} rad from that of joint {}",
                              joint->name, turned, joints.front()->name),
                  "a planar chain: parallel axes");
  }
}

/// Where the last link ends: where the model says, or as far beyond its centre of mass as that is from the
/// joint.
Vector3d end_of(const ReadModel& model, const ReadJoint& last, const std::string& source,
                std::vector<std::string>& notes) {
  if (model.end) {
    notes.emplace_back("end point: " + model.end_name);
    return *model.end;
  }
  if (!(last.mass > 0) || (last.middle - last.anchor).norm() < rounding)
    throw Error(source, "no end of the last link, " + last.name, "a site or frame at the end point");
  notes.emplace_back("end point: no site or frame names it; taken twice as far out as the centre of mass");
  return 2 * last.middle - last.anchor;
}

}  // namespace

bool names_an_end(const std::string& name) {
  return name.find("end") != std::string::npos || name.find("tip") != std::string::npos;
}

Vector3d Plane::normal() const {
  return x.cross(y);
}

PlanarChain planar_chain(const ReadModel& model, const std::string& source) {
  if (model.joints.empty()) throw Error(source, "no joint", "a chain of hinges");
  const std::vector<const ReadJoint*> joints = in_series(model, source);
  const Plane plane = plane_of(*joints.front());
  require_planar(joints, plane, source);
  PlanarChain result;
  result.plane = plane;
  std::vector<std::string> names;
  names.reserve(joints.size());
  for (const ReadJoint* joint : joints) names.push_back(joint->name);
  result.notes.push_back(fmt::format("joints: {}", fmt::join(names, ", ")));
  const Vector3d end = end_of(model, *joints.back(), source, result.notes);
  double before = 0, moved = 0;
  diagnose::NominalChain& chain = result.chain;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const ReadJoint& joint = *joints[j];
    const Vector3d far = j + 1 < joints.size() ? joints[j + 1]->anchor : end;
    const Eigen::Vector2d link = plane.of(far - joint.anchor);
    if (!(link.norm() > rounding))
      throw Error(source, "joint " + joint.name + " and what follows in the same place",
                  "a serial chain of links with a length");
    const double direction = std::atan2(link.y(), link.x());
    const double sense = joint.axis.dot(plane.normal()) > 0 ? 1 : -1;
    result.joints.push_back({static_cast<std::size_t>(&joint - model.joints.data()), sense});
    chain.link_length.push_back(link.norm());
    chain.joint_stiffness.push_back(joint.stiffness);
    chain.link_mass.push_back(joint.mass > no_mass ? joint.mass : 0);
    chain.rest.push_back(std::remainder(direction - before, 2 * std::numbers::pi) + sense * joint.rest);
    before = direction;
    const Eigen::Vector2d middle = plane.of(joint.middle - joint.anchor) - link / 2;
    if (joint.mass > no_mass) moved = std::max(moved, middle.norm() / link.norm());
    if (sense < 0)
      result.notes.emplace_back("joint " + joint.name + " turns the other way: its angles change sign");
  }
  const Eigen::Vector2d gravity = plane.of(model.gravity);
  chain.gravity = {gravity.x(), gravity.y()};
  if (plane.of(plane.origin).norm() > rounding)
    result.notes.push_back(fmt::format("joint {} is at {:.6g}, {:.6g} of the model: here at the origin",
                                       names.front(), plane.of(plane.origin).x(),
                                       plane.of(plane.origin).y()));
  if (moved > 0.01 && gravity.norm() > 0)
    result.notes.push_back(fmt::format(
        "centres of mass are up to {:.2g} of a link from its middle, where this chain has them", moved));
  const auto passive = std::count(chain.joint_stiffness.begin(), chain.joint_stiffness.end(), 0.0);
  if (passive > 0)
    result.notes.push_back(fmt::format("not elastic: {} of {} joints", passive, joints.size()));
  if (!model.left_out.empty())
    result.notes.push_back(fmt::format("left out: {}", fmt::join(model.left_out, ", ")));
  return result;
}

}  // namespace plumbline::exchange
