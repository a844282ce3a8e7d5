#include "app/critical_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/case_words.hpp"
#include "proofs/exact/decimal.hpp"
#include "support/files/csv_file.hpp"

namespace plumbline::app {
namespace {

/// The decimal as short as it can be written with 15 digits.
std::string brief(const Rational& x) {
  std::string text = proofs::to_decimal(x, 15);
  const std::size_t exponent = std::min(text.find('e'), text.size());
  if (text.find('.') < exponent) {
    const std::size_t last = text.find_last_not_of('0', exponent - 1);
    text.erase(last + (text[last] == '.' ? 0 : 1), exponent - last - (text[last] == '.' ? 0 : 1));
  }
  return text;
}

/// "first, second, …", the middle left out when there are many.
std::string listing(const std::vector<Rational>& values) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values.size() > most && i == most - 2) {
      text += ", ...";
      i = values.size() - 2;
      continue;
    }
    text += (text.empty() ? "" : ", ") + brief(values[i]);
  }
  return text;
}

/// The sign pattern, its middle left out when it is long.
std::string brief_signs(const std::string& signs) {
  constexpr std::size_t most = 24;
  return signs.size() <= most ? signs
                              : signs.substr(0, most / 2) + "..." + signs.substr(signs.size() - most / 2);
}

/// Rows of right-aligned angles with so many to a line.
std::string angles(std::size_t number, const proofs::CriticalMode& mode) {
  constexpr std::size_t to_a_line = 8, most = 1000;
  std::string text = fmt::format("{:4}", number);
  for (std::size_t i = 0; i < std::min(most, mode.q.size()); ++i) {
    if (i > 0 && i % to_a_line == 0) text += "\n    ";
    text += fmt::format(" {:8.4f}", mode.q[i]);
  }
  if (mode.q.size() > most) text += fmt::format("\n    and {} more: --json", mode.q.size() - most);
  return text + fmt::format("   Fy {}\n", proofs::to_decimal(mode.fy, 4));
}

/// The force of a chain of bars beside that of its rod.
std::string as_rod(const CriticalModes& result, const std::string& factor) {
  if (!result.beam) return "";
  const Rational force = *proofs::parse_decimal(factor), length = result.beam->bar * result.data.chain.size();
  const Rational in_EI = force * length * length / result.beam->EI;
  std::string text = fmt::format("In E I / length^2: {}\n", proofs::to_decimal(in_EI, 10));
  if (!result.rod) return text;
  if (!result.rod->loss) return text + fmt::format("The rod itself is not enclosed: {}\n", result.rod->open);
  const proofs::RodLoss& rod = *result.rod->loss;
  const Rational lack = 100 * (rod.factor.low - force) / rod.factor.low;
  text +=
      fmt::format("The rod itself: {}, proved in every digit; these links are {} % {}\n", rod.factor.decimal,
                  proofs::to_decimal(Rational(abs(lack)), 2), lack < 0 ? "above" : "below");
  if (rod.frequencies == 0) return text;
  return text +
         fmt::format("  {}, the first among its {} lowest frequencies; those above were not followed\n",
                     proofs::name_of(rod.kind), rod.frequencies);
}

nlohmann::ordered_json json_of(const proofs::RodLoss& rod) {
  nlohmann::ordered_json json{{"factor", rod.factor.decimal},
                              {"low", proofs::to_exact(rod.factor.low)},
                              {"high", proofs::to_exact(rod.factor.high)},
                              {"kind", proofs::name_of(rod.kind)}};
  if (rod.frequencies > 0) json["frequencies"] = rod.frequencies;
  return json;
}

std::string heading(const CriticalModes& result) {
  return fmt::format("{}: {} links, {}\n  lengths    {}\n  stiffness  {}\n", result.chain,
                     result.data.chain.size(), case_of(result.data), listing(result.data.chain.length()),
                     listing(result.data.chain.stiffness()));
}

/// At the base too where it moves across.
std::vector<Rational> masses_of(const Structure<Rational>& structure) {
  std::vector<Rational> masses = structure.masses();
  if (structure.base.across.is_held()) masses.erase(masses.begin());
  return masses;
}

std::string places_of_masses(const Structure<Rational>& structure) {
  return std::string(structure.base.across.is_held() ? "" : "at the base and ") +
         "at the far ends of the links" +
         (structure.mass.empty() ? ": half a link's length at either end of each" : "");
}

/// A stretch of factors at which the line is stable anew.
struct Window {
  const proofs::MotionChange* from;
  const proofs::MotionChange* to;  ///< none where it has no end
};

std::vector<Window> windows(const proofs::StabilityLoss& loss) {
  using proofs::Motion;
  std::vector<Window> all;
  Motion below = Motion::stable;
  for (const proofs::MotionChange& one : loss.changes) {
    const bool at_least_there = one.at == Motion::divergence || one.at == Motion::flutter;
    const bool lost = below == Motion::stable && (one.above != Motion::stable || at_least_there);
    if (lost && !all.empty()) all.back().to = &one;
    if (one.above == Motion::stable && (lost || below != Motion::stable)) all.push_back({&one, nullptr});
    below = one.above;
  }
  return all;
}

