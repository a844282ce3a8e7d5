#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "support/page/formula.hpp"
#include "support/page/markup.hpp"
#include "verify/report/errata.hpp"
#include "verify/report/markup.hpp"
#include "verify/report/page_texts.hpp"
#include "verify/report/report.hpp"

namespace plumbline::verify {
namespace {

using Json = nlohmann::ordered_json;

/// A drawing as part of an address, what an attribute cannot hold escaped.
std::string in_address(const std::string& svg) {
  std::string address;
  for (const char c : svg) {
    if (std::string_view("%#<\"&").find(c) != std::string_view::npos)
      address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      address += c;
  }
  return address;
}

/// The anchor of a heading.
std::string anchor(const std::string& heading) {
  std::string text;
  for (const char c : heading)
    text += c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The left sides of a quote's equations, "F(q) = " of "F(q) = 2k; Δ = 0", where it has as many as are
/// printed.
std::vector<std::string> left_sides(const std::string& quote, std::size_t printed) {
  std::vector<std::string> sides;
  std::istringstream equations(quote);
  for (std::string one; std::getline(equations, one, ';');) {
    const std::size_t equals = one.find(" = ");
    if (equals != std::string::npos) sides.push_back(one.substr(one.find_first_not_of(' '), equals) + " = ");
  }
  return sides.size() == printed ? sides : std::vector<std::string>(printed);
}

/// The printed formulas, set, with their left sides, or as sides of equations; none where a part is no
/// formula.
Json formulas(const Claim& claim, const Printed& printed) {
  const bool sides_of_equations = claim.stated.with.contains("up to");
  const std::vector<std::string> sides = left_sides(sides_of_equations ? "" : claim.quote, printed.size());
  Json list = Json::array();
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const auto set = page::as_mathml(printed[i]);
    if (!set) return Json::array();
    list.push_back({{"left", sides[i]}, {"set", *set}, {"right", sides_of_equations ? " = 0" : ""}});
  }
  return list;
}

/// Whether an erratum has this claim.
bool in_an_erratum(const Paper& paper, const std::string& cause) {
  return std::any_of(paper.errata.begin(), paper.errata.end(),
                     [&](const Erratum& one) { return one.id == cause; });
}

/// One claim of the report, with what its card shows besides.
Json card(const Paper& paper, const Json& report, const Judged& judged) {
  const Claim& claim = judged.claim;
  const Printed& print = report["favoured"].empty() ? claim.printed : judged.judgement->favoured;
  Json view = report;
  for (const std::string key : {"quote", "truth", "value"}) view["has_" + key] = report[key] != "";
  view["has_evidence"] = !report["evidence"].empty();
  view["has_also"] = !claim.also.empty();
  view["others"] = fmt::format("{}", fmt::join(claim.also, "; "));
  view["charitable"] = claim.charitable;
  view["has_severity"] = !report["severity"].is_null();
  view["has_erratum"] = in_an_erratum(paper, claim.cause);
  view["has_print"] = !claim.printed.empty();
  view["print"] = fmt::format("{}", fmt::join(print, " | "));
  view["formulas"] = formulas(claim, print);
  view["has_formulas"] = !view["formulas"].empty();
  view["has_check"] = !claim.source.file.empty();
  view["check_line"] = std::to_string(claim.source.line);
  std::vector<std::string> kinds;
  for (std::size_t i = 0; i < report["evidence"].size(); ++i) {
    Json& one = view["evidence"][i];
    one["place"] = std::to_string(i);
    one["has_theorem"] = one.contains("theorem");
    if (one.contains("theorem")) one["anchor"] = anchor(one["theorem"].get<std::string>());
    one["has_coq"] = one.contains("coq");
    if (one.contains("coq"))
      one["checked"] = fmt::format("{}", fmt::join(one["coq"].get<std::vector<std::string>>(), ", "));
    const auto kind = report["evidence"][i]["kind"].get<std::string>();
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  view["kinds"] = fmt::format("{}", fmt::join(kinds, ", "));
  return view;
}

Json sections(const Paper& paper, const std::vector<Judged>& judged, const Json& report) {
  Json list = Json::array();
  std::string section;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    if (list.empty() || section_of(judged[i].claim) != section) {
      section = section_of(judged[i].claim);
      const std::string title = paper.section_title(section);
      list.push_back({{"number", std::to_string(list.size() + 1)},
                      {"heading", title.empty() ? "Properties " + section : section + " " + title},
                      {"claims", Json::array()}});
    }
    list.back()["claims"].push_back(card(paper, report[i], judged[i]));
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

Json corrections(const Paper& paper, const std::vector<Judged>& judged) {
  const Errata found = errata(paper, judged);
  Json list = Json::array();
  for (const JudgedErratum& one : found.items) {
    Json claims = Json::array(), pairs = Json::array(), reason = Json::array();
    for (const Judged& j : one.claims) claims.push_back(j.claim.id);
    for (const Correction& each : one.corrections)
      pairs.push_back({{"where", place_of(paper.claim(each.claim))},
                       {"printed", as_plain(each.printed)},
                       {"read", as_plain(each.read)}});
    for (const std::string& each : one.reason) reason.push_back(as_plain(each));
    list.push_back({{"id", one.id},
                    {"severity", std::string(name(one.severity)) + (one.remark ? ", a remark" : "")},
                    {"claims", std::move(claims)},
                    {"corrections", std::move(pairs)},
                    {"reason", std::move(reason)}});
  }
  return {{"any", !found.items.empty()}, {"count", count_of(found)}, {"list", std::move(list)}};
}

Json reference(const Paper& paper) {
  return {{"authors", paper.authors},      {"title", paper.title}, {"journal", paper.journal},
          {"has_doi", !paper.doi.empty()}, {"doi", paper.doi},     {"has_preprint", !paper.preprint.empty()},
          {"preprint", paper.preprint},    {"read", paper.read}};
}

Json gallery(const std::vector<DrawnFigure>& figures) {
  Json list = Json::array();
  for (const DrawnFigure& one : figures) {
    Json verdicts = Json::array();
    for (const auto& [verdict, ids] : one.verdicts) verdicts.push_back({{"verdict", verdict}, {"ids", ids}});
    list.push_back({{"number", std::to_string(one.number)},
                    {"title", one.title},
                    {"verdicts", std::move(verdicts)},
                    {"image", in_address(one.svg)}});
  }
  const bool any = !list.empty();
  return {{"any", any}, {"list", std::move(list)}};
}

}  // namespace

std::string as_html(const Paper& paper, const std::vector<Judged>& judged,
                    const std::vector<DrawnFigure>& figures) {
  const Json report = as_json(judged);
  return page::document(paper.title + ": the claims, judged",
                        "Every claim of the paper with its verdict and the evidence",
                        page::filled(claims_template, {{"total", std::to_string(judged.size())},
                                                       {"paper", reference(paper)},
                                                       {"proofs_checked", proofs_checked()},
                                                       {"confirmed", confirmed_by_name(judged)},
                                                       {"counts", counts(report)},
                                                       {"sections", sections(paper, judged, report)},
                                                       {"errata", corrections(paper, judged)},
                                                       {"figures", gallery(figures)}}));
}

}  // namespace plumbline::verify
