#include "verify/chains/loaded_chains.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <map>
#include <plumbline/branch/point_at_load.hpp>
#include <plumbline/branch/sharpen.hpp>
#include <plumbline/branch/slow_loading.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exactly.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {

namespace {

proofs::Located middle(const Interval& x) {
  return x.middle();
}

template <Analytic Real>
Loading<Real> inwards(const Real& reach) {
  return {Control::end_point, {reach, Real(0)}, {Real(-1), Real(0)}};
}

double rounded(const Interval& x) {
  return static_cast<double>(x.middle());
}

std::string in_words(const proofs::PathCertificate& proved) {
  std::string words =
      fmt::format("{}, proved by {} interval Newton segments: ",
                  proved.gaps.empty() ? "one smooth branch" : "smooth but for a gap", proved.segments);
  std::string_view before;
  for (const proofs::CertifiedRun& run : proved.runs) {
    words += fmt::format("{}{} from deflection {:.6g} to {:.6g}", before,
                         run.negative_directions == 0 ? "stable" : "unstable", run.from, run.to);
    before = ", then ";
  }
  for (const proofs::Span& fold : proved.folds)
    words += "; the deflection turns exactly once in " + text(fold, 12);
  for (const proofs::Span& least : proved.softest)
    words += "; the tangent stiffness has exactly one local minimum in " + text(least, 8);
  if (proved.certified() && proved.counted)
    words += proved.softens           ? "; the tangent stiffness falls all along"
             : proved.softest.empty() ? "; the tangent stiffness has no local minimum"
                                      : ", and nowhere else";
  for (const proofs::Gap& gap : proved.gaps)
    words += "; not covered, a bifurcation or nearly one: " + text(gap.loads, 8);
  if (proved.failed_at) words += "; not proved from " + text(*proved.failed_at, 8) + " on: " + proved.failure;
  if (!proved.finite) words += "; the tangent stiffness has poles";
  return words + (proved.stiff ? "; the force grows all along" : "");
}

/// States near a chord between two of them.
struct ChordOfStates {
  const Vector<double>&a, &b, &tube;  ///< theta, force, load

  /// What lies from a share of the chord to another.
  [[nodiscard]] Interval between(double from, double to, double at_a, double at_b, double off) const {
    const auto exactly = [](double x) { return Interval::from_double(x); };
    const Interval share(Interval::End{from}, Interval::End{to}),
        aside(Interval::End{-off}, Interval::End{off});
    return exactly(at_a) + share * (exactly(at_b) - exactly(at_a)) + aside;
  }

  /// Whether something holds of all states there with a load in a range; halves the chord where it is not
  /// certain.
  [[nodiscard]] bool holds(double from, double to, double first, double last,
                           const std::function<bool(const proofs::CertifiedEquilibrium&)>& asked) const {
    const Eigen::Index links = tube.size() - 3;
    const auto unknown = [&](Eigen::Index i) { return between(from, to, a(i), b(i), tube(i)); };
    const Interval load = unknown(links + 2);
    if (certainly_less(load, Interval::from_double(first)) ||
        certainly_less(Interval::from_double(last), load))
      return true;
    proofs::CertifiedEquilibrium state;
    Interval before(0);
    for (Eigen::Index i = 0; i < links; ++i) {
      const Interval theta = unknown(i);
      state.q.push_back(theta - before);
      before = theta;
    }
    state.fx = unknown(links);
    state.fy = unknown(links + 1);
    if (asked(state)) return true;
    constexpr double shortest = 1.0 / 1024;
    if (to - from < shortest) return false;
    const double middle = (from + to) / 2;
    return holds(from, middle, first, last, asked) && holds(middle, to, first, last, asked);
  }
};

/// The numbers of a chain, to tell it from others.
std::string key_of(const Chain<Interval>& chain) {
  std::string key;
  for (const auto& numbers : {chain.length(), chain.stiffness(), chain.rest()})
    for (const Interval& number : numbers) key += number.text(60) + " ";
  return key;
}

/// The chain turned so that its unloaded end point lies on the x axis; possible with a passive base.
Vector<double> unloaded_shape(const Chain<double>& chain) {
  std::vector<double> q = chain.rest();
  if (chain.passive_joint(0)) {
    const Point<double> p = end_point(chain, q);
    q[0] -= std::atan2(p.y, p.x);
  }
  return absolute_angles(q);
}

}  // namespace

