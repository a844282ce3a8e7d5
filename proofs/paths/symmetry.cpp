#include "proofs/paths/symmetry.hpp"

namespace plumbline::proofs {

namespace {

/// Whether the chain read from its end point is the same; joint i then takes the place of joint n + 2 - i.
/// \param sign  of the rest angles there
bool reads_the_same(const Chain<Rational>& chain, int sign) {
  const std::size_t n = chain.size();
  if (!chain.passive_joint(0)) return false;
  for (std::size_t i = 1; i < n; ++i) {  // of the links, the last with the first too
    if (chain.length()[i] != chain.length()[n - 1 - i]) return false;
    if (chain.stiffness()[i] != chain.stiffness()[n - i]) return false;
    if (chain.rest()[i] != sign * chain.rest()[n - i]) return false;
  }
  return true;
}

}  // namespace

std::vector<Symmetry> symmetries(const Chain<Rational>& chain, Control control,
                                 const Point<Rational>& direction) {
  std::vector<Symmetry> found;
  const auto& rest = chain.rest();
  const bool axial = direction.y == 0;
  const bool straight =
      std::all_of(rest.begin(), rest.end(), [](const Rational& angle) { return angle == 0; });
  if (axial && straight) found.push_back({false, true});
  if (control == Control::force) return found;  // what follows needs the end point where it is held
  if (reads_the_same(chain, -1)) found.push_back({true, false});
  if (axial && straight && reads_the_same(chain, 1)) found.push_back({true, true});
  return found;
}

}  // namespace plumbline::proofs
