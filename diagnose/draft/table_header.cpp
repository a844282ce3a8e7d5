#include "diagnose/draft/table_header.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "diagnose/draft/cell.hpp"
#include "diagnose/draft/unit_words.hpp"

namespace plumbline::diagnose {
namespace {

bool is_unit_or_format(const std::string& field) {
  static const std::array quantities{&quantity::length,  &quantity::force, &quantity::angle,
                                     &quantity::time,    &quantity::mass,  &quantity::torque,
                                     &quantity::pressure};
  static const std::set<std::string> formats{"hh:mm:ss", "-", "v", "mv", "%", "hz", "[-]", "counts"};
  return formats.contains(folded(field)) || is_temperature_unit(field) || is_current_unit(field) ||
         std::any_of(quantities.begin(), quantities.end(),
                     [&](const Quantity* one) { return !unit_in(field, *one).empty(); });
}

/// Whether most of what stands in a line are units.
bool looks_like_units(const std::vector<std::string>& fields) {
  std::size_t said = 0, units = 0;
  for (const std::string& field : fields) {
    if (field.empty()) continue;
    ++said;
    if (is_unit_or_format(field)) ++units;
  }
  return said > 0 && 2 * units >= said;
}

/// Whether names of columns may stand there: of all, of all but the last, or of some without a value too.
bool names_columns(const std::vector<std::string>& fields, const Cut& cut) {
  const std::size_t least = std::max<std::size_t>(cut.columns - 1, 2),  // a single word is a title
      without_value = cut.delimiter == ' ' ? 0 : 3;
  return fields.size() >= least && fields.size() <= cut.columns + without_value &&
         !is_row(fields, cut.decimal);
}

bool repeat(const std::vector<std::string>& words) {
  std::set<std::string> seen;
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return !word.empty() && !seen.insert(word).second; });
}

}  // namespace

TableHeader table_header(const std::vector<Line>& lines, const Cut& cut) {
  TableHeader header;
  std::vector<std::size_t> above;
  for (std::size_t l = 0; l < cut.first_row; ++l)
    if (!lines[l].comment && names_columns(fields_of(lines[l].text, cut.delimiter), cut)) above.push_back(l);
  if (above.empty()) return header;
  const auto fields = [&](std::size_t l) {
    std::vector<std::string> all = fields_of(lines[l].text, cut.delimiter);
    all.resize(std::max(all.size(), cut.columns));
    return all;
  };
  if (above.size() > 1 && looks_like_units(fields(above.back())))
    header.units = above.back(), above.pop_back();
  header.names = above.back();
  header.words = fields(above.back());
  for (above.pop_back(); repeat(header.words) && !above.empty(); above.pop_back()) {
    const std::vector<std::string> more = fields(above.back());
    for (std::size_t c = 0; c < header.words.size() && c < more.size(); ++c)
      if (!more[c].empty()) header.words[c] = more[c] + " " + header.words[c];
    header.several_lines = true;
  }
  return header;
}

}  // namespace plumbline::diagnose