HeldChain held(const Premises& given, const std::string& id) {
  return {given.chain(id), given.reach(id)};
}

HeldChain held(const Chain<Interval>& chain) {
  const Point<Interval> p = end_point(chain, chain.rest());
  return {chain, sqrt(sqr(p.x) + sqr(p.y))};
}

std::string key_of(const HeldChain& held) {
  return key_of(held.chain) + " " + held.reach.text(60);
}

const proofs::Census& HeldChain::at(const Interval& deflection) const {
  return held_at(chain, reach - deflection);
}

const SlowPath& HeldChain::compressed(double last) const {
  static std::map<std::string, SlowPath> known;
  const std::string key = fmt::format("{} {}", key_of(*this), last);
  const auto found = known.find(key);
  return found != known.end() ? found->second
                              : known.emplace(key, compress_slowly(*this, last)).first->second;
}

Matrix<Rational> bent_jacobian(std::size_t n) {
  const auto size = static_cast<Eigen::Index>(n);
  Matrix<Rational> J(2, size);
  Rational x = 0, y = 0;
  for (Eigen::Index i = size; i-- > 0;) {  // the tangent of half the link's orientation is 1 / (i + 2)
    const Rational t(1, static_cast<int>(i) + 2);
    x += (1 - t * t) / (1 + t * t);
    y += 2 * t / (1 + t * t);
    J(0, i) = -y;
    J(1, i) = x;
  }
  return J;
}

const proofs::Census& held_at(const Chain<Interval>& chain, const Interval& x) {
  static std::map<std::string, proofs::Census> known;  // many claims look at the same ones
  const std::string key = key_of(chain) + " " + x.text(60);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  proofs::Census census = proofs::census_at_end_point(chain, {x, Interval(0)});
  if (!census.complete()) throw Error("census", "undecided boxes", "a regular deflection");
  return known.emplace(key, std::move(census)).first->second;
}

PaperForce<Interval> paper_force(const proofs::CertifiedEquilibrium& one) {
  return {-one.fx, -one.fy};
}

namespace {

std::string short_decimal(const Rational& x) {
  const std::string exact = proofs::to_exact(x);
  return exact.size() <= 8 ? exact : proofs::to_decimal(x, 3);
}

}  // namespace

std::string in_lengths(const Rational& length) {
  return short_decimal(length) + " L";
}

std::string in_lengths(const std::vector<Rational>& lengths) {
  std::string text;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    text += (i == 0 ? "" : i + 1 == lengths.size() ? " and " : ", ") + short_decimal(lengths[i]);
  return text + " L";
}

std::string located(const proofs::Located& number, int digits) {
  return number.str(std::min(digits, proofs::located_digits));
}

std::string types(const proofs::Census& census) {
  Counts count;
  for (const auto& one : census.equilibria)
    count.add(one.negative_directions.value() == 0 ? "stable" : "unstable");
  return count.text();
}

std::string extrema(const proofs::Census& census, int sign_of_q4) {
  static const std::array<const char*, 3> kinds{"minimum", "saddle", "maximum"};
  Counts count;
  for (const auto& one : census.equilibria) {
    const char q4 = sign_character(sin(one.q.at(3)));
    if (q4 == '0') throw Error("census", "an open sign of q4", "a certain one");
    if (sign_of_q4 == 0 || (q4 == '+') == (sign_of_q4 > 0))
      count.add(kinds.at(one.negative_directions.value()));
  }
  return count.text();
}

std::string signs(const proofs::CertifiedEquilibrium& one, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < one.q.size(); ++i) text += sign_character(one.q[i]);
  return text;
}

std::string letter(const proofs::CertifiedEquilibrium& one) {
  const std::string bends = signs(one, 1);
  if (bends == "--") return "U⁺";
  if (bends == "++") return "U⁻";
  const char first = sign_character(one.q.front());
  if (bends.find('0') != std::string::npos || first == '0') return bends;
  return first == '-' ? "Z⁻" : "Z⁺";
}

