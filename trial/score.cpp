#include "trial/score.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <plumbline/base/error.hpp>

namespace plumbline::trial {
namespace {

constexpr std::size_t answer_count = static_cast<std::size_t>(Answer::no_report) + 1;

bool is_single(const Label& label) {
  return label.effects.size() == 1 && !outside_catalogue(label);
}
bool found(const Case& one) {
  return one.judgement.answer == Answer::right || one.judgement.answer == Answer::in_class;
}

/// Whether an answer is identified and wrong, also without an effect.
bool wrong_and_sure(const Case& one) {
  const Answer answer = one.judgement.answer;
  return one.judgement.said.starts_with("identified") &&
         (answer == Answer::wrong_sure || answer == Answer::false_alarm);
}

void count(Row& row, const Case& one) {
  row.answers.resize(answer_count, 0);
  ++row.answers[static_cast<std::size_t>(one.judgement.answer)];
  row.found.add(found(one));
  row.wrong_sure.add(wrong_and_sure(one));
}

std::string band_name(const Band& band) {
  if (band.low == 0) return fmt::format("under {:g} sigma", band.high);
  if (std::isinf(band.high)) return fmt::format("{:g} sigma and more", band.low);
  return fmt::format("{:g} to {:g} sigma", band.low, band.high);
}

std::vector<Row> rows_by_strength(const std::vector<Case>& cases) {
  std::vector<Row> rows;
  for (const Band& band : bands()) {
    Row row{band_name(band), {}, {}};
    for (const Case& one : cases)
      if (is_single(one.label) && one.label.strength >= band.low && one.label.strength < band.high)
        count(row, one);
    if (row.found.total > 0) rows.push_back(std::move(row));
  }
  return rows;
}

/// The answer in the confusion table; the right kind at a wrong joint has its own entry.
std::string said_best(const Case& one) {
  const Judgement& judged = one.judgement;
  if (judged.answer == Answer::no_report) return answer_word(judged.answer);
  const bool misplaced = judged.best == truth_kind(one.label) &&
                         (judged.answer == Answer::wrong_sure || judged.answer == Answer::wrong_ambiguous);
  return misplaced ? judged.best + " at another joint" : judged.best;
}

/// The rows in the order of their keys.
std::vector<Row> in_order(std::map<std::string, Row> by_key) {
  std::vector<Row> rows;
  rows.reserve(by_key.size());
  for (auto& [key, row] : by_key) rows.push_back(std::move(row));
  return rows;
}

/// Order of rows: no effect, single effects by name, two effects, outside the catalogue.
std::vector<Row> rows_by_truth(const std::vector<Case>& cases) {
  std::map<std::string, Row> kinds;
  for (const Case& one : cases) {
    const std::size_t effects = one.label.effects.size();
    const std::string kind = effects > 1 ? "two or more effects" : truth_kind(one.label);
    const char* place = effects == 0 ? "0" : effects > 1 ? "2" : outside_catalogue(one.label) ? "3" : "1";
    Row& row = kinds[place + kind];
    row.name = outside_catalogue(one.label) ? "outside the catalogue" : kind;
    count(row, one);
  }
  return in_order(std::move(kinds));
}

std::vector<Row> rows_by_noise(const std::vector<Case>& cases) {
  std::map<std::string, Row> kinds;
  for (const Case& one : cases) {
    if (one.label.noise.empty()) continue;
    Row& row = kinds[one.label.noise];
    row.name = one.label.noise;
    count(row, one);
  }
  return in_order(std::move(kinds));
}

/// The family of a cause outside the catalogue is its description.
std::vector<Row> rows_by_family(const std::vector<Case>& cases) {
  std::map<std::string, Row> families;
  for (const Case& one : cases) {
    if (one.label.family.empty()) continue;
    const std::string name =
        outside_catalogue(one.label) ? "outside: " + one.label.description : one.label.family;
    families[name].name = name;
    count(families[name], one);
  }
  std::vector<Row> rows = in_order(std::move(families));
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.wrong_sure.share() > b.wrong_sure.share(); });
  return rows;
}

