#include "proofs/census/census.hpp"

#include <fmt/core.h>

#include "proofs/census/equilibrium_box.hpp"
#include "proofs/census/equilibrium_enclosure.hpp"
#include "proofs/exact/units.hpp"

namespace plumbline::proofs {

namespace {

/// The search: a stack of boxes still to be seen.
class Search {
 public:
  Search(const EquilibriumBox& system, const CensusLimits& limits) : system_(&system), limits_(limits) {}

  void run() {
    todo_.push_back(system_->everything());
    while (!todo_.empty()) {
      if (++boxes_ > limits_.boxes)
        throw Error("census", std::to_string(limits_.boxes) + " boxes without an end",
                    "a search that fits the limit");
      const Box z = todo_.back();
      todo_.pop_back();
      see(z);
    }
  }

  std::vector<Box> isolated;   ///< each holds exactly one root
  std::vector<Box> undecided;  ///< hulls of what was too small to halve
  [[nodiscard]] std::size_t boxes() const { return boxes_; }

 private:
  static constexpr double isolation_pays = 0.5;  // width in radians

  void see(Box z) {
    if (!system_->narrow(z) || known(z)) return;
    const double width = z[system_->widest(z)].width();
    if (width < isolation_pays) {
      isolate(z);
      if (known(z)) return;
    }
    if (width < limits_.smallest)
      give_up(z);
    else
      halve(z);
  }

  [[nodiscard]] bool known(const Box& z) const {
    return std::any_of(isolated.begin(), isolated.end(), [&](const Box& one) {
      for (std::size_t j = 0; j < system_->unknowns(); ++j) {
        if (!z[j].inside(one[j])) return false;
      }
      return true;
    });
  }

  void isolate(const Box& z) {
    const auto root = system_->root_near(z);
    if (!root) return;
    Box point;
    for (std::size_t j = 0; j < system_->unknowns(); ++j) point[j] = Span((*root)[j]);
    if (known(point)) return;
    if (const auto box = system_->isolate(*root)) isolated.push_back(*box);
    require_few(isolated.size(), "equilibria");
  }

  void halve(const Box& z) {
    const std::size_t j = system_->widest(z);
    const double middle = z[j].middle();
    todo_.push_back(z);
    todo_.back()[j].high = middle;
    todo_.push_back(z);
    todo_.back()[j].low = middle;
  }

  void give_up(const Box& z) {
    if (++open_ > limits_.open)
      throw Error("census", fmt::format("equilibria all over more than {} smallest boxes", limits_.open),
                  "isolated ones: here they form a continuum, or nearly");
    for (Box& cluster : undecided) {
      bool near = true;
      for (std::size_t j = 0; j < system_->unknowns() && near; ++j) {
        const double slack = 1000 * limits_.smallest;
        near = z[j].low <= cluster[j].high + slack && cluster[j].low - slack <= z[j].high;
      }
      if (!near) continue;
      for (std::size_t j = 0; j < system_->unknowns(); ++j) cluster[j] = hull(cluster[j], z[j]);
      return;
    }
    undecided.push_back(z);
    require_few(undecided.size(), "undecided places");
  }

  void require_few(std::size_t number, const char* what) const {
    if (number > limits_.listed) {
      throw Error("census", fmt::format("more than {} {}", limits_.listed, what),
                  "a load under which the equilibria can be listed");
    }
  }

  const EquilibriumBox* system_;
  CensusLimits limits_;
  std::vector<Box> todo_;
  std::size_t boxes_ = 0, open_ = 0;
};

/// An equilibrium and the box in which it is the only one.
struct Isolated {
  CertifiedEquilibrium one;
  Box box;
};

/// The sorting of what the search found, in the chain's own units.
class Listing {
 public:
  Listing(const Chain<Interval>& chain, const EquilibriumBox& system, const Window& window)
      : chain_(&chain), system_(&system), window_(&window) {}

  void add(const CertifiedEquilibrium& one, const Box& box) {
    bool known = false, meets = false;
    for (const Isolated& other : found) {
      const std::vector<Interval> q = turned_towards(other.one.q, one.q);
      known = known || inside(q, one, other.box);
      meets = meets || touch(q, one, other.one);
    }
    if (known || certainly_outside(one.q)) return;
    if (meets)
      undecided.push_back(one.q);  // two that may be one
    else
      found.push_back({one, box});
  }

  std::vector<Isolated> found;
  std::vector<std::vector<Interval>> undecided;

 private:
  /// Joint angles, those of passive joints by full turns as close as can be to others.
  [[nodiscard]] std::vector<Interval> turned_towards(const std::vector<Interval>& others,
                                                     std::vector<Interval> q) const {
    const Interval turn = Interval(2) * Interval::pi();
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (!chain_->passive_joint(i)) continue;
      const double turns = std::round(static_cast<double>(((q[i] - others[i]) / turn).middle()));
      q[i] -= Interval::from_double(turns) * turn;
    }
    return q;
  }

