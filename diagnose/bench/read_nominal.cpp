#include "diagnose/bench/read_nominal.hpp"

#include <plumbline/base/error.hpp>

namespace plumbline::diagnose {
namespace {

NominalEffect read_effect(const Section& section) {
  section.allow_only({"id", "joint", "parameters"});
  return {section.text("id", "an id of the effect catalogue"), section.count("joint"),
          section.named_numbers("parameters")};
}

/// The key as experiments spell it or as chain files do, whichever stands there.
std::string spelling(const Section& nominal, const std::string& here, const std::string& in_chain_files) {
  if (!nominal.has(in_chain_files)) return here;
  if (nominal.has(here))
    throw Error(nominal.place(in_chain_files), "both " + here + " and " + in_chain_files,
                "one of the two, which mean the same");
  return in_chain_files;
}

}  // namespace

NominalChain read_nominal(const Section& nominal) {
  nominal.allow_only({"link_length", "joint_stiffness", "link_mass", "gravity", "rest", "effect"},
                     {"lengths", "stiffness"});
  const std::string lengths = spelling(nominal, "link_length", "lengths"),
                    stiffness = spelling(nominal, "joint_stiffness", "stiffness");
  NominalChain chain;
  chain.link_length = nominal.numbers(lengths, 0, "a positive length", [](double v) { return v > 0; });
  const std::size_t n = chain.link_length.size();
  const auto not_negative = [](double v) { return v >= 0; };
  chain.joint_stiffness =
      nominal.numbers(stiffness, n, "zero (passive) or a positive stiffness", not_negative);
  chain.link_mass.assign(n, 0.0);
  if (nominal.has("link_mass"))
    chain.link_mass = nominal.numbers("link_mass", n, "zero or a positive mass", not_negative);
  if (nominal.has("gravity")) chain.gravity = nominal.pair("gravity");
  if (nominal.has("rest")) chain.rest = nominal.numbers("rest", n);
  for (const Section& effect : nominal.tables("effect")) chain.effects.push_back(read_effect(effect));
  return chain;
}

NominalChain parse_nominal(const std::string& text, const std::string& source) {
  const toml::table table = files::parse_toml(text, source);
  const Section root(table, source);
  root.allow_only({"nominal"});
  return read_nominal(root.table("nominal"));
}

}  // namespace plumbline::diagnose
