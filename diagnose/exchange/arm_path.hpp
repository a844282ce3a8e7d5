#pragma once
/// \file
/// The joints from the base of an arm to its tip, among those of a simulator's model.

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "diagnose/exchange/series.hpp"

namespace plumbline::exchange {

/// Names of the bodies or frames at the ends of an arm; empty: as the model has them.
struct ArmEnds {
  std::string base = {}, tip = {};
};

class ArmPath {
 public:
  /// Without a base the root of the tip. Without a tip the frame that is named as one, or else the body that
  /// carries none, farthest along the tree.
  /// \param source  named in errors
  /// \throws Error where an end is not there, or there twice, where there are several tips, or where the tip
  ///         does not hang from the base by joints
  ArmPath(const ReadModel& model, std::string source, const ArmEnds& ends);

  [[nodiscard]] const ReadFrame& base() const { return model_.frames[base_]; }
  [[nodiscard]] const ReadFrame& tip() const { return model_.frames[tip_]; }
  /// From the base on, numbers among the joints of the model.
  [[nodiscard]] const std::vector<std::size_t>& joints() const { return joints_; }

  /// The link of the arm that a joint of this name moves, from 1; 0 for the base and for no joint at the
  /// root; `elsewhere` where it hangs neither on the arm nor on its base.
  [[nodiscard]] std::size_t link_of(const std::string& joint) const;
  static constexpr std::size_t elsewhere = std::numeric_limits<std::size_t>::max();

  /// The name of the body that joint i of the arm, from 0, moves.
  [[nodiscard]] std::string link_name(std::size_t i) const;

 private:
  [[nodiscard]] std::size_t frame(const std::string& name) const;
  [[nodiscard]] std::size_t only_tip() const;
  [[nodiscard]] std::vector<std::size_t> possible_tips() const;
  [[nodiscard]] std::size_t root_of(std::size_t frame) const;
  [[nodiscard]] std::vector<std::size_t> joints_to(const std::string& carrier) const;
  void follow();

  const ReadModel& model_;
  std::string source_;
  JointNumbers numbers_;
  std::map<std::string, std::size_t> bodies_;
  std::size_t base_ = 0, tip_ = 0;
  std::vector<std::size_t> joints_;
};

}  // namespace plumbline::exchange
