#include "diagnose/rig/formula.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <numbers>
#include <plumbline/base/error.hpp>

#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

constexpr std::size_t longest_text = 1000;

mu::Parser parser() {
  mu::Parser one;
  one.DefineConst("pi", std::numbers::pi);
  return one;
}

/// A single "=" would let an expression change its variables.
bool assigns(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) {
      return true;
    }
  }
  return false;
}

}  // namespace

struct Formula::Machine {
  mu::Parser parser;
  std::vector<double> value;
  std::vector<std::string> used;
};

Formula::Formula(const std::string& text, const std::vector<std::string>& names, const std::string& place)
    : machine_(std::make_unique<Machine>()) {
  if (text.size() > longest_text)
    throw Error(place, fmt::format("{} characters", text.size()),
                fmt::format("an expression of at most {}", longest_text));
  const std::string found = "\"" + files::shown(text) + "\"";
  if (assigns(text)) throw Error(place, found + " with a single =", "an expression that sets nothing");
  mu::Parser& parse = machine_->parser = parser();
  machine_->value.resize(names.size());
  try {
    for (std::size_t i = 0; i < names.size(); ++i) parse.DefineVar(names[i], &machine_->value[i]);
    parse.SetExpr(text);
    for (const auto& [name, address] : parse.GetUsedVar()) machine_->used.push_back(name);
    for (const std::string& name : machine_->used) {
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      throw Error(place, fmt::format("the unknown name \"{}\" in {}", files::shown(name), found),
                  fmt::format("{} and functions such as sin", fmt::join(names, ", ")));
    }
    static_cast<void>(parse.Eval());
  } catch (const mu::ParserError& error) {
    std::string why = files::printable(error.GetMsg());
    while (!why.empty() && (why.back() == '.' || why.back() == '\n')) why.pop_back();
    throw Error(place, found + " (" + why + ")", "an expression such as \"c * sin(d)^3\"");
  }
  if (parse.GetNumResults() != 1) throw Error(place, found + ", a list", "one expression");
}

Formula::~Formula() = default;

bool Formula::uses(std::string_view name) const {
  return std::find(machine_->used.begin(), machine_->used.end(), name) != machine_->used.end();
}

double Formula::at(std::span<const double> first, std::span<const double> others) const {
  std::copy(others.begin(), others.end(), std::copy(first.begin(), first.end(), machine_->value.begin()));
  return machine_->parser.Eval();
}

bool can_be_named(const std::string& name) {
  const auto letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (name.empty() || name.size() > 40 || std::isalpha(static_cast<unsigned char>(name[0])) == 0 ||
      !std::all_of(name.begin(), name.end(), letter))
    return false;
  const mu::Parser known = parser();
  return known.GetFunDef().count(name) == 0 && known.GetConst().count(name) == 0;
}

}  // namespace plumbline::diagnose