/// Factors at which two frequencies are equal, the line being stable to either side, and no more is known.
std::vector<std::string> undecided(const proofs::StabilityLoss& loss) {
  std::vector<std::string> all;
  proofs::Motion below = proofs::Motion::stable;
  for (const proofs::MotionChange& one : loss.changes) {
    const bool beside = below == proofs::Motion::stable && one.above == proofs::Motion::stable;
    if (beside && one.at == proofs::Motion::undecided) all.push_back(one.factor);
    below = one.above;
  }
  return all;
}

std::string proved_text(const proofs::StabilityLoss& loss) {
  if (!loss.first)
    return "Proved: stable just below, and not just above. Smaller factors were tried in steps.\n";
  const auto again = windows(loss);
  const auto open = undecided(loss);
  std::string text =
      fmt::format("Proved: the straight line is stable at every smaller factor{}{}.\n",
                  open.empty() ? "" : " that is not named undecided", again.empty() ? ", and not above" : "");
  for (const Window& window : again) {
    text += fmt::format("It is stable again above {}", window.from->factor);
    text += window.to == nullptr
                ? ".\n"
                : fmt::format(", up to {} ({}).\n", window.to->factor,
                              proofs::name_of(window.to->above == proofs::Motion::stable ? window.to->at
                                                                                         : window.to->above));
  }
  if (!open.empty())
    text += fmt::format("Undecided are single factors at which two frequencies are equal: {}.\n",
                        fmt::join(open, ", "));
  return text;
}

/// What a structure under a load that follows it does.
std::string loss_text(const CriticalModes& result) {
  const proofs::StabilityLoss& loss = *result.loss;
  const bool flutter = loss.kind == proofs::Motion::flutter;
  return heading(result) +
         fmt::format("  masses     {} ({})\n\n", listing(masses_of(result.data)),
                     places_of_masses(result.data)) +
         fmt::format("Critical factor of the loads {}: {}\n", loss.factor,
                     flutter ? "flutter, two frequencies of small motion meet"
                             : "divergence, a frequency of small motion is zero") +
         as_rod(result, loss.factor) + proved_text(loss);
}

nlohmann::ordered_json as_json(const proofs::StabilityLoss& loss, const Structure<Rational>& structure) {
  nlohmann::ordered_json masses = nlohmann::ordered_json::array(), again = masses;
  for (const Rational& mass : masses_of(structure)) masses.push_back(proofs::to_exact(mass));
  for (const Window& window : windows(loss)) {
    again.push_back({{"from", window.from->factor}, {"to", nullptr}});
    if (window.to != nullptr) again.back()["to"] = window.to->factor;
  }
  return {{"factor", loss.factor}, {"kind", proofs::name_of(loss.kind)}, {"masses", std::move(masses)},
          {"first", loss.first},   {"stable_again", std::move(again)},   {"undecided", undecided(loss)}};
}

}  // namespace

std::string as_text(const CriticalModes& result) {
  if (result.loss) return loss_text(result);
  std::size_t wide = 14, energy = 22, shape = 7;
  for (const proofs::CriticalMode& mode : result.modes) {
    wide = std::max(wide, mode.force.size() + 2);
    energy = std::max(energy, mode.energy_factor.size() + 2);
    shape = std::max(shape, shape_name(mode.signs).size() + 2);
  }
  std::string text = heading(result) + "\n";
  text += fmt::format("Critical {} {}, shape {}\n\n",
                      has_unit_compression(result.data) ? "force" : "factor of the loads",
                      result.modes[0].force, shape_name(result.modes[0].signs));
  if (result.beam) text.insert(text.size() - 1, as_rod(result, result.modes[0].force));
  text += fmt::format("mode  {:<{}}{:<{}}{:<{}}{}\n", "force", wide, "energy factor", energy, "shape", shape,
                      "signs");
  for (std::size_t m = 0; m < result.modes.size(); ++m) {
    const proofs::CriticalMode& mode = result.modes[m];
    text += fmt::format("{:4}  {:<{}}{:<{}}{:<{}}{}\n", m + 1, mode.force, wide, mode.energy_factor, energy,
                        shape_name(mode.signs), shape, brief_signs(mode.signs));
  }
  text += "\nmode  joint angles q1 ... qn and lateral force Fy, up to a common factor\n";
  for (std::size_t m = 0; m < result.modes.size(); ++m) text += angles(m + 1, result.modes[m]);
  const std::size_t more = result.all - result.modes.size();
  if (more > 0) text += fmt::format("\n{} more modes: --all\n", more);
  return text;
}

