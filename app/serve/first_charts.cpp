#include "app/serve/first_charts.hpp"

#include <iterator>

namespace plumbline::app {

std::vector<diagnose::PageChart> first_charts(const diagnose::Study& study) {
  const std::vector<diagnose::DrawnModel> nominal{{"nominal", &study.nominal()}};
  std::vector<diagnose::PageChart> charts = diagnose::tip_charts(study, nominal),
                                   curves = diagnose::curve_charts(study, nominal);
  std::move(curves.begin(), curves.end(), std::back_inserter(charts));
  constexpr std::size_t most = 12;
  if (charts.size() > most) charts.resize(most);
  return charts;
}

}  // namespace plumbline::app