Spread spread(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
  };
  return {at(0.5), at(0.9), values.back()};
}

std::vector<Reliability> reliability(const std::vector<Case>& cases) {
  std::vector<Reliability> bins{{0, 0.3}, {0.3, 0.5}, {0.5, 0.7}, {0.7, 0.9}, {0.9, 0.99}, {0.99, 1.0000001}};
  for (const Case& one : cases) {
    if (!one.judgement.stated) continue;
    const auto [probability, right] = *one.judgement.stated;
    for (Reliability& bin : bins) {
      if (probability < bin.low || probability >= bin.high) continue;
      bin.stated += probability;
      bin.right.add(right);
    }
  }
  for (Reliability& bin : bins) bin.stated /= static_cast<double>(std::max<std::size_t>(1, bin.right.total));
  return bins;
}

/// Adds a case to the proportions in which it counts.
void count_proportions(Score& total, const Case& one) {
  const Label& label = one.label;
  const Judgement& judged = one.judgement;
  if (is_single(label) && label.strength >= 5) total.strong.add(found(one));
  if (is_single(label) && label.strength >= 2.5 && label.strength < 5) total.weak.add(found(one));
  if (judged.said.starts_with("identified")) total.wrong_sure.add(wrong_and_sure(one));
  if (label.effects.empty()) total.false_alarm.add(judged.answer == Answer::false_alarm);
  if (outside_catalogue(label)) total.outside.add(found(one));
  if (judged.place_right) total.place.add(*judged.place_right);
  if (label.effects.size() > 1) total.pairs.add(found(one));
  for (const auto& [name, inside] : judged.covered) total.covered.add(inside);
  if (found(one) && !label.effects.empty() && !outside_catalogue(label))
    total.oversized_class.add(judged.oversized_class);
  total.no_report += judged.answer == Answer::no_report;
  total.broken_seals += !one.seal_holds;
}

}  // namespace

std::string truth_kind(const Label& label) {
  std::vector<std::string> ids;
  for (const TrueEffect& effect : label.effects) ids.push_back(effect.id);
  std::sort(ids.begin(), ids.end());
  return ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, "+"));
}

std::string truth_words(const Label& label) {
  std::vector<std::string> keys;
  for (const TrueEffect& effect : label.effects) keys.push_back(effect_key(effect.id, effect.joint));
  const std::string words = keys.empty() ? "none" : fmt::format("{}", fmt::join(keys, "+"));
  return label.description.empty() ? words : words + ": " + label.description;
}

const std::vector<Band>& bands() {
  static const std::vector<Band> all{
      {0, 2.5}, {2.5, 5}, {5, 10}, {10, 20}, {20, std::numeric_limits<double>::infinity()}};
  return all;
}

Score score(const std::vector<Case>& cases) {
  Score total;
  total.cases = cases.size();
  total.all.name = "all";
  std::vector<double> shrunk, seconds, brier;
  for (const Case& one : cases) {
    count(total.all, one);
    count_proportions(total, one);
    ++total.confusion[truth_kind(one.label)][said_best(one)];
    if (one.judgement.shrunk) shrunk.push_back(*one.judgement.shrunk);
    seconds.push_back(one.seconds);
    if (one.judgement.stated) brier.push_back(one.judgement.brier);
  }
  total.by_strength = rows_by_strength(cases);
  total.by_truth = rows_by_truth(cases);
  total.by_noise = rows_by_noise(cases);
  total.by_family = rows_by_family(cases);
  total.reliability = reliability(cases);
  for (const double one : brier) total.brier += one / static_cast<double>(brier.size());
  total.shrunk = spread(std::move(shrunk));
  total.seconds = spread(std::move(seconds));
  return total;
}

}  // namespace plumbline::trial
