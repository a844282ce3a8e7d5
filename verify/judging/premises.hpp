#pragma once
/// \file
/// What is given where a claim is made: chains, angles, deflections, and what a word is taken to mean.

#include <map>
#include <plumbline/base/interval.hpp>
#include <plumbline/chain/chain.hpp>
#include <string>
#include <vector>

namespace plumbline::statement {
struct PlaneChain;
}

namespace plumbline::verify {

/// What the paper prints, as text that a check can read: formulas, decimals, counts, words.
using Printed = std::vector<std::string>;

struct Premise {
  std::string id;
  std::string where;  ///< place in the paper; empty where the judge takes it so
  std::string quote;  ///< the paper's own words, or in ours what is taken
  /// "length", "stiffness" and "rest" of a chain, "end" where its end point stands without load; "chain", a
  /// chain file; "value" of anything else. Each number as `number` reads it.
  std::map<std::string, Printed> parts;
};

/// The premises of one claim.
class Premises {
 public:
  Premises() = default;
  explicit Premises(std::vector<Premise> list) : list_(std::move(list)) {}

  [[nodiscard]] const std::vector<Premise>& list() const { return list_; }
  /// \throws Error where the claim has no such premise
  [[nodiscard]] const Premise& at(const std::string& id) const;

  /// The chain that a chain file states. \throws Error where the premise has none
  [[nodiscard]] statement::PlaneChain stated(const std::string& id) const;
  /// Whether that has ends, supports, loads or masses of its own.
  [[nodiscard]] bool has_structure(const std::string& id) const;
  /// A chain by its lists, its end point guided; of a chain file that says nothing of ends and loads its own.
  /// \throws Error for a chain file with other ends, supports, loads or masses
  [[nodiscard]] Premise guided(const std::string& id) const;
  [[nodiscard]] Chain<Interval> chain(const std::string& id) const;
  /// \throws Error where an entry is no fraction
  [[nodiscard]] Chain<Rational> exact_chain(const std::string& id) const;
  /// Distance of the chain's unloaded end point from the base: as stated, else by its rest angles.
  [[nodiscard]] Interval reach(const std::string& id) const;
  [[nodiscard]] Interval value(const std::string& id) const;
  [[nodiscard]] Rational exact(const std::string& id) const;

 private:
  std::vector<Premise> list_;
};

}  // namespace plumbline::verify
