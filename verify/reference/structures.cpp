#include "verify/reference/structures.hpp"

#include <fmt/format.h>

#include <plumbline/structure/beam.hpp>

#include "proofs/certificates/structure_certificate.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_list.hpp"
#include "statement/stated.hpp"
#include "verify/reference/draw.hpp"
#include "verify/reference/set.hpp"

namespace plumbline::verify {
namespace {

using nlohmann::json;

Chain<Rational> unit_chain(std::size_t n, bool pinned) {
  std::vector<Rational> stiffness(n, Rational(1));
  if (pinned) stiffness[0] = 0;
  return Chain<Rational>(std::vector<Rational>(n, Rational(1)), std::move(stiffness));
}

Support<Rational> end_of(const std::string& ends) {
  if (ends.ends_with("free")) return {};
  Support<Rational> end = guided<Rational>();
  if (ends.ends_with("fixed")) end.turn = Restraint<Rational>::sprung(1);
  if (ends.ends_with("clamped")) end.turn = Restraint<Rational>::held();
  return end;
}

Structure<Rational> with_ends(std::size_t n, const std::string& ends) {
  const bool clamped = ends.starts_with("clamped");
  Structure<Rational> structure(unit_chain(n, clamped || ends.starts_with("pinned")));
  if (clamped) structure.base.turn = Restraint<Rational>::held();
  structure.end_point = end_of(ends);
  return structure;
}

std::size_t modes_of(std::size_t n) {
  return n <= 10 ? n : 3;
}

class Cases {
 public:
  void add(std::string name, Structure<Rational> structure, std::size_t modes) {
    cases_.push_back({std::move(name), std::move(structure), modes});
  }
  void add_compressed(const std::string& name, Structure<Rational> structure) {
    structure.add_compression();
    const std::size_t n = structure.chain.size();
    add(fmt::format("{}-{}", name, n), std::move(structure), modes_of(n));
  }
  std::vector<StructureCase> all() { return std::move(cases_); }

