#pragma once
/// \file
/// Where a gap lies: shares of the squared, noise-weighted residual of the nominal model beyond noise.

#include "diagnose/discrepancy/joint_share.hpp"
#include "diagnose/inference/study.hpp"
#include "diagnose/noise/noise_estimate.hpp"
#include "diagnose/rig/regime.hpp"

namespace plumbline::diagnose {

struct ChannelShare {
  Channel channel;
  double share;
};
struct RunShare {
  std::string run;
  double share;
};
struct PathShare {
  std::string run;
  std::size_t from, to;  ///< first and last reading, from 0
  double share;
  Regime regime;
};

/// What the joints' shares stand on: the missing torque that measured joint angles show; the missing torque
/// that the explanations found would show; the chance of each joint to be named by them; or to be the one
/// place of an unknown torque.
enum class JointEvidence { measured, implied_by_fits, named_by_fits, implied_by_law };

/// The same in words.
std::string joint_evidence_words(JointEvidence evidence);

struct Where {
  std::vector<ChannelShare> channels;
  std::vector<RunShare> runs;
  std::vector<PathShare> load_path;  ///< empty for an arm in space, whose readings are poses
  std::vector<JointShare> joints;    ///< largest first
  JointEvidence joint_evidence = JointEvidence::implied_by_law;
};

/// By joint from measured torque alone; empty where none is measured, or noise alone may give what is
/// missing.
Where locate(const Study& study, const NoiseEstimate& noise);

}  // namespace plumbline::diagnose