  [[nodiscard]] bool inside(const std::vector<Interval>& q, const CertifiedEquilibrium& one,
                            const Box& box) const {
    Interval theta(0);
    for (std::size_t j = 0; j < q.size(); ++j) {
      theta += q[j];
      if (!Span(theta).inside(box[j])) return false;
    }
    return system_->unknowns() == q.size() ||
           (Span(one.fx).inside(box[q.size()]) && Span(one.fy).inside(box[q.size() + 1]));
  }

  static bool touch(const std::vector<Interval>& q, const CertifiedEquilibrium& one,
                    const CertifiedEquilibrium& other) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (!intersection(q[i], other.q[i])) return false;
    }
    return intersection(one.fx, other.fx) && intersection(one.fy, other.fy);
  }

  /// What lies on the edge of the window as far as fifty digits tell is listed.
  [[nodiscard]] bool certainly_outside(const std::vector<Interval>& q) const {
    for (std::size_t i = 0; i < window_->size(); ++i) {
      const Interval& range = (*window_)[i];
      if (!chain_->passive_joint(i) && (q[i].upper() < range.lower() || range.upper() < q[i].lower()))
        return true;
    }
    return false;
  }

  const Chain<Interval>* chain_;
  const EquilibriumBox* system_;
  const Window* window_;
};

/// Joint angles of a box of absolute angles.
std::vector<Interval> joint_angles_of(const Box& box, std::size_t links) {
  std::vector<Interval> q;
  for (std::size_t j = 0; j < links; ++j) {
    const Span angle = j > 0 ? box[j] - box[j - 1] : box[j];
    q.emplace_back(Interval::End(angle.low), Interval::End(angle.high));
  }
  return q;
}

/// Back from the chain's own units, passive joints within half a turn.
CertifiedEquilibrium restored(CertifiedEquilibrium one, const Chain<Interval>& chain, const Units& units) {
  const Interval pi = Interval::pi();
  for (std::size_t i = 0; i < one.q.size(); ++i) {
    if (!chain.passive_joint(i)) continue;
    if (certainly_less(pi, one.q[i])) one.q[i] -= Interval(2) * pi;
    if (certainly_less(one.q[i], -pi)) one.q[i] += Interval(2) * pi;
  }
  one.fx *= units.force(), one.fy *= units.force();
  one.x *= units.length, one.y *= units.length;
  one.energy *= units.stiffness;
  return one;
}

/// \throws Error where the count contradicts topology
bool balance(const Census& census, std::optional<long> law) {
  if (!law || !census.complete()) return false;
  long sum = 0;
  for (const CertifiedEquilibrium& one : census.equilibria) {
    if (!one.negative_directions) return false;
    sum += *one.negative_directions % 2 == 0 ? 1 : -1;
  }
  if (sum != *law) {
    throw Error("census", fmt::format("{} even less odd equilibria", sum),
                fmt::format("the Euler characteristic of the space of shapes, {}", *law));
  }
  return true;
}

Census take(const Chain<Interval>& given, Control control, const Point<Interval>& given_load,
            const Window& window, const CensusLimits& limits) {
  const Units units = own_units(given);
  const Chain<Interval> chain = in_units(given, units);
  const Point<Interval> load = in_units(given_load, control, units);
  const EquilibriumBox system(chain, control, load, window);
  Search search(system, limits);
  search.run();
  Listing listing(chain, system, window);
  for (const Box& box : search.isolated) {
    if (const auto one = enclose(chain, control, load, box))
      listing.add(*one, box);
    else
      listing.undecided.push_back(joint_angles_of(box, system.links()));
  }
  for (const Box& box : search.undecided) listing.undecided.push_back(joint_angles_of(box, system.links()));
  Census census{{}, std::move(listing.undecided), window, search.boxes(), false};
  for (const Isolated& found : listing.found) census.equilibria.push_back(restored(found.one, chain, units));
  std::sort(census.equilibria.begin(), census.equilibria.end(),
            [](const auto& a, const auto& b) { return a.energy.middle() < b.energy.middle(); });
  const long under_force = chain.passive_joints() > 0 ? 0 : 1;
  census.balanced = balance(census, control == Control::force ? under_force : index_sum(chain, load, window));
  return census;
}

}  // namespace

Census census_at_end_point(const Chain<Interval>& chain, const Point<Interval>& place, const Window& window,
                           const CensusLimits& limits) {
  return take(chain, Control::end_point, place, window.empty() ? unwound(chain) : window, limits);
}

Census census_under_force(const Chain<Interval>& chain, const Point<Interval>& force,
                          const CensusLimits& limits) {
  return take(chain, Control::force, force, {}, limits);
}

}  // namespace plumbline::proofs
