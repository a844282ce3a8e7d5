#include "trial/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/page/table.hpp"

namespace plumbline::trial {
namespace {

std::string percent(const Proportion& p) {
  return p.total == 0 ? "-" : fmt::format("{:.1f} %", 100 * p.share());
}
std::string interval(const Proportion& p) {
  return p.total == 0 ? "-" : fmt::format("{:.1f} to {:.1f} %", 100 * p.low(), 100 * p.high());
}
std::string of(const Proportion& p) {
  return fmt::format("{} of {}", p.count, p.total);
}

bool failed(const Case& one) {
  return one.judgement.answer != Answer::right && one.judgement.answer != Answer::in_class;
}

/// Order of failures: wrong and sure first, then answers that are missing.
int gravity(Answer answer) {
  switch (answer) {
    case Answer::no_report:
      return 0;
    case Answer::wrong_sure:
      return 1;
    case Answer::false_alarm:
      return 2;
    case Answer::wrong_ambiguous:
      return 3;
    case Answer::part:
      return 4;
    case Answer::missed_gap:
      return 5;
    default:
      return 6;
  }
}

std::string shortened(const std::string& text, std::size_t most) {
  return text.size() <= most ? text : text.substr(0, most) + " ...";
}

page::Table failures(const std::vector<Case>& cases, std::size_t most) {
  std::vector<const Case*> list;
  for (const Case& one : cases)
    if (failed(one) || !one.seal_holds) list.push_back(&one);
  std::stable_sort(list.begin(), list.end(), [](const Case* a, const Case* b) {
    const int one = gravity(a->judgement.answer), other = gravity(b->judgement.answer);
    return one != other ? one < other : a->label.strength > b->label.strength;
  });
  page::Table table{{"failure", "experiment", "sigma", "truth", "said"}, {}};
  for (const Case* one : list)
    table.rows.push_back({one->seal_holds ? answer_word(one->judgement.answer) : "broken seal",
                          one->label.name, fmt::format("{:.1f}", one->label.strength),
                          truth_words(one->label), shortened(one->judgement.said, most)});
  return table;
}

page::Table headline(const Score& s) {
  page::Table table{{"what", "aim", "share", "count", "95 % interval"}, {}};
  const auto add = [&](const char* what, const char* aim, const Proportion& p) {
    table.rows.push_back({what, aim, percent(p), of(p), interval(p)});
  };
  add("one effect, gap of 5 sigma or more: cause and joint found", ">= 95 %", s.strong);
  add("one effect, gap of 2.5 to 5 sigma: the same", ">= 80 %", s.weak);
  add("identified, and wrong", "<= 2 %", s.wrong_sure);
  add("no effect: a gap seen (false alarm)", "<= 5 %", s.false_alarm);
  add("effect outside the catalogue: called unknown", ">= 90 %", s.outside);
  add("... and its joint, or else its channel, named first", ">= 90 %", s.place);
  add("two effects at once: both found", ">= 80 %", s.pairs);
  add("true parameter inside its 95 % bounds", "90 to 99 %", s.covered);
  add("found, in a class that lists more than it must", "<= 15 %", s.oversized_class);
  return table;
}

page::Table answers(const std::string& what, const std::vector<Row>& rows) {
  page::Table table{{what, "n"}, {}};
  std::vector<std::size_t> shown;
  for (std::size_t a = 0; a <= static_cast<std::size_t>(Answer::no_report); ++a) {
    const bool any =
        std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.answers[a] > 0; });
    if (any) shown.push_back(a), table.header.push_back(answer_word(static_cast<Answer>(a)));
  }
  table.header.insert(table.header.end(), {"found", "95 % interval"});
  for (const Row& row : rows) {
    std::vector<std::string> cells{row.name, std::to_string(row.found.total)};
    for (const std::size_t a : shown)
      cells.push_back(row.answers[a] > 0 ? std::to_string(row.answers[a]) : ".");
    cells.insert(cells.end(), {percent(row.found), interval(row.found)});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Order of families: wrong and sure first.
page::Table families(const std::vector<Row>& rows) {
  page::Table table{
      {"family", "n", "wrong and sure", "95 % interval", "found", "unknown", "missed gap", "false alarm"},
      {}};
  for (const Row& row : rows) {
    std::vector<std::string> cells{row.name, std::to_string(row.found.total), percent(row.wrong_sure),
                                   interval(row.wrong_sure), percent(row.found)};
    for (const Answer answer : {Answer::unknown, Answer::missed_gap, Answer::false_alarm})
      cells.push_back(std::to_string(row.answers[static_cast<std::size_t>(answer)]));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

page::Table confusion(const Score& s) {
  page::Table table{{"truth", "n", "said best"}, {}};
  for (const auto& [truth, said] : s.confusion) {
    std::vector<std::pair<std::size_t, std::string>> often;
    std::size_t all = 0;
    for (const auto& [what, times] : said) often.emplace_back(times, what), all += times;
    std::stable_sort(often.begin(), often.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string words;
    for (const auto& [times, what] : often)
      words += fmt::format("{}{} {}", words.empty() ? "" : ", ", times, what);
    table.rows.push_back({truth, std::to_string(all), words});
  }
  return table;
}

page::Table reliability(const Score& s) {
  page::Table table{{"stated probability", "mean stated", "right", "count", "95 % interval"}, {}};
  for (const Reliability& bin : s.reliability) {
    if (bin.right.total == 0) continue;
    table.rows.push_back({fmt::format("{:g} to {:g}", bin.low, std::min(1.0, bin.high)),
                          fmt::format("{:.1f} %", 100 * bin.stated), percent(bin.right), of(bin.right),
                          interval(bin.right)});
  }
  return table;
}

std::string seals(const Circumstances& c, const Score& s) {
  if (c.sealed == 0) return "The labels were not sealed.\n";
  return fmt::format(
      "{} labels were sealed before the diagnosis began (SHA-256 of the seals: {}). Opened after it, {}.\n",
      c.sealed, c.seals_digest,
      s.broken_seals == 0 ? "every seal holds" : fmt::format("{} DO NOT HOLD", s.broken_seals));
}

std::string numbers(const Circumstances& c, const Score& s) {
  std::string text = fmt::format(
      "Held-out residual over the noise floor, where the cause was found: median {:.3f}, nine in ten below "
      "{:.3f}, "
      "worst {:.2f} (aim: median <= 1.05).\nBrier score of the stated probabilities: {:.3f} (0 is best, 2 "
      "worst).\n"
      "Without a report (crash, timeout, invalid JSON): {}.\n",
      s.shrunk.median, s.shrunk.ninth_decile, s.shrunk.worst, s.brier, s.no_report);
  if (c.compared > 0)
    text += fmt::format(
        "The rig without any effect against the nominal statics, {} benches: the largest difference of a "
        "reading is "
        "{:.2g} sigma in the median, {:.2g} sigma at worst.\n",
        c.compared, c.median_error, c.worst_error);
  return text;
}

/// Durations, for the terminal alone.
std::string times(const Spread& seconds) {
  return fmt::format("Time of a diagnosis: median {:.2f} s, nine in ten below {:.2f} s, longest {:.2f} s.\n",
                     seconds.median, seconds.ninth_decile, seconds.worst);
}

nlohmann::ordered_json proportion(const Proportion& p) {
  if (p.total == 0) return {{"count", 0}, {"total", 0}};
  return {{"count", p.count}, {"total", p.total}, {"share", p.share()}, {"low", p.low()}, {"high", p.high()}};
}

nlohmann::ordered_json rows(const std::vector<Row>& all) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : all) {
    nlohmann::ordered_json answers = nlohmann::ordered_json::object();
    for (std::size_t a = 0; a < row.answers.size(); ++a)
      if (row.answers[a] > 0) answers[answer_word(static_cast<Answer>(a))] = row.answers[a];
    list.push_back({{"name", row.name},
                    {"answers", answers},
                    {"found", proportion(row.found)},
                    {"wrong_and_sure", proportion(row.wrong_sure)}});
  }
  return list;
}

nlohmann::ordered_json spread(const Spread& s) {
  return {{"median", s.median}, {"ninth_decile", s.ninth_decile}, {"worst", s.worst}};
}

nlohmann::ordered_json case_json(const Case& one) {
  nlohmann::ordered_json json{{"name", one.label.name},
                              {"truth", truth_words(one.label)},
                              {"strength_sigma", one.label.strength},
                              {"family", one.label.family},
                              {"noise", one.label.noise},
                              {"answer", answer_word(one.judgement.answer)},
                              {"said", one.judgement.said},
                              {"class_size", one.judgement.class_size},
                              {"seal_holds", one.seal_holds}};
  if (one.judgement.shrunk) json["shrunk"] = *one.judgement.shrunk;
  if (one.judgement.stated) json["probability"] = one.judgement.stated->first;
  return json;
}

}  // namespace

std::string as_text(const Circumstances& circumstances, const std::vector<Case>& cases, Style style) {
  const Score s = score(cases);
  const bool markdown = style == Style::markdown;
  std::string text;
  const auto section = [&](const std::string& title, const page::Table& table, const std::string& note = "") {
    if (table.rows.empty()) return;
    text += markdown ? "\n## " + title + "\n\n" : "\n" + title + "\n";
    if (!note.empty()) text += note + (markdown ? "\n\n" : "\n");
    text += markdown ? page::markdown_table(table) : page::terminal_table(table);
  };
  const std::string paragraph = markdown ? "\n" : "";
  text += markdown ? "# The blind trial\n\n" : "The blind trial\n";
  text += fmt::format("{} experiments, {} right or in the class ({}).{}", s.cases, s.all.found.count,
                      percent(s.all.found),
                      markdown ? " Made by\n\n    " + circumstances.command + "\n\n" : "\n");
  text += seals(circumstances, s);
  constexpr std::size_t narrow = 60, wide = 160;
  section("By family: wrong and sure", families(s.by_family));
  section("By noise", answers("noise", s.by_noise));
  section("Failures", failures(cases, markdown ? wide : narrow));
  section("Against the aims", headline(s));
  text += "\n" + numbers(circumstances, s) + (markdown ? "" : times(s.seconds));
  section("By strength of the gap", answers("one effect", s.by_strength));
  section("By truth", answers("truth", s.by_truth));
  section("Confusion", confusion(s), "The best explanation, also of a class; joints left out.");
  section("Reliability", reliability(s),
          "How often the most probable explanation was the truth, where a gap was seen.");
  return text;
}

nlohmann::ordered_json as_json(const Circumstances& c, const std::vector<Case>& cases) {
  using Json = nlohmann::ordered_json;
  const Score s = score(cases);
  Json bins = Json::array(), list = Json::array();
  for (const Reliability& bin : s.reliability)
    bins.push_back({{"from", bin.low},
                    {"to", std::min(1.0, bin.high)},
                    {"stated", bin.stated},
                    {"right", proportion(bin.right)}});
  for (const Case& one : cases) list.push_back(case_json(one));
  return {{"format", "blind-trial/2"},
          {"command", c.command},
          {"seals", {{"sealed", c.sealed}, {"sha256", c.seals_digest}, {"broken", s.broken_seals}}},
          {"found", proportion(s.all.found)},
          {"strong", proportion(s.strong)},
          {"weak", proportion(s.weak)},
          {"identified_and_wrong", proportion(s.wrong_sure)},
          {"false_alarm", proportion(s.false_alarm)},
          {"outside", proportion(s.outside)},
          {"outside_joint", proportion(s.place)},
          {"pairs", proportion(s.pairs)},
          {"covered", proportion(s.covered)},
          {"oversized_class", proportion(s.oversized_class)},
          {"no_report", s.no_report},
          {"heldout_over_noise_floor", spread(s.shrunk)},
          {"brier", s.brier},
          {"reliability", bins},
          {"by_strength", rows(s.by_strength)},
          {"by_truth", rows(s.by_truth)},
          {"by_noise", rows(s.by_noise)},
          {"by_family", rows(s.by_family)},
          {"confusion", s.confusion},
          {"nominal_error_sigma",
           {{"benches", c.compared}, {"median", c.median_error}, {"worst", c.worst_error}}},
          {"experiments", list}};
}

}  // namespace plumbline::trial
