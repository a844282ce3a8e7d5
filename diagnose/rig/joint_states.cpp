#include "diagnose/rig/joint_states.hpp"

namespace plumbline::diagnose {

JointStates::JointStates(const Rig& own, const Run& run)
    : on_(own, run.rest), command_(run, own.drive), memory_(run.rest.size()) {
  for (const JointLaw& law : on_.joint) rest_then_.push_back(law.rest);
}

const Reading& JointStates::head_for(const Stop& stop, const Passage& passage) {
  const Reading& led = command_.at(stop);
  interval_ = passage.first ? TimeStep{} : time_step(on_, passage.dt);
  interval_.end = stop.reading.t;
  interval_.covariates = led.covariates;
  if (!led.rest.empty()) on_.turn_to(led.rest);
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    const double rest = on_.joint[i].rest;
    (passage.first ? memory_[i].angle : memory_[i].led) = passage.first ? rest : rest - rest_then_[i];
    memory_[i].speed = passage.dt > 0 ? passage.share * memory_[i].turn / passage.dt : 0;
  }
  return led;
}

}  // namespace plumbline::diagnose
