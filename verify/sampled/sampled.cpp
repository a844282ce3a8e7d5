#include "verify/sampled/sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "verify/sampled/chain_properties.hpp"

namespace plumbline::verify {
namespace {

/// What can be merged in any order: sums, maxima, the least index.
struct Tally {
  std::size_t chains = 0, failures = 0;
  double worst_margin = 0;
  std::size_t first_failure = std::numeric_limits<std::size_t>::max();

  void add(const Margin& margin, std::size_t index) {
    if (!margin) return;
    ++chains;
    worst_margin = std::max(worst_margin, *margin);
    if (*margin <= 1) return;
    ++failures;
    first_failure = std::min(first_failure, index);
  }
  void merge(const Tally& other) {
    chains += other.chains;
    failures += other.failures;
    worst_margin = std::max(worst_margin, other.worst_margin);
    first_failure = std::min(first_failure, other.first_failure);
  }
};

/// What has been found so far, in any order.
struct Findings {
  std::vector<Tally> tallies = std::vector<Tally>(chain_properties().size());
  DoubleAgreement agreement;

  void merge(const Findings& other) {
    for (std::size_t p = 0; p < tallies.size(); ++p) tallies[p].merge(other.tallies[p]);
    agreement.unresolved += other.agreement.unresolved;
    for (std::size_t d = 0; d < agreement.digits.size(); ++d)
      agreement.digits[d] += other.agreement.digits[d];
  }
};

DoubleAgreement agreement_of(const Sample& sample) {
  DoubleAgreement agreement;
  for (std::size_t i = 0; i < sample.modes.size(); ++i) {
    if (sample.resolved(i, std::numeric_limits<double>::epsilon()) && !sample.forces_in_double.empty()) {
      const double digits = std::floor(-std::log10(std::max(sample.error_in_double(i), 1e-16)));
      ++agreement.digits.at(static_cast<std::size_t>(std::clamp(digits, 0.0, 16.0)));
    } else {
      ++agreement.unresolved;
    }
  }
  return agreement;
}

Findings check(std::uint64_t seed, std::size_t index) {
  const auto properties = chain_properties();
  Findings found;
  try {
    const Sample sample(random_chain(seed, index));
    for (std::size_t p = 0; p < properties.size(); ++p)
      found.tallies[p].add(properties[p].margin(sample), index);
    found.agreement = agreement_of(sample);
  } catch (const Error&) {  // Algorithm 1 in 50 digits: no property could be checked
    for (Tally& tally : found.tallies) tally.add(std::numeric_limits<double>::infinity(), index);
  }
  return found;
}

/// Infinity, which JSON does not know, is null.
nlohmann::json as_json(const Tally& tally) {
  return {tally.chains, tally.failures, tally.worst_margin, tally.first_failure};
}

Tally tally_from(const nlohmann::json& json) {
  const double margin = json[2].is_null() ? std::numeric_limits<double>::infinity() : json[2].get<double>();
  return {json[0], json[1], margin, json[3]};
}

Findings findings_from(const std::string& result) {
  const nlohmann::json json = nlohmann::json::parse(result);
  Findings found;
  std::transform(json["tallies"].begin(), json["tallies"].end(), found.tallies.begin(), tally_from);
  found.agreement = {json["unresolved"], json["digits"]};
  return found;
}

/// Chains begin … end - 1 of a seed: an item of work.
struct Block {
  std::uint64_t seed;
  std::size_t begin, end;
};

std::string as_item(const Block& block) {
  return nlohmann::json{block.seed, block.begin, block.end}.dump();
}

std::string result_of(const std::string& item) {
  const nlohmann::json block = nlohmann::json::parse(item);
  Findings found;
  for (std::size_t index = block[1]; index < block[2]; ++index) found.merge(check(block[0], index));
  nlohmann::json tallies = nlohmann::json::array();
  for (const Tally& tally : found.tallies) tallies.push_back(as_json(tally));
  return nlohmann::json{
      {"tallies", tallies}, {"unresolved", found.agreement.unresolved}, {"digits", found.agreement.digits}}
      .dump();
}

/// About a thousand items, that many may share them to the end; of a billion chains more, for none may take
/// long.
/// A thousand blocks at least, none of which takes longer than a second until they are a million.
std::size_t usual_block(std::size_t chains) {
  return std::clamp<std::size_t>(chains / 1000, 1, std::max<std::size_t>(100, chains / 1000000));
}

std::vector<Block> blocks_of(std::size_t chains, std::uint64_t seed, std::size_t size) {
  std::vector<Block> blocks;
  for (std::size_t begin = 0; begin < chains; begin += size)
    blocks.push_back({seed, begin, std::min(begin + size, chains)});
  return blocks;
}

std::string as_chain_file(const Chain<double>& chain) {
  return fmt::format("lengths = [{}]\nstiffness = [{}]\n", fmt::join(chain.length(), ", "),
                     fmt::join(chain.stiffness(), ", "));
}

}  // namespace

Chain<double> random_chain(std::uint64_t seed, std::uint64_t index) {
  std::seed_seq words{seed, seed >> 32, index, index >> 32};
  std::mt19937_64 random(words);
  const auto below = [&](std::uint64_t bound) { return random() % bound; };  // the same on every platform
  const std::uint64_t octaves = std::array<std::uint64_t, 4>{1, 4, 13, 27}[below(4)];
  const bool ties = below(3) == 0;
  const auto number = [&] {
    const auto mantissa = 1 + static_cast<double>(below(ties ? 2 : 256)) / 256;
    return std::ldexp(mantissa, static_cast<int>(below(ties ? 2 : octaves)) - static_cast<int>(octaves / 2));
  };
  std::vector<double> length(2 + below(7)), stiffness(length.size());
  for (double& L : length) L = number();
  for (double& k : stiffness) k = number();
  const std::uint64_t passive = below(8);
  if (passive < 2) stiffness[0] = 0;
  if (passive == 2) stiffness[below(stiffness.size())] = 0;
  return Chain<double>(length, stiffness);
}

std::string summary(const DoubleAgreement& agreement) {
  const std::size_t resolved =
      std::accumulate(agreement.digits.begin(), agreement.digits.end(), std::size_t{0});
  // the largest number of digits that at least this share of the resolved forces agrees to
  const auto digits_of = [&](double share) {
    std::size_t d = agreement.digits.size(), reached = 0;
    while (d > 0 && static_cast<double>(reached) < share * static_cast<double>(resolved))
      reached += agreement.digits.at(--d);
    return d;
  };
  return fmt::format(
      "{} of {} forces resolved in double; of these half agree to {} digits or more, 99 % to {}, all to {}",
      resolved, resolved + agreement.unresolved, digits_of(0.5), digits_of(0.99), digits_of(1));
}

const work::Task chains_task{"chains", result_of};

SampledChains check_random_chains(std::size_t chains, std::uint64_t seed, work::Journal* journal,
                                  const std::function<void(std::size_t)>& advance, std::size_t block) {
  const std::vector<Block> blocks = blocks_of(chains, seed, block == 0 ? usual_block(chains) : block);
  work::WorkList list{chains_task, {}};
  for (const Block& one : blocks) list.items.push_back(as_item(one));
  Findings total;
  work::do_all(list, journal, [&](std::size_t i, const std::string& result) {
    total.merge(findings_from(result));
    advance(blocks[i].end - blocks[i].begin);
  });
  SampledChains result{{}, total.agreement};
  for (std::size_t p = 0; p < total.tallies.size(); ++p) {
    const ChainProperty& property = chain_properties()[p];
    const Tally& tally = total.tallies[p];
    result.properties.push_back(
        {property.name, property.statement, tally.chains, tally.failures, tally.worst_margin,
         tally.failures == 0 ? "" : as_chain_file(random_chain(seed, tally.first_failure))});
  }
  return result;
}

}  // namespace plumbline::verify
