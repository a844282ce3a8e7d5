#include "diagnose/inference/elements.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// Parameters of one element: its strength first, last where or when it acts.
using Element = std::vector<double>;

std::vector<Element> in_order(const double* parameters, std::size_t count, std::size_t size) {
  std::vector<Element> elements;
  for (std::size_t e = 0; e < count; ++e)
    elements.emplace_back(parameters + e * size, parameters + (e + 1) * size);
  std::sort(elements.begin(), elements.end(),
            [](const Element& a, const Element& b) { return a.back() < b.back(); });
  return elements;
}

/// As strong as the two together, in their middle.
Element made_one(const Element& a, const Element& b) {
  const double strength = a.front() + b.front();
  const double share = strength > 0 ? b.front() / strength : 0.5;
  Element both = a;
  both.front() = strength;
  both.back() += share * (b.back() - a.back());
  return both;
}

std::vector<std::vector<Element>> one_fewer(const std::vector<Element>& elements) {
  std::vector<std::vector<Element>> ways;
  for (std::size_t e = 0; e + 1 < elements.size(); ++e) {
    ways.push_back(elements);
    ways.back()[e] = made_one(elements[e], elements[e + 1]);
    ways.back().erase(ways.back().begin() + static_cast<std::ptrdiff_t>(e) + 1);
  }
  return ways;
}

/// A weak one more, halfway between its neighbours; five eighths as far as the first of them, half as far
/// again as the last.
std::vector<std::vector<Element>> one_born(const std::vector<Element>& elements, double weak) {
  std::vector<std::vector<Element>> ways;
  for (std::size_t e = 0; e <= elements.size(); ++e) {
    const double after = e < elements.size() ? elements[e].back() : 2 * elements.back().back(),
                 before = e > 0 ? elements[e - 1].back() : elements.front().back() / 4;
    Element added = elements.front();
    added.front() = weak;
    added.back() = (before + after) / 2;
    ways.push_back(elements);
    ways.back().insert(ways.back().begin() + static_cast<std::ptrdiff_t>(e), added);
  }
  return ways;
}

/// One made two of half its strength each, on either side of it: what made_one() would make it of.
std::vector<std::vector<Element>> one_split(const std::vector<Element>& elements) {
  constexpr double apart = 0.4;
  std::vector<std::vector<Element>> ways;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    ways.push_back(elements);
    Element& first = ways.back()[e];
    first.front() /= 2;
    Element second = first;
    first.back() *= 1 - apart;
    second.back() *= 1 + apart;
    ways.back().insert(ways.back().begin() + static_cast<std::ptrdiff_t>(e) + 1, second);
  }
  return ways;
}

std::vector<std::vector<Element>> one_more(const std::vector<Element>& elements, double weak) {
  std::vector<std::vector<Element>> ways = one_born(elements, weak);
  const std::vector<std::vector<Element>> split = one_split(elements);
  ways.insert(ways.end(), split.begin(), split.end());
  return ways;
}

}  // namespace

InitialGuesses initial_guesses_of_order(const Study& study, const Hypothesis& fitted, std::size_t effect,
                                        const Effect& row) {
  const std::vector<EffectAt>& effects = fitted.candidate.effects;
  const std::vector<ParameterRange> own = study.ranges(effects[effect]),
                                    ranges = study.ranges(EffectAt(row, effects[effect].joint));
  if (ranges.size() + row.element_size != own.size() && own.size() + row.element_size != ranges.size())
    return {{}, 0};
  std::size_t first = 0;
  for (std::size_t e = 0; e < effect; ++e) first += study.ranges(effects[e]).size();
  const auto begin = fitted.parameters.begin() + static_cast<std::ptrdiff_t>(first),
             end = begin + static_cast<std::ptrdiff_t>(own.size());
  const std::vector<Element> elements =
      in_order(fitted.parameters.data() + first, own.size() / row.element_size, row.element_size);
  constexpr double weak = 0.25;  // of a sizeable effect
  InitialGuesses guesses{{}, 2};
  for (const std::vector<Element>& way :
       ranges.size() < own.size() ? one_fewer(elements) : one_more(elements, weak * ranges[0].scale)) {
    std::vector<double> start(fitted.parameters.begin(), begin);
    for (const Element& element : way)
      for (const double value : element) start.push_back(value);
    for (std::size_t p = 0; p < ranges.size(); ++p)
      start[first + p] = std::clamp(start[first + p], ranges[p].low, ranges[p].high);
    start.insert(start.end(), end, fitted.parameters.end());
    guesses.points.push_back(std::move(start));
  }
  return guesses;
}

}  // namespace plumbline::diagnose
