#include "proofs/census/structure_census.hpp"

#include <algorithm>

#include "proofs/census/structure_box.hpp"

namespace plumbline::proofs {
namespace {

constexpr std::size_t boxes_at_most = 4000000, most_undecided = 1000;
constexpr double smallest = 1e-7;
constexpr double most_turn = 3.1415926535897936;  // above pi: what the largest force can turn a link
constexpr double uneven = 0.4876543;              // where a box is halved: no symmetric shape lies there

/// Two parts of a box along its widest side; the force counts as the turn that it can make.
std::pair<Ranges, Ranges> halved(const Ranges& box, const StructureBox& system) {
  std::size_t widest = 0;
  double most = -1;
  for (std::size_t j = 0; j < box.size(); ++j) {
    const double unit = j < system.turning() ? 1 : most_turn / system.largest_force();
    if (box[j].width() * unit > most) most = box[j].width() * unit, widest = j;
  }
  Ranges low = box, high = box;
  const double at = box[widest].low + uneven * box[widest].width();
  low[widest].high = high[widest].low = at;
  return {std::move(low), std::move(high)};
}

double widest_of(const Ranges& box, std::size_t turning) {
  double widest = 0;
  for (std::size_t j = 0; j < turning; ++j) widest = std::max(widest, box[j].width());
  return widest;
}

bool overlap(const Ranges& a, const Ranges& b) {
  for (std::size_t j = 0; j < a.size(); ++j) {
    if (intersection(a[j], b[j]).empty()) return false;
  }
  return true;
}

/// Adds a box around an equilibrium; those on the border between two boxes are found in both, and those half
/// a turn off at a passive joint to either side.
/// \returns false where it is open whether it is a new one
bool add(std::vector<Ranges>& found, const Ranges& box, const StructureBox& system) {
  for (const Ranges& other : found) {
    const Ranges same = system.unwound(box, other);
    if (overlap(other, same)) return system.around_one(other, same);
  }
  found.push_back(box);
  return true;
}

}  // namespace

StructureCensus take_census(const Structure<Rational>& structure, const Rational& factor, int turns) {
  const StructureBox system(structure, factor, turns);
  StructureCensus census{{}, {}, system.widest_turn(), system.largest_force(), 0};
  std::vector<Ranges> open{system.everything()}, found;
  while (!open.empty()) {
    if (++census.boxes > boxes_at_most)
      throw Error("census", "no end after " + std::to_string(boxes_at_most) + " boxes",
                  "fewer links, or a smaller load");
    Ranges box = std::move(open.back());
    open.pop_back();
    if (!system.contract(box)) continue;
    const bool small = widest_of(box, system.turning()) < smallest;
    Ranges one = small ? system.widened(box, box) : box;
    if (system.isolates(one)) {
      if (system.counted(one) && !add(found, one, system))
        census.undecided.push_back(system.angles(system.directions(one)));
      continue;
    }
    if (small) {
      census.undecided.push_back(system.angles(system.directions(box)));
      if (census.undecided.size() > most_undecided)
        throw Error("census", "more than " + std::to_string(most_undecided) + " boxes that stay undecided",
                    "isolated equilibria");
      continue;
    }
    auto [low, high] = halved(box, system);
    open.push_back(std::move(low));
    open.push_back(std::move(high));
  }
  for (const Ranges& box : found) census.equilibria.push_back(system.described(box));
  std::stable_sort(census.equilibria.begin(), census.equilibria.end(),
                   [](const auto& a, const auto& b) { return a.energy.middle() < b.energy.middle(); });
  return census;
}

}  // namespace plumbline::proofs
