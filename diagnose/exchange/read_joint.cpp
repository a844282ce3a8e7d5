#include "diagnose/exchange/read_joint.hpp"

#include <algorithm>
#include <map>

#include "diagnose/exchange/tree.hpp"

namespace plumbline::exchange {

void add_mass(ReadJoint& joint, double mass, const Eigen::Vector3d& middle) {
  if (!(mass > 0)) return;
  joint.middle = (joint.mass * joint.middle + mass * middle) / (joint.mass + mass);
  joint.mass += mass;
}

void drop_added(ReadModel& model) {
  const auto is_added = [&](const auto& one) { return model.rows.added.contains(one.name); };
  std::map<std::string, std::string> carrier_of;
  for (const ReadJoint& one : model.joints)
    if (is_added(one)) carrier_of[one.name] = one.carrier;
  const auto hang = [&](std::string& carrier) {
    for (std::size_t steps = 0; steps < carrier_of.size() && carrier_of.contains(carrier); ++steps)
      carrier = carrier_of.at(carrier);
  };
  for (ReadJoint& one : model.joints) hang(one.carrier);
  // A link that yields weighs in the middle, on a joint that was added.
  for (const ReadJoint& added : model.joints)
    if (is_added(added) && added.mass > 2 * speck)
      for (ReadJoint& one : model.joints)
        if (one.name == added.carrier) add_mass(one, added.mass, added.middle);
  std::erase_if(model.joints, is_added);
  std::erase_if(model.ends, is_added);
  std::erase_if(model.frames, is_added);
  for (ReadPoint& one : model.ends) hang(one.carrier);
  for (ReadFrame& one : model.frames) hang(one.carrier);
}

}  // namespace plumbline::exchange
