#include "diagnose/design/fewest_runs.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace plumbline::diagnose {
namespace {

using Runs = std::vector<std::size_t>;

/// Decides whether sets of runs suffice. The contrasts that refuted the last sets are tried first.
class Sufficiency {
 public:
  Sufficiency(const std::vector<Contrast>& contrasts, double enough)
      : contrasts_(contrasts), enough_(enough), order_(contrasts.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
  }

  [[nodiscard]] std::size_t asked() const { return asked_; }

  bool of(const Runs& runs) {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      ++asked_;
      if (expected_log_likelihood_ratio(contrasts_[order_[i]], runs) > enough_) continue;
      std::rotate(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(i),
                  order_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      return false;
    }
    return true;
  }

 private:
  const std::vector<Contrast>& contrasts_;
  double enough_;
  Runs order_;
  std::size_t asked_ = 0;
};

Runs with(Runs runs, std::size_t one) {
  runs.push_back(one);
  return runs;
}

Runs all_of(std::size_t count) {
  Runs runs(count);
  std::iota(runs.begin(), runs.end(), std::size_t{0});
  return runs;
}

/// Adds runs in the order of their contribution, until all contrasts suffice or the set has its largest size.
Runs greedy(const std::vector<Contrast>& contrasts, const Runs& from, double enough, std::size_t most) {
  Runs chosen;
  std::vector<const Contrast*> open;
  for (const Contrast& one : contrasts) open.push_back(&one);
  while (!open.empty() && chosen.size() < most) {
    std::optional<std::size_t> best;
    double farthest = -1;
    for (const std::size_t run : from) {
      if (std::find(chosen.begin(), chosen.end(), run) != chosen.end()) continue;
      const Runs more = with(chosen, run);
      double way = 0;
      for (const Contrast* one : open)
        way += std::min(1.0, expected_log_likelihood_ratio(*one, more) / enough);
      if (way <= farthest) continue;
      farthest = way;
      best = run;
    }
    chosen.push_back(*best);
    std::erase_if(open,
                  [&](const Contrast* one) { return expected_log_likelihood_ratio(*one, chosen) > enough; });
  }
  return chosen;
}

/// Removes runs that later ones made superfluous.
Runs pruned(Runs runs, Sufficiency& sufficient) {
  for (std::size_t i = 0; i < runs.size();) {
    Runs fewer = runs;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!fewer.empty() && sufficient.of(fewer)) {
      runs = std::move(fewer);
    } else {
      ++i;
    }
  }
  return runs;
}

/// The next set of the same size, in lexicographic order.
/// \returns false after the last
bool next_set(Runs& runs, std::size_t count) {
  for (std::size_t i = runs.size(); i-- > 0;) {
    if (runs[i] == count - runs.size() + i) continue;
    ++runs[i];
    for (std::size_t j = i + 1; j < runs.size(); ++j) runs[j] = runs[j - 1] + 1;
    return true;
  }
  return false;
}

/// A sufficient set with one run fewer; nothing where there is none, or the limit of work is reached.
std::optional<Runs> one_fewer(const Runs& found, std::size_t count, Sufficiency& sufficient,
                              std::size_t patience) {
  if (found.size() < 2) return std::nullopt;
  Runs runs = all_of(found.size() - 1);
  do {
    if (sufficient.asked() > patience) return std::nullopt;
    if (sufficient.of(runs)) return runs;
  } while (next_set(runs, count));
  return std::nullopt;
}

}  // namespace

double expected_log_likelihood_ratio(const Contrast& contrast, const std::vector<std::size_t>& runs) {
  if (runs.empty()) return 0;
  Eigen::Index count = 0;
  for (const std::size_t run : runs) count += contrast[run].difference.size();
  LinearisedAlternative all{Eigen::VectorXd(count), Eigen::MatrixXd(count, contrast.front().slope.cols())};
  Eigen::Index next = 0;
  for (const std::size_t run : runs) {
    const Eigen::Index rows = contrast[run].difference.size();
    all.difference.segment(next, rows) = contrast[run].difference;
    all.slope.middleRows(next, rows) = contrast[run].slope;
    next += rows;
  }
  return separation(all) / 2;
}

bool few_suffice(const std::vector<Contrast>& contrasts, std::size_t count, double enough, std::size_t few) {
  return Sufficiency(contrasts, enough).of(greedy(contrasts, all_of(count), enough, std::min(few, count)));
}

FewestRuns fewest_runs(const std::vector<Contrast>& contrasts, std::size_t count, double enough) {
  Sufficiency sufficient(contrasts, enough);
  if (contrasts.empty()) return {{}, true};
  Runs found = pruned(greedy(contrasts, all_of(count), enough, count), sufficient);
  constexpr std::size_t patience = 200'000;  // contrasts evaluated, some microseconds each
  std::optional<Runs> fewer;
  do {
    fewer = one_fewer(found, count, sufficient, patience);
    if (fewer) found = *fewer;
  } while (fewer);
  return {greedy(contrasts, found, enough, found.size()), sufficient.asked() <= patience};
}

}  // namespace plumbline::diagnose
