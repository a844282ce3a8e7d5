#include "diagnose/exchange/xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::exchange {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&apos;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

namespace {

/// A comment ends with two hyphens, and must not have them inside.
std::string in_comment(std::string line) {
  for (std::size_t at = 0; (at = line.find("--", at)) != std::string::npos;) line.replace(at, 2, "- -");
  return line;
}

}  // namespace

std::string number(double value) {
  return fmt::format("{:.15g}", value);
}

std::string numbers(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : " ") + number(std::abs(value) > last_digit * largest ? value : 0);
  return text;
}

std::string numbers_of(const Eigen::Vector3d& vector) {
  return numbers({vector.x(), vector.y(), vector.z()});
}

Xml& Xml::set(const std::string& key, const std::string& value) {
  const auto same = std::find_if(attributes_.begin(), attributes_.end(),
                                 [&](const auto& attribute) { return attribute.first == key; });
  if (same != attributes_.end()) {
    same->second = value;
  } else {
    attributes_.emplace_back(key, value);
  }
  return *this;
}

std::string Xml::text(std::size_t depth) const {
  const std::string indent(2 * depth, ' ');
  std::string result = indent + "<" + name_;
  for (const auto& [key, value] : attributes_) result += " " + key + "=\"" + escaped(value) + "\"";
  if (children_.empty() && text_.empty()) return result + "/>\n";
  if (children_.empty()) return result + ">" + escaped(text_) + "</" + name_ + ">\n";
  result += ">\n";
  for (const Xml& child : children_) result += child.text(depth + 1);
  return result + indent + "</" + name_ + ">\n";
}

std::string comment(const std::vector<std::string>& lines, const std::string& line_end) {
  std::string result = line_end;
  for (const std::string& line : lines) result += "  " + in_comment(line) + line_end;
  return result;
}

std::string document(const std::vector<std::string>& lines, const Xml& root) {
  return "<?xml version=\"1.0\"?>\n<!--" + comment(lines) + "-->\n" + root.text(0);
}

}  // namespace plumbline::exchange
