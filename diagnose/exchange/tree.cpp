#include "diagnose/exchange/tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "diagnose/rig/load_cell.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::Rig, diagnose::Vector2;

constexpr std::array<double, 3> gauss_place{0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, 3> gauss_weight{5.0 / 18, 4.0 / 9, 5.0 / 18};

Pair pair(const Vector2& v) {
  return {v.x(), v.y()};
}

class Builder {
 public:
  Builder(const Rig& rig, const Model& model, const Means& means)
      : rig_(rig), rest_(model.rest), nominal_rest_(model.rest), means_(means) {
    double sum = 0, elastic = 0;
    for (const double k : rig.stiffness) sum += k, elastic += k > 0;
    typical_ = elastic > 0 ? sum / elastic : 1;
    for (std::size_t i = 0; i < rest_.size(); ++i)
      rest_[i] = rest_[i] * std::exp(-rig.capstan * static_cast<double>(i)) + rig.rest_error[i];
    weigh(model.experiment);
    if (means.tendons && has_drive(rig)) drive(model.experiment);
  }

  Tree result() {
    base();
    for (std::size_t j = 0; j < rig_.length.size(); ++j) link(j);
    tree_.tip = here_;
    tree_.end = {at_, 0};
    tree_.load = {at_, rig_.eccentricity};
    if (rig_.payload.norm() > 0)
      tree_.bodies.push_back({"payload", here_, {at_, 0}, rig_.payload.norm() / gravity_, {}, 0, {}});
    couple();
    if (means_.tendons)
      for (std::size_t l = 0; l < rig_.laws.size(); ++l) follow_law(rig_.laws[l], l);
    return std::move(tree_);
  }

 private:
  /// Gravity along what weighs, as strong as the nominal model's or the catalogue's; masses follow.
  void weigh(const diagnose::Experiment& experiment) {
    const Vector2 own(experiment.gravity[0], experiment.gravity[1]);
    Vector2 total = rig_.payload;
    for (const Vector2& weight : rig_.weight) total += weight;
    gravity_ = own.norm() > 0 ? own.norm() : diagnose::standard_gravity;
    const bool weighs = total.norm() > 0;
    for (std::size_t j = 0; j < rig_.length.size(); ++j)
      mass_.push_back(weighs ? rig_.weight[j].norm() / gravity_ : experiment.link_mass[j]);
    if (weighs) tree_.gravity = pair(gravity_ / total.norm() * total);
  }

  void drive(const diagnose::Experiment& experiment) {
    constexpr double rigid = 1e6;  // over the stiffness of the chain
    const double reach = std::accumulate(rig_.length.begin(), rig_.length.end(), 0.0),
                 gain = 1 + rig_.force_gain;
    const diagnose::Response cell = response_of_cell(rig_);
    tree_.drive = Drive{.start = pair(unloaded_end(experiment, nominal_rest_)),
                        .turned = rig_.misalignment,
                        .friction = rig_.guide_friction,
                        .stiffness = rigid * typical_ / (reach * reach),
                        .matrix = {gain, gain * rig_.cross_talk.x(), gain * rig_.cross_talk.y(), gain},
                        .bias = pair(rig_.force_bias.head<2>()),
                        .drift = pair(rig_.force_drift.head<2>()),
                        .limit = std::isfinite(cell.limit) ? cell.limit : 0,
                        .lag = cell.lag};
  }

  [[nodiscard]] Hinge hinge(const std::string& name, double stiffness, double rest = 0) const {
    Hinge one{name};
    const double felt = stiffness > 0 ? stiffness : typical_;
    one.stiffness = stiffness;
    one.rest = rest;
    one.armature = felt * response_time * response_time;
    one.damping = 2 * felt * response_time;
    return one;
  }

  void add(const std::string& name, Pair place, std::optional<Hinge> joint) {
    tree_.bodies.push_back({name, here_, place, speck, {}, 0, std::move(joint)});
    // Of the size of a joint's, that of what is stiffer too, for it is turned by all joints before it.
    if (const auto& own = tree_.bodies.back().joint; own && own->along == 'z')
      tree_.bodies.back().turning = std::min(own->armature, typical_ * response_time * response_time);
    here_ = name;
    at_ = 0;
  }

  /// The body that carries the next, whatever stands beside it.
  Body& here() {
    return *std::find_if(tree_.bodies.begin(), tree_.bodies.end(),
                         [&](const Body& one) { return one.name == here_; });
  }

  void slide(const std::string& name, char along, double stiffness) {
    Hinge one = hinge(name, stiffness);
    one.along = along;
    add(name + "_slide", {at_, 0}, std::move(one));
  }

  void base() {
    add("base", {0 - rig_.position_offset.x(), 0 - rig_.position_offset.y()}, {});
    const Vector2 yields = rig_.base_compliance + Vector2(rig_.train_compliance, 0);
    if (yields.x() > 0) slide("base_x", 'x', 1 / yields.x());
    if (yields.y() > 0) slide("base_y", 'y', 1 / yields.y());
  }

  void link(std::size_t j) {
    joint(j);
    const double length = rig_.length[j];
    if (rig_.flexibility > 0) {
      beam(j);
    } else {
      weight(j, {length / 2 + rig_.centre[j].x(), rig_.centre[j].y()});
      here().length = length;
      at_ = length;
    }
    if (rig_.axial > 0) slide(fmt::format("stretch{}", j + 1), 'x', 1 / (rig_.axial * length));
  }

  void weight(std::size_t j, Pair middle) {
    if (!(mass_[j] > 0)) return;
    here().mass = mass_[j];
    here().middle = middle;
  }

  /// A link that bends: three hinges at the points of Gauss, as stiff as what each stands for.
  void beam(std::size_t j) {
    const double length = rig_.length[j];
    double behind = 0;
    for (std::size_t g = 0; g < 3; ++g) {
      here().length = (gauss_place[g] - behind) * length;
      const std::string name = fmt::format("bend{}_{}", j + 1, g + 1);
      add(name + "_part", {(gauss_place[g] - behind) * length, 0},
          hinge(name, 1 / (rig_.flexibility * gauss_weight[g] * length)));
      if (g == 1) weight(j, pair(rig_.centre[j]));
      turning_.push_back(name);
      behind = gauss_place[g];
    }
    here().length = (1 - behind) * length;
    at_ = (1 - behind) * length;
  }

  /// The joint of link j, and what acts beside its spring.
  void joint(std::size_t j) {
    const std::string name = fmt::format("q{}", j + 1), parent = here_;
    const Pair place{at_, 0};
    const double k = rig_.stiffness[j], asymmetric = std::abs(rig_.asymmetry[j]);
    Hinge own = hinge(name, k * (1 - asymmetric) - shared(j), rest_[j]);
    own.armature = (k > 0 ? k : typical_) * response_time * response_time;
    own.damping = 2 * (k > 0 ? k : typical_) * response_time;
    const bool plays = rig_.backlash[j] > 0,
               stops = std::isfinite(rig_.stop[j]) && rig_.stop_stiffness[j] > 0;
    const bool gives = rig_.presliding > 0;  // friction acts beside the joint then
    if (!plays && k > 0 && !gives) own.friction = rig_.friction[j];
    if (stops && means_.soft_ranges && !plays) {
      own.range = {rest_[j] - rig_.stop[j], rest_[j] + rig_.stop[j]};
      own.range_stiffness = rig_.stop_stiffness[j];
    }
    sum_.push_back({name});
    if (plays) {
      Hinge play = hinge(name + "_play", 0);
      play.range = {-rig_.backlash[j], rig_.backlash[j]};
      add(fmt::format("play{}", j + 1), place, std::move(play));
      add(fmt::format("link{}", j + 1), {0, 0}, std::move(own));
      sum_.back().push_back(name + "_play");
      if (k > 0 && rig_.friction[j] > 0 && !gives) tendon(name + "_dry", sum_.back(), 0, rig_.friction[j]);
    } else {
      add(fmt::format("link{}", j + 1), place, std::move(own));
    }
    for (const std::string& one : sum_.back()) turning_.push_back(one);
    beside(j, parent, place);
  }

  /// What the springs that neighbours share take off a joint's own.
  [[nodiscard]] double shared(std::size_t j) const {
    const std::size_t n = rig_.length.size();
    const double neighbours = (j > 0 ? 1 : 0) + (j + 1 < n ? 1 : 0);
    return std::abs(rig_.coupling) * neighbours;
  }

  /// A second hinge beside a joint, and a spring between the two: it carries what the second hinge holds.
  void arm(const std::string& name, const std::vector<std::string>& beside, const std::string& parent,
           Pair place, double stiffness, const std::function<void(Hinge&)>& holds) {
    Hinge second = hinge(name, 0);
    second.armature = stiffness * response_time * response_time;
    second.damping = 2 * stiffness * response_time;
    holds(second);
    // Dry friction that sticks creeps the faster the lighter what it holds; where it slips, damping drags.
    if (second.friction > 0) second.armature *= slow * slow, second.damping /= slow;
    tree_.bodies.push_back({name + "_arm", parent, place, speck, {}, 0, std::move(second)});
    Tendon& spring = tendon(name, beside, stiffness, 0);
    spring.joints.emplace_back(name, -1);
  }

  Tendon& tendon(const std::string& name, const std::vector<std::string>& joints, double stiffness,
                 double friction) {
    Tendon& one = tree_.tendons.emplace_back(Tendon{name, {}, stiffness, friction});
    for (const std::string& joint : joints) one.joints.emplace_back(joint, 1);
    return one;
  }

  void beside(std::size_t j, const std::string& parent, Pair place) {
    const std::string name = fmt::format("q{}", j + 1);
    const std::vector<std::string>& all = sum_.back();
    const double k = rig_.stiffness[j], s = rig_.stop[j];
    parent_.push_back(parent);
    place_.push_back(place);
    if (means_.tendons && std::isfinite(s) && rig_.stop_stiffness[j] > 0)
      arm(name + "_stop", all, parent, place, rig_.stop_stiffness[j], [&](Hinge& one) {
        one.range = {-s, s};
      });
    if (rig_.asymmetry[j] != 0 && k > 0)
      arm(name + "_side", {name}, parent, place, 2 * k * std::abs(rig_.asymmetry[j]), [&](Hinge& one) {
        one.range = rig_.asymmetry[j] > 0 ? Pair{-far, 0} : Pair{0, far};
      });
    for (std::size_t a = 0; a < rig_.arms.size() && k > 0; ++a) {
      const double stiffness = rig_.arms[a].ratio * k;
      if (stiffness > 0)
        arm(fmt::format("{}_relax{}", name, a + 1), all, parent, place, stiffness,
            [&](Hinge& one) { one.damping = stiffness * rig_.arms[a].time; });
    }
    if (rig_.presliding > 0 && rig_.friction[j] > 0 && k > 0)
      arm(name + "_dry", all, parent, place, rig_.friction[j] / rig_.presliding,
          [&](Hinge& one) { one.friction = rig_.friction[j]; });
    for (std::size_t e = 0; e < rig_.sliders[j].size() && k > 0; ++e) {
      const diagnose::Slider& slider = rig_.sliders[j][e];
      if (slider.ratio > 0)
        arm(fmt::format("{}_slip{}", name, e + 1), all, parent, place, slider.ratio * k,
            [&](Hinge& one) { one.friction = slider.yield; });
    }
    if (rig_.give[j] > 0 && std::isfinite(rig_.knee[j]) && k > 0) give_way(j, name);
    // The potential k c d^4 / 4: a slide that is at d^4, pulled back by a constant force.
    if (const double c = rig_.hardening[j]; c != 0 && k > 0) follow(j, name + "_cubic", 4, -k * c / 4);
  }

  /// A slide that goes with a power of the deflection of joint j.
  void follow(std::size_t j, const std::string& name, int power, double force) {
    Hinge own{name};
    own.along = 'x';
    own.armature = typical_ * response_time * response_time;
    tree_.bodies.push_back({name + "_slide", parent_[j], {0, 0}, speck, {}, 0, own});
    tree_.followers.push_back({name, fmt::format("q{}", j + 1), power, rest_[j], force});
  }

  /// What a spring gives way by beyond its knee to either side, beside that spring.
  void give_way(std::size_t j, const std::string& name) {
    const double s = rig_.knee[j], softer = rig_.give[j] * rig_.stiffness[j], e = rig_.asymmetry[j];
    climb(name + "_give", {name}, rest_[j],
          {{-s - 1, softer * (1 - e)}, {-s, 0}, {s, 0}, {s + 1, -softer * (1 + e)}});
  }

  /// A free torque law, beside the joint's spring: its knots, sliders and Maxwell arms.
  void follow_law(const diagnose::FreeLaw& law, std::size_t number) {
    const std::size_t j = law.joint - 1;
    const std::string name =
        fmt::format("q{}_law{}", law.joint, number > 0 ? fmt::format("{}_", number + 1) : "");
    if (!law.knots.empty()) climb(name, sum_[j], rest_[j], law.knots);
    for (std::size_t s = 0; s < law.sliders.size(); ++s) {
      const diagnose::FreeLaw::Slider& one = law.sliders[s];
      const std::string own = fmt::format("{}_slip{}", name, s + 1);
      const auto slips_at = [](double friction) {
        return [friction](Hinge& held) { held.friction = friction; };
      };
      if (one.torque > 0)
        arm(own, sum_[j], parent_[j], place_[j], one.torque / one.slips_at, slips_at(one.torque));
      if (!(one.growth > 0)) continue;
      // It slides along d^2 / 2; the slide is at d^2.
      const std::string square = own + "_square";
      follow(j, square, 2, 0);
      arm(own + "_wide", {square}, parent_[j], place_[j], one.growth / (2 * one.slips_at * one.slips_at),
          slips_at(one.growth / 2));
    }
    for (std::size_t a = 0; a < law.arms.size(); ++a)
      arm(fmt::format("{}_relax{}", name, a + 1), sum_[j], parent_[j], place_[j], law.arms[a].stiffness,
          [&](Hinge& one) { one.damping = law.arms[a].stiffness * law.arms[a].time_constant; });
  }

  /// A torque that is straight between knots and on beyond them, as ramps: the first was climbed long ago.
  /// \param turning  the hinges whose angles add up to that of the torque
  void climb(const std::string& name, const std::vector<std::string>& turning, double rest,
             std::vector<diagnose::FreeLaw::Knot> knots) {
    if (knots.size() > 1) {
      const auto beyond = [](const diagnose::FreeLaw::Knot& last, const diagnose::FreeLaw::Knot& before) {
        const double way = std::copysign(far / 100, last.deflection - before.deflection);
        return diagnose::FreeLaw::Knot{
            last.deflection + way,
            last.torque + way * (last.torque - before.torque) / (last.deflection - before.deflection)};
      };
      knots.insert(knots.begin(), beyond(knots[0], knots[1]));
      knots.push_back(beyond(knots.back(), knots[knots.size() - 2]));
    }
    std::vector<std::pair<std::string, double>> joints;
    for (const std::string& one : turning) joints.emplace_back(one, 1);
    tree_.ramps.push_back({name + "0", joints, rest - 2 * far, rest - far, -knots.front().torque});
    for (std::size_t k = 1; k < knots.size(); ++k)
      tree_.ramps.push_back({fmt::format("{}{}", name, k), joints, rest + knots[k - 1].deflection,
                             rest + knots[k].deflection, knots[k - 1].torque - knots[k].torque});
  }

  /// What couples joints with each other.
  void couple() {
    const double kappa = rig_.coupling;
    for (std::size_t j = 0; j + 1 < sum_.size() && kappa != 0; ++j) {
      Tendon& one = tendon(fmt::format("shared{}", j + 1), sum_[j], std::abs(kappa), 0);
      for (const std::string& next : sum_[j + 1]) one.joints.emplace_back(next, kappa > 0 ? -1 : 1);
    }
    if (rig_.tip_stiffness > 0) tendon("tip", turning_, rig_.tip_stiffness, 0);
  }

  static constexpr double slow = 5;   // how much slower than joints what slips settles
  static constexpr double far = 1e3;  // rad: farther than any joint turns

  const Rig& rig_;
  std::vector<double> rest_, nominal_rest_;
  Means means_;
  double typical_ = 1, gravity_ = 0;
  std::vector<double> mass_;
  Tree tree_;
  std::string here_;                           ///< the body that carries the next
  double at_ = 0;                              ///< and where on it
  std::vector<std::vector<std::string>> sum_;  ///< by joint: the hinges whose angles add up to its own
  std::vector<std::string> turning_;           ///< those that turn the last link
  std::vector<std::string> parent_;            ///< by joint: the body that carries it
  std::vector<Pair> place_;                    ///< by joint: where on that
};

}  // namespace

bool has_drive(const Rig& rig) {
  return rig.misalignment != 0 || rig.guide_friction > 0 || rig.force_gain != 0 ||
         !rig.force_bias.isZero(0) || !rig.force_drift.isZero(0) || !rig.cross_talk.isZero(0) ||
         std::isfinite(response_of_cell(rig).limit) || response_of_cell(rig).lag > 0;
}

Tree tree_of(const Rig& rig, const Model& model, const Means& means) {
  return Builder(rig, model, means).result();
}

}  // namespace plumbline::exchange
