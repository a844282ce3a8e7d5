#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cctype>

#include "page/markup.hpp"
#include "verify/report/page_texts.hpp"
#include "verify/report/report.hpp"

namespace plumbline::verify {
namespace {

using Json = nlohmann::ordered_json;

std::string in_base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

/// One claim of the report, with what its card shows besides.
Json card(const Json& report, const Printed& printed) {
  Json view = report;
  view["has_truth"] = !report["truth"].get<std::string>().empty();
  view["has_value"] = !report["value"].get<std::string>().empty();
  view["has_evidence"] = !report["evidence"].empty();
  view["has_print"] = !printed.empty();
  view["printed"] = fmt::format("{}", fmt::join(printed, " | "));
  std::vector<std::string> kinds;
  for (std::size_t i = 0; i < report["evidence"].size(); ++i) {
    view["evidence"][i]["place"] = std::to_string(i);
    const auto kind = report["evidence"][i]["kind"].get<std::string>();
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  view["kinds"] = fmt::format("{}", fmt::join(kinds, ", "));
  return view;
}

Json sections(const std::vector<Judged>& judged, const Json& report) {
  Json list = Json::array();
  std::string section;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    if (list.empty() || section_of(judged[i].claim) != section) {
      section = section_of(judged[i].claim);
      const bool of_paper = std::isdigit(static_cast<unsigned char>(section[0])) != 0;
      list.push_back({{"number", std::to_string(list.size() + 1)},
                      {"heading", (of_paper ? "Section " : "Properties ") + section},
                      {"claims", Json::array()}});
    }
    list.back()["claims"].push_back(card(report[i], judged[i].claim.printed));
  }
  return list;
}

/// How many claims have each verdict that occurs.
Json counts(const Json& report) {
  Json list = Json::array();
  for (const std::string verdict : {"confirmed", "refuted", "imprecise", "convention", "unjudged"}) {
    const auto count = std::count_if(report.begin(), report.end(), [&](const Json& claim) {
      return claim["verdict"].get_ref<const std::string&>() == verdict;
    });
    if (count > 0) list.push_back({{"verdict", verdict}, {"count", std::to_string(count)}, {"last", false}});
  }
  if (!list.empty()) list.back()["last"] = true;
  return list;
}

Json gallery(const std::vector<DrawnFigure>& figures) {
  Json list = Json::array();
  for (const DrawnFigure& one : figures) {
    list.push_back({{"number", std::to_string(one.number)},
                    {"title", one.title},
                    {"sentence", one.sentence},
                    {"image", in_base64(one.svg)}});
  }
  const bool any = !list.empty();
  return {{"any", any}, {"list", std::move(list)}};
}

}  // namespace

std::string as_html(const std::vector<Judged>& judged, const std::vector<DrawnFigure>& figures) {
  const Json report = as_json(judged);
  return page::document("The claims, judged", "Every claim of the paper with its verdict and the evidence",
                        page::filled(claims_template, {{"total", std::to_string(judged.size())},
                                                       {"counts", counts(report)},
                                                       {"sections", sections(judged, report)},
                                                       {"figures", gallery(figures)}}));
}

}  // namespace plumbline::verify
