#pragma once
/// \file
/// Selection of the serial chain among the joints of a simulator's model.

#include <string>
#include <vector>

#include "diagnose/exchange/read_joint.hpp"

namespace plumbline::exchange {

/// Joints by their names.
class JointNumbers {
 public:
  explicit JointNumbers(const ReadModel& model);
  /// Size of the model's joints where there is none of the name.
  [[nodiscard]] std::size_t of(const std::string& name) const;
  /// A name that two have; or empty.
  [[nodiscard]] std::string twice() const;

 private:
  std::vector<std::pair<std::string, std::size_t>> sorted_;
};

/// The most hinges with parallel axes that follow each other in a model: what errors offer where the whole is
/// no planar chain. Empty where none follows another.
std::vector<std::string> planar_part(const ReadModel& model);
/// "; plumbline chain --joints a,b keeps …", the advice at the end of an error; may be empty.
std::string how_to_keep(const ReadModel& model);

class Series {
 public:
  /// \param source  named in errors
  /// \param kept    the joints that make the chain; the others are held as the reference configuration has
  ///                them. Empty: all but those of objects that lie about
  /// \throws Error where a name is not there or there twice, one joint carries two, or none is at the base
  Series(const ReadModel& model, const std::string& source, const std::vector<std::string>& kept);

  /// From the base on, numbers among the joints of the model.
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  /// They, with all the mass that each moves while the others are held.
  [[nodiscard]] std::vector<ReadJoint> joints() const;
  /// Names of the joints that are held.
  [[nodiscard]] std::vector<std::string> held() const;
  /// Whether what the joint of this name moves is moved by the last of the chain.
  [[nodiscard]] bool at_the_end(const std::string& joint) const;

 private:
  void choose(const std::vector<std::string>& kept, const std::string& source);
  void follow(const std::string& source);

  const ReadModel& model_;
  JointNumbers numbers_;
  std::vector<bool> kept_;
  std::vector<std::size_t> carrier_;  ///< the joint of the chain that moves what each joint is on
  std::vector<std::size_t> order_;
};

}  // namespace plumbline::exchange
