#include "verify/judging/premises.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <plumbline/chain/kinematics.hpp>

#include "proofs/exact/decimal.hpp"
#include "statement/chain_file.hpp"
#include "verify/judging/formula_value.hpp"

namespace plumbline::verify {
namespace {

const Printed& part(const Premise& premise, const std::string& name) {
  const auto found = premise.parts.find(name);
  if (found == premise.parts.end()) throw Error("premise " + premise.id, "no " + name, "one");
  return found->second;
}

Rational fraction(const std::string& text, const std::string& id) {
  if (const auto decimal = proofs::parse_decimal(text)) return *decimal;
  if (text.find_first_not_of("-0123456789/") != std::string::npos)
    throw Error("premise " + id, "'" + text + "'", "a fraction");
  return Rational(text);
}

template <class Read>
auto numbers(const Printed& texts, const Read& read) {
  std::vector<decltype(read(texts.front()))> list;
  list.reserve(texts.size());
  for (const std::string& text : texts) list.push_back(read(text));
  return list;
}

}  // namespace

const Premise& Premises::at(const std::string& id) const {
  const auto found = std::find_if(list_.begin(), list_.end(), [&](const Premise& p) { return p.id == id; });
  if (found == list_.end()) throw Error("claim", "no premise " + id, "one among its `given`");
  return *found;
}

statement::PlaneChain Premises::stated(const std::string& id) const {
  const auto file = at(id).parts.find("chain");
  if (file == at(id).parts.end()) throw Error("premise " + id, "no chain file", "its text as `chain`");
  return statement::parse_plane_chain(file->second.front(), "premise " + id);
}

bool Premises::has_structure(const std::string& id) const {
  return at(id).parts.contains("chain") && !stated(id).plain;
}

Premise Premises::guided(const std::string& id) const {
  const Premise& premise = at(id);
  if (!premise.parts.contains("chain")) return premise;
  if (has_structure(id))
    throw Error("premise " + id, "a chain file with ends, supports, loads or masses of its own",
                "one without, for this check: its end point is guided, and compressed");
  Premise guided{premise.id, premise.where, premise.quote, {}};
  const auto in_text = [](const std::vector<Rational>& numbers) {
    Printed list;
    for (const Rational& number : numbers) list.push_back(number.str());
    return list;
  };
  const Chain<Rational> chain = stated(id).structure.chain;
  guided.parts = {{"length", in_text(chain.length())},
                  {"stiffness", in_text(chain.stiffness())},
                  {"rest", in_text(chain.rest())}};
  return guided;
}

Chain<Interval> Premises::chain(const std::string& id) const {
  const Premise p = guided(id);
  return Chain<Interval>(numbers(part(p, "length"), number), numbers(part(p, "stiffness"), number),
                         numbers(part(p, "rest"), number));
}

Chain<Rational> Premises::exact_chain(const std::string& id) const {
  const Premise p = guided(id);
  const auto read = [&](const std::string& text) { return fraction(text, id); };
  return Chain<Rational>(numbers(part(p, "length"), read), numbers(part(p, "stiffness"), read),
                         numbers(part(p, "rest"), read));
}

Interval Premises::reach(const std::string& id) const {
  const Premise& p = at(id);
  if (p.parts.contains("end")) return number(part(p, "end").front());
  const Chain<Interval> at_rest = chain(id);
  const Point<Interval> end = end_point(at_rest, at_rest.rest());
  return sqrt(sqr(end.x) + sqr(end.y));
}

Interval Premises::value(const std::string& id) const {
  return number(part(at(id), "value").front());
}

Rational Premises::exact(const std::string& id) const {
  return fraction(part(at(id), "value").front(), id);
}

}  // namespace plumbline::verify