std::string as_text(const std::vector<CriticalModes>& results) {
  std::size_t name = 5, force = 5;
  for (const CriticalModes& result : results) {
    name = std::max(name, result.chain.size());
    for (const proofs::CriticalMode& mode : result.modes) force = std::max(force, mode.force.size());
  }
  std::string text = fmt::format("{:<{}}  links  mode  {:<{}}  shape\n", "chain", name, "force", force);
  for (const CriticalModes& result : results) {
    for (std::size_t m = 0; m < result.modes.size(); ++m) {
      text += fmt::format("{:<{}}  {:5}  {:4}  {:<{}}  {}\n", result.chain, name, result.data.chain.size(),
                          m + 1, result.modes[m].force, force, shape_name(result.modes[m].signs));
    }
  }
  return text;
}

std::string as_text(const SpaceModes& result) {
  std::string text = fmt::format("{}: {} links {}\n\nCritical factor of the loads {}\n\nmode  factor\n",
                                 result.chain, result.links, result.words, result.modes[0].force);
  for (std::size_t m = 0; m < result.modes.size(); ++m)
    text += fmt::format("{:4}  {}\n", m + 1, result.modes[m].force);
  text += "\nmode  angles about all axes, joint by joint, up to a common factor\n";
  for (std::size_t m = 0; m < result.modes.size(); ++m) {
    text += fmt::format("{:4}", m + 1);
    for (const double q : result.modes[m].q) text += fmt::format(" {:8.4f}", q);
    text += "\n";
  }
  const std::size_t more = result.all - result.modes.size();
  if (more > 0) text += fmt::format("\n{} more modes: --all\n", more);
  return text;
}

std::string as_csv(const SpaceModes& result) {
  std::string text = "chain,mode,force\n";
  for (std::size_t m = 0; m < result.modes.size(); ++m)
    text += fmt::format("{},{},{}\n", files::csv_field(result.chain), m + 1, result.modes[m].force);
  return text;
}

nlohmann::ordered_json as_json(const SpaceModes& result, int digits) {
  nlohmann::ordered_json modes = nlohmann::ordered_json::array();
  for (std::size_t m = 0; m < result.modes.size(); ++m)
    modes.push_back({{"mode", m + 1}, {"force", result.modes[m].force}, {"q", result.modes[m].q}});
  nlohmann::ordered_json chain{{"chain", result.chain},
                               {"links", result.links},
                               {"case", result.words},
                               {"digits", digits},
                               {"modes_in_space", modes}};
  return {{"chains", {chain}}, {"errors", nlohmann::ordered_json::array()}};
}

std::string as_text(const SpaceTorque& result) {
  return fmt::format(
      "{}: {} links {}\n\nCritical torque {}\n{}\n", result.chain, result.links, result.words, result.torque,
      result.conservative
          ? "The torque has an energy here: the straight line is stable below, and not above."
          : "The torque has no energy here: below, the straight line has no bent equilibrium beside it, but "
            "whether it\nflutters depends on masses.");
}

std::string as_csv(const SpaceTorque& result) {
  return fmt::format("chain,mode,force\n{},1,{}\n", files::csv_field(result.chain), result.torque);
}

nlohmann::ordered_json as_json(const SpaceTorque& result, int digits) {
  nlohmann::ordered_json chain{{"chain", result.chain},   {"links", result.links},
                               {"case", result.words},    {"digits", digits},
                               {"torque", result.torque}, {"conservative", result.conservative}};
  return {{"chains", {chain}}, {"errors", nlohmann::ordered_json::array()}};
}

std::string as_csv(const std::vector<CriticalModes>& results) {
  std::string text = "chain,mode,force\n";
  for (const CriticalModes& result : results) {
    for (std::size_t m = 0; m < result.modes.size(); ++m)
      text += fmt::format("{},{},{}\n", files::csv_field(result.chain), m + 1, result.modes[m].force);
    if (result.loss) text += fmt::format("{},1,{}\n", files::csv_field(result.chain), result.loss->factor);
  }
  return text;
}

nlohmann::ordered_json as_json(const std::vector<CriticalModes>& results,
                               const std::vector<std::string>& errors, int digits) {
  nlohmann::ordered_json chains = nlohmann::ordered_json::array();
  for (const CriticalModes& result : results) {
    nlohmann::ordered_json modes = nlohmann::ordered_json::array();
    for (std::size_t m = 0; m < result.modes.size(); ++m) {
      const proofs::CriticalMode& mode = result.modes[m];
      modes.push_back({{"mode", m + 1},
                       {"force", mode.force},
                       {"energy_factor", mode.energy_factor},
                       {"shape", shape_name(mode.signs)},
                       {"signs", mode.signs},
                       {"q", mode.q},
                       {"fy", proofs::to_decimal(mode.fy, 15)}});
    }
    nlohmann::ordered_json chain{{"chain", result.chain},
                                 {"links", result.data.chain.size()},
                                 {"case", case_of(result.data)},
                                 {"digits", digits}};
    if (result.rod && result.rod->loss) chain["rod"] = json_of(*result.rod->loss);
    if (result.loss) {
      chain["loss"] = as_json(*result.loss, result.data);
    } else {
      chain["modes"] = std::move(modes);
    }
    chains.push_back(std::move(chain));
  }
  return {{"chains", std::move(chains)}, {"errors", errors}};
}

}  // namespace plumbline::app