std::vector<BranchEvent<proofs::Located>> SlowPath::of_kind(EventKind kind) const {
  std::vector<BranchEvent<proofs::Located>> found;
  for (const auto& event : events) {
    if (event.kind == kind) found.push_back(event);
  }
  return found;
}

bool SlowPath::regular() const {
  return proved.size() == 1 && proved[0].regular() && stretches[0].end == BranchEnd::load;
}

std::string SlowPath::continuity() const {
  const auto certified = [](const proofs::PathCertificate& one) { return one.certified(); };
  if (regular()) return "continuous";
  return std::all_of(proved.begin(), proved.end(), certified) ? "a jump" : "open";
}

bool SlowPath::stiff() const {
  return regular() && proved[0].stiff;
}

std::size_t SlowPath::softest() const {
  if (!regular() || !proved[0].counted)
    throw Error("path", "an open number of minima of its stiffness", "a proved one");
  return proved[0].softest.size();
}

bool SlowPath::everywhere(const Rational& from, const Rational& to,
                          const std::function<bool(const proofs::CertifiedEquilibrium&)>& holds) const {
  const auto first = from_rational<double>(from), last = from_rational<double>(to);
  for (const proofs::PathCertificate& one : proved) {
    for (const proofs::ProvedPiece& piece : one.pieces) {
      const bool covers = one.certified() && piece.runs.size() == 1 && piece.runs[0].from <= first &&
                          last <= piece.runs[0].to;
      if (!covers) continue;
      for (std::size_t i = 0; i < piece.tubes.size(); ++i) {
        // at a point two tubes meet, and the curve goes from one to the other in a box of its own
        const Vector<double> tube = piece.tubes[i].array() + piece.distance;
        const ChordOfStates chord{piece.points[i], piece.points[i + 1], tube};
        if (!chord.holds(0, 1, first, last, holds)) return false;
      }
      return true;
    }
  }
  return false;
}

Evidence SlowPath::evidence() const {
  std::string text;
  for (const proofs::PathCertificate& one : proved)
    text += (text.empty() ? "" : "; and after it ") + in_words(one);
  return {EvidenceKind::interval, text};
}

BranchPoint<proofs::Located> SlowPath::at(const Rational& deflection) const {
  using Model = NominalModel<double>;
  const Model model(convert<double>(enclosed, rounded));
  Brancher<Model> brancher(model, inwards(rounded(reach)), unloaded_shape(model.chain()));
  const auto near = state_at_load(brancher, stretches, from_rational<double>(deflection));
  if (!near) throw Error("path", "no state at deflection " + deflection.str(), "one that it reaches");
  return proofs::locate_at(chain, loading, *near, from_rational<proofs::Located>(deflection));
}

SlowPath compress_slowly(const HeldChain& held, double last, int side) {
  using Model = NominalModel<double>;
  const auto& [chain, reach] = held;
  const Model model(convert<double>(chain, rounded));
  const Vector<double> shape = unloaded_shape(model.chain());
  Brancher<Model> brancher(model, inwards(rounded(reach)), shape);
  SlowPath path{chain, reach, convert<proofs::Located>(chain, middle), inwards(middle(reach)), {}, {}, {}};
  path.stretches = load_slowly(brancher, brancher.start(0, shape), {0, last}, side);
  for (const Branch<double>& stretch : path.stretches) {
    for (auto& event : proofs::locate_events(path.chain, path.loading, stretch))
      path.events.push_back(std::move(event));
    path.proved.push_back(proofs::certify(chain, inwards(reach), stretch));
  }
  return path;
}

proofs::CertifiedEquilibrium reached(const proofs::Census& census, const SlowPath& path,
                                     const Rational& deflection) {
  const std::vector<proofs::Located> q = joint_angles(path.at(deflection).theta);
  for (const proofs::CertifiedEquilibrium& one : census.equilibria) {
    bool same = true;
    for (std::size_t i = 0; i < q.size() && same; ++i)
      same = abs(one.q[i].middle() - q[i]) < proofs::Located("1e-20");
    if (same) return one;
  }
  throw Error("census", "no equilibrium of the path", "every state that the chain can have");
}

