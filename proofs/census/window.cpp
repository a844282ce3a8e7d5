#include "proofs/census/window.hpp"

#include <cmath>
#include <functional>

namespace plumbline::proofs {

namespace {

Interval distance(const Interval& x, const Interval& y) {
  return sqrt(sqr(x) + sqr(y));
}

/// Whether free links certainly cannot span a distance.
bool out_of_reach(const std::vector<Interval>& links, const Interval& span) {
  Interval sum(0);
  for (const Interval& link : links) sum += link;
  if (certainly_less(sum, span)) return true;
  return std::any_of(links.begin(), links.end(), [&](const Interval& longest) {
    return certainly_less(span, longest - (sum - longest));
  });
}

/// Whether no shape with a joint at this angle, or so near that a census may not tell, has this end point.
bool unreachable(const Chain<Interval>& chain, const Point<Interval>& place, std::size_t joint,
                 const Interval::End& angle) {
  const Interval::End near("1e-9");
  const Interval around(angle - near, angle + near);
  std::vector<Interval> links = chain.length();
  const Interval c = cos(around), s = sin(around), moved = links[joint];
  links.erase(links.begin() + static_cast<std::ptrdiff_t>(joint));
  if (joint == 0) return out_of_reach(links, distance(place.x - moved * c, place.y - moved * s));
  Interval& merged = links[joint - 1];
  merged = distance(merged + moved * c, moved * s);
  return out_of_reach(links, distance(place.x, place.y));
}

Interval whole(double number) {
  return Interval::from_double(number);
}

}  // namespace

Window unwound(const Chain<Interval>& chain, int turns) {
  const Interval pi = Interval::pi(), half = pi * Interval(2 * turns + 1);
  Window window;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    Interval centre(0);
    if (!chain.passive_joint(i)) {
      const Interval& rest = chain.rest()[i];
      centre = i == 0 ? rest : pi * whole(std::round(static_cast<double>((rest / pi).middle())));
    }
    window.push_back(hull(centre - half, centre + half));
  }
  return window;
}

long euler_characteristic_of_polygons(std::vector<double> sides) {
  std::sort(sides.begin(), sides.end(), std::greater<>());
  if (sides.size() < 3) return 0;
  const std::size_t count = sides.size(), dimension = count - 3;
  std::vector<long> a(dimension + 1, 0);
  for (std::size_t subset = 1; subset < (std::size_t{1} << count); subset += 2) {  // contains the longest
    double difference = 0;
    std::size_t members = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const bool in = ((subset >> i) & 1U) != 0;
      difference += in ? sides[i] : -sides[i];
      members += in ? 1 : 0;
    }
    if (difference < 0 && members - 1 <= dimension) ++a[members - 1];
  }
  long sum = 0;
  for (std::size_t k = 0; k <= dimension; ++k) sum += (k % 2 == 0 ? 1 : -1) * (a[k] + a[dimension - k]);
  return sum;
}

std::optional<long> index_sum(const Chain<Interval>& chain, const Point<Interval>& place,
                              const Window& window) {
  const Interval turn = Interval(2) * Interval::pi();
  long copies = 1;
  std::vector<double> sides{static_cast<double>(distance(place.x, place.y).middle())};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    sides.push_back(static_cast<double>(chain.length()[i].middle()));
    if (chain.passive_joint(i)) continue;
    const Interval::End low = window[i].lower(), high = window[i].upper();
    const Interval width = Interval(high, high) - Interval(low, low);
    const double turns = std::round(static_cast<double>((width / turn).middle()));
    if (!(abs((width - turn * whole(turns)).middle()) < Interval::End("1e-30"))) return std::nullopt;
    if (!unreachable(chain, place, i, low) || !unreachable(chain, place, i, high)) return std::nullopt;
    copies *= static_cast<long>(turns);
  }
  return copies * euler_characteristic_of_polygons(std::move(sides));
}

}  // namespace plumbline::proofs
