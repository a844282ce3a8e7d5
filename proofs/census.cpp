#include "proofs/census.hpp"

#include "proofs/equilibrium_box.hpp"
#include "proofs/equilibrium_enclosure.hpp"

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
  static constexpr double newton_pays = 2, isolation_pays = 0.5;  // widths, in radians

  void see(Box z) {
    if (!system_->contract(z) || known(z)) return;
    const double width = widest(z);
    if (width < newton_pays) {
      if (!system_->newton(z) || known(z)) return;
      if (widest(z) < isolation_pays) {
        isolate(z);
        if (known(z)) return;
      }
      if (widest(z) < 0.7 * width) {
        todo_.push_back(z);
        return;
      }
    }
    if (widest(z) < limits_.smallest)
      give_up(z);
    else
      halve(z);
  }

  [[nodiscard]] double widest(const Box& z) const { return system_->width(z, system_->widest(z)); }

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
  }

  const EquilibriumBox* system_;
  CensusLimits limits_;
  std::vector<Box> todo_;
  std::size_t boxes_ = 0;
};

/// Whether joint angles lie in the range counted: certainly, certainly not, or on its edge.
enum class Place { inside, outside, edge };

Place place_of(const CertifiedEquilibrium& one, const EquilibriumBox& system) {
  Place place = Place::inside;
  for (std::size_t i = 0; i < one.q.size(); ++i) {
    const Span q(one.q[i]);
    const Span& range = system.range(i);
    if (q.high < range.low || q.low > range.high) return Place::outside;
    if (!q.inside(range)) place = Place::edge;
  }
  return place;
}

/// Isolating boxes can overlap; two that hold the same root have enclosures that meet inside both.
bool same(const CertifiedEquilibrium& a, const CertifiedEquilibrium& b) {
  for (std::size_t i = 0; i < a.q.size(); ++i) {
    if (!intersection(a.q[i], b.q[i])) return false;
  }
  return true;
}

Census take(const Chain<Interval>& chain, Control control, const Point<Interval>& load,
            const CensusLimits& limits) {
  const EquilibriumBox system(chain, control, load);
  Search search(system, limits);
  search.run();
  Census census;
  census.boxes = search.boxes();
  for (const Box& box : search.isolated) {
    const CertifiedEquilibrium one = enclose(chain, control, load, box);
    const auto twin = [&](const CertifiedEquilibrium& other) { return same(one, other); };
    if (std::any_of(census.equilibria.begin(), census.equilibria.end(), twin)) continue;
    const Place place = place_of(one, system);
    if (place == Place::inside) census.equilibria.push_back(one);
    if (place == Place::edge) census.undecided.push_back(one.q);
  }
  for (const Box& box : search.undecided) {
    std::vector<Interval> q;
    for (std::size_t j = 0; j < system.links(); ++j) {
      const Span angle = j > 0 ? box[j] - box[j - 1] : box[j];
      q.emplace_back(Interval::End(angle.low), Interval::End(angle.high));
    }
    census.undecided.push_back(std::move(q));
  }
  std::sort(census.equilibria.begin(), census.equilibria.end(),
            [](const auto& a, const auto& b) { return a.energy.middle() < b.energy.middle(); });
  return census;
}

}  // namespace

Census census_at_end_point(const Chain<Interval>& chain, const Point<Interval>& place,
                           const CensusLimits& limits) {
  return take(chain, Control::end_point, place, limits);
}

Census census_under_force(const Chain<Interval>& chain, const Point<Interval>& force,
                          const CensusLimits& limits) {
  return take(chain, Control::force, force, limits);
}

}  // namespace plumbline::proofs