 private:
  std::vector<StructureCase> cases_;
};

void add_ends(Cases& cases, std::size_t n) {
  if (n > 1) cases.add_compressed("pinned-pinned", with_ends(n, "pinned-pinned"));
  cases.add_compressed("fixed-free", with_ends(n, "fixed-free"));
  if (n > 1) cases.add_compressed("fixed-pinned", with_ends(n, "fixed-pinned"));
  if (n > 1) cases.add_compressed("fixed-fixed", with_ends(n, "fixed-fixed"));
  if (n > 3) cases.add_compressed("clamped-clamped", with_ends(n, "clamped-clamped"));
  cases.add_compressed("rod-clamped-free", rod<Rational>(1, 1, n, RodEnd::clamped, RodEnd::free));
  if (n > 1)
    cases.add_compressed("rod-clamped-pinned", rod<Rational>(1, 1, n, RodEnd::clamped, RodEnd::pinned));
  if (n > 1)
    cases.add_compressed("rod-clamped-clamped", rod<Rational>(1, 1, n, RodEnd::clamped, RodEnd::clamped));
}

void add_springs_and_loads(Cases& cases, std::size_t n) {
  Structure<Rational> sprung = with_ends(n, "fixed-free");
  sprung.base.across = Restraint<Rational>::sprung(5);
  sprung.end_point.across = Restraint<Rational>::sprung(Rational(1, 2));
  sprung.end_point.turn = Restraint<Rational>::sprung(Rational(1, 4));
  cases.add_compressed("sprung", sprung);
  Structure<Rational> weight = with_ends(n, "fixed-free");
  for (std::size_t link = 1; link <= n; ++link) weight.add_weight(link, {-1, 0});
  cases.add(fmt::format("weight-{}", n), weight, modes_of(n));
  if (n < 2) return;
  Structure<Rational> bed = with_ends(n, "pinned-pinned");
  bed.add_foundation(Rational(1, 10));
  cases.add_compressed("bed", bed);
  Structure<Rational> both = with_ends(n, "fixed-free");
  const auto cube = static_cast<long>(n * n * n);
  for (std::size_t link = 1; link <= n; ++link) both.add_weight(link, {Rational(-2, cube), 0}, false);
  cases.add_compressed("weight-and-force", both);
  Structure<Rational> middle = with_ends(n, "pinned-pinned");
  middle.loads.push_back({n / 2, {-1, 0}, true, LoadKind::dead});
  cases.add(fmt::format("mid-force-{}", n), middle, 1);
  if (n < 4) return;
  Structure<Rational> held = with_ends(n, "pinned-pinned");
  held.across.resize(n - 1);
  held.across[n / 2 - 1] = Restraint<Rational>::held();
  cases.add_compressed("held-joint", held);
}

void add_followers(Cases& cases, std::size_t most) {
  for (std::size_t n = 2; n <= most; ++n) {
    Structure<Rational> structure = with_ends(n, "fixed-free");
    structure.mass.assign(n + 1, Rational(1));
    structure.loads.push_back({n, {-1, 0}, true, LoadKind::follower});
    cases.add(fmt::format("follower-{}", n), structure, 1);
  }
  Structure<Rational> ziegler = with_ends(2, "fixed-free");
  ziegler.mass = {0, 2, 1};
  ziegler.loads.push_back({2, {-1, 0}, true, LoadKind::follower});
  cases.add("follower-ziegler", ziegler, 1);
}

Restraint<Rational> random_restraint(Draw& draw, bool may_be_held) {
  const int kind = draw.whole(0, may_be_held ? 3 : 2);
  if (kind == 3) return Restraint<Rational>::held();
  return kind == 2 ? Restraint<Rational>::sprung(draw.decimal(-1, 1)) : Restraint<Rational>();
}

/// One that is held enough, and is compressed: the first of those with this name, numbered, that is.
void add_random(Cases& cases, const std::string& name, std::uint64_t seed) {
  for (int attempt = 0;; ++attempt) {
    Draw draw(fmt::format("{}/{}", name, attempt), seed);
    const std::size_t n = draw.count(2, 12);
    std::vector<Rational> length, stiffness;
    for (std::size_t i = 0; i < n; ++i) {
      length.push_back(draw.decimal(-1, 1));
      stiffness.push_back(draw.decimal(-1, 1));
    }
    Structure<Rational> structure(Chain<Rational>(length, stiffness));
    structure.end_point.across = random_restraint(draw, true);
    structure.end_point.turn = random_restraint(draw, true);
    for (std::size_t i = 1; i < n; ++i)
      structure.across.push_back(draw.whole(0, 3) == 0 ? random_restraint(draw, true)
                                                       : Restraint<Rational>());
    for (int load = draw.whole(1, 3); load > 0; --load)
      structure.loads.push_back(
          {draw.count(1, n),
           {draw.whole(0, 3) == 0 ? draw.decimal(-1, 0) : Rational(-draw.decimal(-1, 1)), 0},
           draw.whole(0, 4) > 0,
           LoadKind::dead});
    try {
      const proofs::StraightStructure sound(structure);
      return cases.add(name, structure, modes_of(n));
    } catch (const Error&) {
    }
  }
}

}  // namespace

std::vector<StructureCase> structure_cases(ReferenceSize size, std::uint64_t seed) {
  const bool compact = size == ReferenceSize::compact;
  Cases cases;
  std::vector<std::size_t> links{1, 2, 3, 4, 5, 10, 100};
  if (!compact) {
    links.clear();
    for (std::size_t n = 1; n <= 100; ++n) links.push_back(n);
  }
  for (const std::size_t n : links) {
    add_ends(cases, n);
    add_springs_and_loads(cases, n);
  }
  add_followers(cases, compact ? 5 : 8);
  for (int i = 1; i <= (compact ? 20 : 500); ++i) add_random(cases, fmt::format("random-ends-{}", i), seed);
  return cases.all();
}

namespace {

std::string text(const Restraint<Rational>& restraint) {
  if (restraint.is_held()) return "held";
  return restraint.is_free() ? "free" : proofs::to_exact(restraint.stiffness);
}

json to_json(const Support<Rational>& support) {
  return {{"along", text(support.along)}, {"across", text(support.across)}, {"turn", text(support.turn)}};
}

/// Everything at its node. The base does not move, so that it takes what acts there.
json assembled(const StructureCase& one) {
  const Structure<Rational>& structure = one.structure;
  json across = json::array(), loads = json::array();
  for (std::size_t node = 1; node < structure.chain.size(); ++node)
    across.push_back(text(structure.across_at(node)));
  for (const Load<Rational>& load : structure.loads) {
    if (load.node == 0) continue;
    loads.push_back({{"at", load.node},
                     {"force", proofs::to_exact(load.force.x)},
                     {"multiplied", load.multiplied ? 1 : 0},
                     {"follows", load.kind == LoadKind::follower ? 1 : 0}});
  }
  return {{"structure", one.name},
          {"lengths", proofs::exact_list(structure.chain.length())},
          {"stiffness", proofs::exact_list(structure.chain.stiffness())},
          {"base", to_json(structure.base)},
          {"end_point", to_json(structure.end_point)},
          {"across", across},
          {"loads", loads}};
}

}  // namespace

StructureEntry structure_entry(const StructureCase& one) {
  const json chain = statement::stated(one.structure);
  json certificate, entry = assembled(one);
  json factors = json::array();
  std::string kind = "buckling";
  if (one.structure.follower()) {
    const auto loss = proofs::stability_loss(straight_motion(one.structure), reference_digits);
    certificate = proofs::structure_certificate(one.name, chain, loss, reference_digits);
    factors.push_back(loss.factor);
    kind = name_of(loss.kind);
    const std::vector<Rational> masses = one.structure.masses();
    entry["masses"] = proofs::exact_list({masses.begin() + 1, masses.end()});
  } else {
    const proofs::StraightStructure straight(one.structure);
    certificate = proofs::structure_certificate(one.name, chain, straight, one.modes, reference_digits);
    entry["modes"] = straight.modes();
    for (const auto& mode : straight.in_decimals(one.modes, reference_digits, false))
      factors.push_back(mode.force);
  }
  entry["kind"] = kind;
  entry["factor"] = factors;
  return {std::move(entry), std::move(certificate)};
}

std::string structures_csv(const std::vector<json>& entries) {
  std::string text = "structure,mode,factor,kind\n";
  for (const json& entry : entries) {
    for (std::size_t m = 0; m < entry["factor"].size(); ++m)
      text += fmt::format("{},{},{},{}\n", entry["structure"].get<std::string>(), m + 1,
                          entry["factor"][m].get<std::string>(), entry["kind"].get<std::string>());
  }
  return text;
}

}  // namespace plumbline::verify
