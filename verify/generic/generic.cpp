#include "verify/generic/generic.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

namespace plumbline::verify {
namespace {

using Kind = Judgement (*)(const Parameters&, const Printed&, const Premises&, int);

struct NamedKind {
  std::string_view name, file;
  Kind judge;
};

constexpr NamedKind kinds[] = {
    {"formula", "formula", generic::formula},
    {"value", "values", generic::value},
    {"sign", "values", generic::sign},
    {"names", "values", generic::names},
    {"modes", "straight", generic::modes},
    {"post-buckling", "straight", generic::post_buckling},
    {"closed form", "straight", generic::closed_form},
    {"stability", "straight", generic::stability},
    {"critical", "structures", generic::critical},
    {"equilibria", "equilibria", generic::equilibria},
    {"path", "path", generic::path},
    {"event", "path", generic::event},
};

const NamedKind* find(const std::string& name) {
  const auto* const found = std::find_if(std::begin(kinds), std::end(kinds),
                                         [&](const NamedKind& kind) { return kind.name == name; });
  return found == std::end(kinds) ? nullptr : found;
}

}  // namespace

Printed Parameters::list(const std::string& name) const {
  const auto found = stated_.with.find(name);
  return found == stated_.with.end() ? Printed{} : found->second;
}

std::string Parameters::text(const std::string& name) const {
  const Printed entries = list(name);
  if (entries.size() != 1) wrong(fmt::format("{} texts as '{}'", entries.size(), name), "one");
  return entries.front();
}

std::string Parameters::text(const std::string& name, const std::string& otherwise) const {
  return has(name) ? text(name) : otherwise;
}

void Parameters::known(const std::vector<std::string>& names) const {
  for (const auto& [name, entries] : stated_.with) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      wrong("the parameter '" + name + "'", fmt::format("{}", fmt::join(names, ", ")));
  }
}

void Parameters::wrong(const std::string& found, const std::string& expected) const {
  throw Error(stated_.place, found, expected);
}

Check generic_check(const StatedCheck& stated) {
  const NamedKind* const kind = find(stated.kind);
  if (kind == nullptr) {
    std::vector<std::string_view> names;
    for (const NamedKind& one : kinds) names.push_back(one.name);
    throw Error(stated.place, "the check '" + stated.kind + "'", fmt::format("{}", fmt::join(names, ", ")));
  }
  return Check([stated, judge = kind->judge](const Printed& printed, const Premises& given, int digits) {
    return judge(Parameters(stated), printed, given, digits);
  });
}

}  // namespace plumbline::verify
