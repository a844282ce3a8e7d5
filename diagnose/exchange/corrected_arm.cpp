#include "diagnose/exchange/corrected_arm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/arm_document.hpp"
#include "diagnose/exchange/read_model.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;

bool differs(const Isometry3d& a, const Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() > last_digit;
}

PointMass sum_of(const std::vector<ArmPart>& parts, std::size_t link) {
  PointMass sum;
  for (const ArmPart& one : parts) {
    if (one.link != link || !(one.mass > 0)) continue;
    sum.centre = (sum.mass * sum.centre + one.mass * one.centre) / (sum.mass + one.mass);
    sum.mass += one.mass;
  }
  return sum;
}

class Editor {
 public:
  explicit Editor(const CorrectedArm& corrected)
      : corrected_(corrected),
        before_(read_arm(corrected.source, corrected.ends)),
        document_(arm_document(corrected.source, corrected.ends)) {
    if (corrected.arm.size() != before_.nominal.arm.size())
      throw Error(corrected.source.string(), fmt::format("{} joints", before_.nominal.arm.size()),
                  fmt::format("the {} of the corrected arm", corrected.arm.size()));
  }

  Written result() {
    for (std::size_t i = 0; i < now().size(); ++i) edit_joint(i);
    if (differs(now().tip, old().tip)) add("pose of the tip", document_->set_tip(now().tip));
    if ((now().gravity - old().gravity).norm() > last_digit)
      add("gravity", document_->set_gravity(now().gravity));
    for (std::size_t i = 0; i < now().size(); ++i) edit_weight(i);
    if (corrected_.payload.mass > 0)
      add("payload", document_->add_weight("payload", now().size() - 1, corrected_.payload.mass,
                                           now().tip * corrected_.payload.centre));
    edits_.insert(edits_.end(), corrected_.others.begin(), corrected_.others.end());
    const std::string name = corrected_.source.filename().string();
    std::vector<std::string> lines{corrected_.title, "Edited: " + name + "."};
    for (const Carried& one : edits_)
      lines.push_back(fmt::format("{}{}: {}", one.carried ? "" : "NOT CARRIED: ", one.effect, one.how));
    return {document_->text(lines), edits_, name + " with the correction in it"};
  }

 private:
  [[nodiscard]] const SerialArm<double>& now() const { return corrected_.arm; }
  [[nodiscard]] const SerialArm<double>& old() const { return before_.nominal.arm; }

  void add(const std::string& what, const Edit& edit) { edits_.push_back({what, edit.carried, edit.how}); }

  void edit_joint(std::size_t i) {
    const ArmLink<double>&own = now().links[i], &was = old().links[i];
    const std::string &joint = before_.nominal.joint[i], &link = before_.nominal.link[i];
    if (own.kind != was.kind)
      throw Error(corrected_.source.string(), "joint " + joint,
                  "one of the same kind as in the corrected arm");
    const Isometry3d frame = i > 0 ? own.frame : old().base.inverse() * now().base * own.frame;
    if (differs(frame, was.frame) || (own.axis - was.axis).norm() > last_digit)
      add("frame of joint " + joint, document_->set_joint(i, frame, own.axis));
    if (std::abs(own.joint_compliance - was.joint_compliance) > last_digit * was.joint_compliance)
      add("stiffness of joint " + joint,
          own.joint_compliance > 0 ? document_->set_stiffness(i, 1 / own.joint_compliance)
                                   : Edit{false, "a joint that does not yield has no number in this file"});
    if (!corrected_.friction.empty() && corrected_.friction[i] != before_.friction[i])
      add("friction of joint " + joint, document_->set_friction(i, corrected_.friction[i]));
    if (!own.compliance.isZero(0))
      add("compliance of link " + link, {false, "links of this format are rigid"});
  }

  /// All bodies of a link by one factor and one shift, so that the link weighs as it is to.
  void edit_weight(std::size_t i) {
    const ArmLink<double>& own = now().links[i];
    const std::string what = "mass and centre of link " + before_.nominal.link[i];
    const std::vector<ArmPart> parts = document_->parts();
    const PointMass sum = sum_of(parts, i);
    const bool same = std::abs(own.mass - sum.mass) <= last_digit * sum.mass &&
                      (own.mass == 0 || (own.centre - sum.centre).norm() <= last_digit);
    if (same) return;
    if (sum.mass == 0) {
      add(what, document_->add_weight(before_.nominal.link[i] + "_mass", i, own.mass, own.centre));
      return;
    }
    Edit edit{false, "a link that weighs nothing, in a format of bodies that do"};
    for (std::size_t p = 0; p < parts.size() && own.mass > 0; ++p)
      if (parts[p].link == i)
        edit = document_->set_part(p, own.mass / sum.mass, parts[p].centre + own.centre - sum.centre);
    add(what, edit);
  }

  const CorrectedArm& corrected_;
  SpatialArm before_;
  std::unique_ptr<ArmDocument> document_;
  std::vector<Carried> edits_;
};

}  // namespace

Written edited(const CorrectedArm& corrected) {
  return Editor(corrected).result();
}

}  // namespace plumbline::exchange
