#include "proofs/census/covering.hpp"

#include <numbers>

namespace plumbline::proofs {

namespace {

constexpr std::size_t most_boxes = 1000000;
constexpr double narrowest = 1e-9;

class Coverer {
 public:
  Coverer(const EquilibriumBox& system, const std::vector<Box>& balls) : system_(&system), balls_(&balls) {}

  void cover(const Box& box) {
    if (tree.size() > 2 * most_boxes)
      throw Error("certificate", "more than a million boxes", "a census that fewer boxes prove");
    Box left = box;
    if (system_->held()) left[system_->links()] = left[system_->links() + 1] = Span::everything();
    if (!system_->narrow(left) || known(left)) {
      tree += '.';
      return;
    }
    const std::size_t j = system_->widest(left);
    if (box[j].width() < narrowest)
      throw Error("certificate", "a place that stays open", "equilibria that are isolated");
    tree += static_cast<char>('a' + j);
    Box half = box;
    half[j].high = box[j].middle();
    cover(half);
    half[j] = {half[j].high, box[j].high};
    cover(half);
  }

  std::string tree;

 private:
  [[nodiscard]] bool known(const Box& z) const {
    return std::any_of(balls_->begin(), balls_->end(), [&](const Box& ball) { return within(z, ball); });
  }

  /// Passive joints are turned to where the ball is.
  [[nodiscard]] bool within(const Box& z, const Box& ball) const {
    const auto joint = [](const Box& at, std::size_t i) {
      return at[i].middle() - (i > 0 ? at[i - 1].middle() : 0);
    };
    Span shift(0);
    for (std::size_t i = 0; i < system_->unknowns(); ++i) {
      if (i < system_->links() && system_->passive(i)) {
        const double turns = std::round((joint(z, i) - joint(ball, i)) / (2 * std::numbers::pi));
        shift -= turns * Span(2 * std::numbers::pi, Span::up(2 * std::numbers::pi));
      }
      if (!(i < system_->links() ? z[i] + shift : z[i]).inside(ball[i])) return false;
    }
    return true;
  }

  const EquilibriumBox* system_;
  const std::vector<Box>* balls_;
};

}  // namespace

std::string covering(const EquilibriumBox& system, const std::vector<Box>& balls) {
  Coverer coverer(system, balls);
  coverer.cover(system.everything());
  return std::move(coverer.tree);
}

}  // namespace plumbline::proofs
