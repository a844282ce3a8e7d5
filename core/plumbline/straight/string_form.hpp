#pragma once
/// \file
/// Which straight structures have a string with beads (bead_string.hpp), and which one: all their critical
/// factors then come to high relative accuracy for any grading, each in O(n).

#include <optional>
#include <plumbline/straight/straight_chain.hpp>
#include <plumbline/structure/structure.hpp>

namespace plumbline {

/// A structure's string: that of a straight chain whose critical forces are the structure's critical factors.
template <Number Real>
struct StringForm {
  Chain<Real> chain;   ///< of the string
  EndPoint end_point;  ///< of that chain
  std::size_t first;   ///< joint of the structure, from 0, that joint 1 of the chain is
  std::size_t joints;  ///< joints of the chain that are joints of the structure; the others do not turn

  /// A view of this form, which has to outlive it.
  [[nodiscard]] StraightChain<Real> straight() const { return {chain, end_point}; }
};

namespace detail {

template <Ordered Real>
StringForm<Real> guided_form(const Structure<Real>& structure, const Real& compression, std::size_t first) {
  const auto from = static_cast<std::ptrdiff_t>(first);
  const Chain<Real>& chain = structure.chain;
  std::vector<Real> stiffness(chain.stiffness().begin() + from, chain.stiffness().end());
  for (Real& k : stiffness) k /= compression;
  return {Chain<Real>({chain.length().begin() + from, chain.length().end()}, std::move(stiffness)),
          EndPoint::guided, first, chain.size() - first};
}

template <Ordered Real>
StringForm<Real> free_form(const Structure<Real>& structure, const std::vector<Real>& compression,
                           std::size_t first, std::size_t loaded) {
  const Chain<Real>& chain = structure.chain;
  const Restraint<Real>& turn = structure.end_point.turn;
  const std::size_t beads = turn.is_held() ? chain.size() - 1 : loaded;
  std::vector<Real> pushed, stiffness;
  for (std::size_t i = first; i < beads; ++i) {
    pushed.push_back(compression[i] * chain.length()[i]);
    stiffness.push_back(chain.stiffness()[i]);
  }
  pushed.push_back(Real(1));
  stiffness.push_back(turn.is_held() ? chain.stiffness().back() : turn.stiffness);
  const std::size_t joints = beads - first + (turn.is_held() ? 1 : 0);
  return {Chain<Real>(std::move(pushed), std::move(stiffness)), EndPoint::free, first, joints};
}

}  // namespace detail

/// The string of a structure; nothing where it has none: where springs hold it across, where loads are fixed,
/// where a link is pulled, and where the end point is guided under a compression that varies along the chain
/// or against a spring that turns. \throws Error as compression() does
template <Ordered Real>
std::optional<StringForm<Real>> string_form(const Structure<Real>& structure) {
  const std::size_t n = structure.chain.size();
  const auto is_zero = [](const Real& x) { return x == Real(0); };
  const bool on_joints = std::any_of(structure.across.begin(), structure.across.end(),
                                     [](const Restraint<Real>& r) { return !r.is_free(); });
  if (structure.follower() || on_joints || !structure.base.across.is_held() || structure.base.along.is_free())
    return std::nullopt;
  const auto [fixed, N] = compression(structure);
  if (!std::all_of(fixed.begin(), fixed.end(), is_zero)) return std::nullopt;
  const std::size_t first = structure.base.turn.is_held() ? 1 : 0;
  const Support<Real>& end = structure.end_point;
  if (end.across.is_held()) {
    const bool even =
        N[0] > Real(0) && std::all_of(N.begin(), N.end(), [&](const Real& x) { return x == N[0]; });
    if (!even || !end.turn.is_free() || n < first + 2) return std::nullopt;
    return detail::guided_form(structure, N[0], first);
  }
  if (!end.across.is_free()) return std::nullopt;
  const auto pushed = static_cast<std::size_t>(
      std::find_if(N.begin(), N.end(), [](const Real& x) { return !(x > Real(0)); }) - N.begin());
  const bool rest_unloaded = std::all_of(N.begin() + static_cast<std::ptrdiff_t>(pushed), N.end(), is_zero);
  const bool all_loaded = pushed == n;
  if (!rest_unloaded || (!all_loaded && !end.turn.is_free())) return std::nullopt;
  for (std::size_t i = pushed; i < n; ++i) {
    if (structure.chain.passive_joint(i)) return std::nullopt;  // what lies beyond turns freely
  }
  const std::size_t beads = end.turn.is_held() ? n - 1 : pushed;
  if (beads < first + 1) return std::nullopt;
  auto form = detail::free_form(structure, N, first, pushed);
  if (form.chain.passive_joints() > 1) return std::nullopt;
  return form;
}

}  // namespace plumbline
