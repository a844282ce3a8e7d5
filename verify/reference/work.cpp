#include "verify/reference/work.hpp"

#include <memory>
#include <mutex>

namespace plumbline::verify {
namespace {

using nlohmann::json;

constexpr std::size_t most_links_with_path = 2;  ///< of random chains: certificates of paths are long

struct Set {
  ReferenceWish wish;
  std::vector<ReferenceChain> chains;
  std::vector<LoadedCase> cases;
  std::vector<StructureCase> structures;

  [[nodiscard]] std::size_t size() const { return chains.size() + cases.size() + structures.size(); }
};

/// The last that was asked for; every item of a work asks for the same.
std::shared_ptr<const Set> set_of(const ReferenceWish& wish) {
  static std::mutex making;
  static std::shared_ptr<const Set> last;
  const std::scoped_lock lock(making);
  if (!last || last->wish != wish)
    last = std::make_shared<Set>(Set{wish, reference_chains(wish), loaded_cases(wish.size, wish.seed),
                                     structure_cases(wish.size, wish.seed)});
  return last;
}

json as_json(const ReferenceEntry& entry) {
  json modes = json::array();
  for (const ReferenceMode& mode : entry.modes)
    modes.push_back({mode.force, mode.energy_factor, mode.angles});
  return {{"modes", modes}, {"certificate", entry.certificate}};
}

ReferenceEntry entry_from(const ReferenceChain& chain, json result) {
  ReferenceEntry entry{chain.name, chain.chain, {}, std::move(result["certificate"])};
  for (const json& mode : result["modes"]) entry.modes.push_back({mode[0], mode[1], mode[2]});
  return entry;
}

/// What there is of a loaded chain.
json loaded_result(const LoadedCase& one) {
  json result = json::object();
  if (auto found = equilibria_entry(one))
    result = {{"equilibria", std::move(found->entry)}, {"certificate", std::move(found->certificate)}};
  if (one.window == 0) return result;
  if (auto entry = events_entry(one)) result["events"] = *std::move(entry);
  if (one.task.chain.size() <= most_links_with_path || !one.task.name.starts_with("loaded"))
    if (auto entry = path_entry(one)) result["path"] = *std::move(entry);
  return result;
}

void take(json result, LoadedEntries& loaded) {
  const auto move = [&](const char* key, std::vector<json>& list) {
    if (result.contains(key)) list.push_back(std::move(result[key]));
  };
  move("equilibria", loaded.equilibria);
  move("certificate", loaded.certificates);
  move("events", loaded.events);
  move("path", loaded.paths);
}

std::string result_of(const std::string& item) {
  const json told = json::parse(item);
  const bool compact = told["compact"];
  const auto set =
      set_of({compact ? ReferenceSize::compact : ReferenceSize::full, told["seed"], told["random"]});
  const std::size_t number = told["chain"], chains = set->chains.size(), cases = set->cases.size();
  if (number < chains) return as_json(reference_entry(set->chains[number])).dump();
  if (number < chains + cases) return loaded_result(set->cases[number - chains]).dump();
  const StructureEntry found = structure_entry(set->structures[number - chains - cases]);
  return json{{"structure", found.entry}, {"certificate", found.certificate}}.dump();
}

}  // namespace

// The precision that computations work in is one for all threads (proofs::WorkingPrecision).
const work::Task reference_task{"reference", result_of, false};

work::WorkList reference_work(const ReferenceWish& wish) {
  const auto set = set_of(wish);
  work::WorkList list{reference_task, {}};
  for (std::size_t number = 0; number < set->size(); ++number)
    list.items.push_back(json{
        {"compact", wish.size == ReferenceSize::compact},
        {"seed", wish.seed},
        {"random", wish.random},
        {"chain", number}}.dump());
  return list;
}

ReferenceValues reference_values(const ReferenceWish& wish, const std::vector<std::string>& results) {
  const auto set = set_of(wish);
  ReferenceValues values;
  for (std::size_t i = 0; i < results.size(); ++i) {
    json result = json::parse(results[i]);
    if (i < set->chains.size()) {
      values.entries.push_back(entry_from(set->chains[i], std::move(result)));
    } else if (i < set->chains.size() + set->cases.size()) {
      take(std::move(result), values.loaded);
    } else {
      values.structures.structures.push_back(std::move(result["structure"]));
      values.structures.certificates.push_back(std::move(result["certificate"]));
    }
  }
  return values;
}

}  // namespace plumbline::verify
