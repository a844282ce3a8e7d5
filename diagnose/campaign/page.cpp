#include <fmt/format.h>

#include "diagnose/campaign/page_texts.hpp"
#include "diagnose/campaign/report.hpp"
#include "support/page/chart.hpp"
#include "support/page/markup.hpp"

namespace plumbline::campaign {
namespace {

using Json = nlohmann::ordered_json;

/// A dot for each experiment, its bounds as a line; the mean across them all.
page::Chart chart(const Parameter& parameter, const std::vector<Outcome>& outcomes, bool by_date,
                  std::size_t number) {
  page::Chart drawing;
  drawing.id = fmt::format("parameter-{}", number);
  drawing.title = parameter.effect + " " + parameter.name;
  drawing.description = "The parameter in each experiment with its 95 % bounds, and their mean";
  drawing.x_label = by_date ? "day" : "experiment, as listed";
  drawing.y_label = parameter.unit == "ratio" ? parameter.name : parameter.name + ", " + parameter.unit;
  page::Layer dots{page::Layer::Kind::dots, "measured", {}, 2.4};
  dots.told = true;
  page::Layer bars{page::Layer::Kind::line, "measured", {}};
  page::Layer mean{page::Layer::Kind::line, "corrected", {}};
  for (std::size_t i = 0; i < parameter.estimates.size(); ++i) {
    const Outcome& outcome = outcomes[parameter.outcomes[i]];
    const Outcome& first = outcomes[parameter.outcomes.front()];
    const double x = by_date ? static_cast<double>((*outcome.date - *first.date).count())
                             : static_cast<double>(parameter.outcomes[i] + 1);
    const Estimate& one = parameter.estimates[i];
    dots.points.push_back({x, one.value});
    bars.points.insert(bars.points.end(), {{x, one.low}, {x, one.high}, {NAN, NAN}});
    mean.points.push_back({x, parameter.mean.value});
  }
  drawing.layers = {bars, mean, dots};
  return drawing;
}

}  // namespace

std::string as_html(const std::vector<Outcome>& outcomes, const Comparison& comparison,
                    const std::vector<Since>& since) {
  Json view{{"count", outcomes.size()}, {"same_cause", same_cause(outcomes, comparison)}};
  view["experiments"] = Json::array();
  view["failures"] = Json::array();
  for (const Outcome& one : outcomes) {
    const bool reported = one.failure.empty();
    view["experiments"].push_back(
        {{"name", one.name},
         {"date", date_text(one)},
         {"said", said(one)},
         {"left", reported && one.report.shrunk ? fmt::format("{:.3g}", *one.report.shrunk) : ""}});
    if (!reported) view["failures"].push_back({{"name", one.name}, {"failure", one.failure}});
  }
  view["failed"] = {{"any", comparison.failed > 0}};
  view["in_time"] = {{"any", !since.empty()}};
  view["since"] = Json::array();
  for (const Since& one : since)
    view["since"].push_back({{"effect", one.effect}, {"words", words(one, outcomes)}});
  view["parameters"] = Json::array();
  for (const Parameter& one : comparison.parameters)
    view["parameters"].push_back(
        {{"title", one.effect + " " + one.name},
         {"words", words(one, comparison.by_date)},
         {"svg", page::drawn(chart(one, outcomes, comparison.by_date, view["parameters"].size() + 1))}});
  return page::document("Diagnoses of many experiments",
                        "Whether the cause is the same, how its parameter scatters and drifts",
                        page::filled(campaign_template, view));
}

}  // namespace plumbline::campaign