std::vector<proofs::CertifiedEquilibrium> states(const SlowPath& path,
                                                 const std::vector<Rational>& deflections) {
  std::vector<proofs::CertifiedEquilibrium> found;
  found.reserve(deflections.size());
  for (const Rational& d : deflections)
    found.push_back(reached(held_at(path.enclosed, path.reach - Interval(d)), path, d));
  return found;
}

std::vector<Interval> mean_stiffnesses(const SlowPath& path, const std::vector<Rational>& deflections) {
  const std::vector<proofs::CertifiedEquilibrium> at = states(path, deflections);
  std::vector<Interval> slopes;
  for (std::size_t i = 1; i < at.size(); ++i)
    slopes.push_back((at[i - 1].fx - at[i].fx) / Interval(deflections[i] - deflections[i - 1]));
  return slopes;
}

proofs::Located straightens_at(const SlowPath& path, std::size_t joint, const Rational& from,
                               const Rational& to) {
  static std::map<std::string, proofs::Located> known;
  const std::string key =
      fmt::format("{} {} {} {}", key_of(HeldChain{path.enclosed, path.reach}), joint, from.str(), to.str());
  if (const auto found = known.find(key); found != known.end()) return found->second;
  const auto angle = [&](const proofs::Located& load) {
    return joint_angles(path.at(proofs::exactly(load)).theta)[joint];
  };
  const auto low = from_rational<proofs::Located>(from), high = from_rational<proofs::Located>(to);
  if (angle(low) * angle(high) > 0)
    throw Error("path",
                fmt::format("no change of sign of joint angle {} between the deflections {} and {}",
                            joint + 1, low.str(6), high.str(6)),
                "one");
  std::uintmax_t evaluations = 100;
  const auto close = [](const proofs::Located& a, const proofs::Located& b) {
    return abs(b - a) < proofs::Located("1e-58");
  };
  const auto [a, b] = boost::math::tools::toms748_solve(angle, low, high, close, evaluations);
  return known.emplace(key, (a + b) / 2).first->second;
}

Branch<double> branch_through(const HeldChain& held, const proofs::CertifiedEquilibrium& one,
                              double deflection, int direction, const TraceLimits<double>& limits) {
  using Model = NominalModel<double>;
  const auto& [chain, reach] = held;
  const Model model(convert<double>(chain, rounded));
  Brancher<Model> brancher(model, inwards(rounded(reach)), absolute_angles(model.chain().rest()));
  std::vector<double> q;
  for (const Interval& angle : one.q) q.push_back(rounded(angle));
  auto start = brancher.start(deflection, absolute_angles(q), {rounded(one.fx), rounded(one.fy)});
  if (start.tangent.load * direction < 0) Brancher<Model>::scale(start.tangent, -1);
  return Tracer<Model>(brancher, limits).run(start);
}

std::vector<proofs::PathCertificate> leaving(const SlowPath& path,
                                             const BranchEvent<proofs::Located>& bifurcation, double to) {
  using Model = NominalModel<double>;
  constexpr double next_to = 1e-5;  // root mean square turn of the links
  const Model model(convert<double>(path.enclosed, rounded));
  Brancher<Model> brancher(model, inwards(rounded(path.reach)), absolute_angles(model.chain().rest()));
  BranchPoint<double> at = lift<double>(bifurcation.point);
  at.tangent = lift<double>(bifurcation.crossing);
  std::vector<proofs::PathCertificate> sides;
  for (const int side : {1, -1}) {
    auto off = brancher.step(at, side * next_to);
    if (!off) throw Error("bifurcation", "a side that is not found", "two sides of the branch that crosses");
    if (off->tangent.load < 0) Brancher<Model>::scale(off->tangent, -1);
    const Branch<double> branch = Tracer<Model>(brancher, {0, to}).run(*off);
    sides.push_back(proofs::certify(path.enclosed, inwards(path.reach), branch));
  }
  return sides;
}

}  // namespace plumbline::verify
