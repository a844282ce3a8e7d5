#include "diagnose/exchange/corrected_springs.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/tree.hpp"
#include "diagnose/exchange/tree_path.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::NominalChain;

Model model_of(const NominalChain& chain, const std::string& file) {
  Model model{file, {}, chain.rest};
  static_cast<NominalChain&>(model.experiment) = chain;
  model.experiment.name = file;
  return model;
}

/// The springs that a file has for a chain with its effects.
NominalChain as_written(const NominalChain& chain, const std::string& file) {
  const Model model = model_of(chain, file);
  const Tree tree = tree_of(diagnose::nominal_rig(model.experiment), model, {});
  NominalChain written = chain;
  for (std::size_t j = 0; j < chain.link_length.size(); ++j) {
    const Hinge& hinge = *carrier_of(tree, chain_name(j))->joint;
    written.joint_stiffness[j] = hinge.stiffness;
    written.rest[j] = hinge.rest;
  }
  return written;
}

}  // namespace

/// What is written goes in proportion with what it is written for, and so do two trials.
void take_off_springs(NominalChain& chain, const std::string& file) {
  NominalChain other = chain;
  for (double& k : other.joint_stiffness) k *= 2;
  for (double& angle : other.rest) angle += 1;
  const NominalChain one = as_written(chain, file), two = as_written(other, file);
  const auto solve = [](double read, double trial, double written, double step) {
    return read + (read - written) * step / (trial - written);
  };
  for (std::size_t j = 0; j < chain.link_length.size(); ++j) {
    double &k = chain.joint_stiffness[j], &rest = chain.rest[j];
    if (k > 0) k = solve(k, two.joint_stiffness[j], one.joint_stiffness[j], k);
    rest = solve(rest, two.rest[j], one.rest[j], 1);
    if (!(k >= 0) || !std::isfinite(k + rest))
      throw Error(file,
                  "joint " + std::to_string(j + 1) + ", whose spring is none with the corrections in it",
                  "the stiffness that they were written with");
  }
}

bool has_friction(const NominalChain& chain, const std::string& file) {
  const std::vector<double> friction = diagnose::nominal_rig(model_of(chain, file).experiment).friction;
  return std::any_of(friction.begin(), friction.end(), [](double f) { return f > 0; });
}

}  // namespace plumbline::exchange
