#include "diagnose/exchange/xml_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <plumbline/base/error.hpp>
#include <sstream>
#include <utility>

#include "support/files/printable.hpp"

namespace plumbline::exchange {

using pugi::xml_node;

namespace {

/// Whether two texts are the same numbers, however written.
bool same_numbers(const std::string& a, const std::string& b) {
  std::istringstream one(a), other(b);
  std::vector<double> x{std::istream_iterator<double>(one), {}}, y{std::istream_iterator<double>(other), {}};
  if (x.empty() || x.size() != y.size() || !one.eof() || !other.eof()) return a == b;
  double largest = 0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  return std::equal(x.begin(), x.end(), y.begin(),
                    [&](double p, double q) { return std::abs(p - q) <= last_digit * largest; });
}

/// An entity may stand for a file, or for so much text that no memory holds it: none is read.
void refuse_entities(const pugi::xml_document& document, const std::string& file) {
  for (const xml_node child : document.children())
    if (child.type() == pugi::node_doctype &&
        std::string(child.value()).find("<!ENTITY") != std::string::npos)
      throw Error(file, "a document type that declares entities", "XML without any");
}

/// What walks through a model calls itself for every element in an element.
class Depth : public pugi::xml_tree_walker {
 public:
  explicit Depth(std::string file) : file_(std::move(file)) {}
  bool for_each(xml_node&) override {
    if (depth() > deepest_element)
      throw Error(file_, fmt::format("elements more than {} deep", deepest_element), "a shallower model");
    return true;
  }

 private:
  std::string file_;
};

}  // namespace

void parse(const std::string& text, const std::string& file, pugi::xml_document& document) {
  const auto read = document.load_buffer(text.data(), text.size(), pugi::parse_full, pugi::encoding_utf8);
  if (!read) {
    const auto line = 1 + std::count(text.begin(), text.begin() + read.offset, '\n');
    throw Error(fmt::format("{}:{}", file, line), "text that is not XML", "XML");
  }
  refuse_entities(document, file);
  Depth depth(file);
  document.traverse(depth);
}

void set(xml_node element, const char* attribute, const std::string& value) {
  if (!element.attribute(attribute)) element.append_attribute(attribute);
  if (!same_numbers(element.attribute(attribute).value(), value))
    element.attribute(attribute) = value.c_str();
}

void set_text(xml_node element, const std::string& text) {
  if (!same_numbers(element.text().get(), text)) element.text() = text.c_str();
}

void set_child(xml_node element, const char* child, const std::string& text) {
  xml_node own = element.child(child);
  if (!own) own = element.append_child(child);
  set_text(own, text);
}

std::string text_in(xml_node element, const char* child) {
  return element.child(child).text().get();
}

xml_node append(xml_node parent, const Xml& element) {
  const std::string text = element.text(0);
  parent.append_buffer(text.c_str(), text.size());
  return parent.last_child();
}

xml_node named(xml_node parent, const char* kind, const std::string& name) {
  return parent.find_child([&](const xml_node one) {
    return std::string(one.name()) == kind && one.attribute("name").value() == name;
  });
}

std::string place_of(const std::string& file, xml_node element) {
  const auto name = element.attribute("name");
  return name ? fmt::format("{}: <{} name=\"{}\">", file, element.name(), files::shown(name.value()))
              : fmt::format("{}: <{}>", file, files::shown(element.name()));
}

std::vector<double> numbers_in(const std::string& text, const std::string& place, std::size_t least,
                               std::size_t most) {
  std::istringstream in(text);
  std::vector<double> all;
  for (std::string word; in >> word;) {
    const char* const first = word.c_str() + (word[0] == '+' ? 1 : 0);
    const char* const last = word.c_str() + word.size();
    double value = NAN;
    const auto [end, failure] = std::from_chars(first, last, value);
    if (failure != std::errc() || end != last || !std::isfinite(value))
      throw Error(place, files::shown(word), "a number");
    all.push_back(value);
    if (all.size() > most) break;
  }
  if (all.size() < least || all.size() > most)
    throw Error(
        place,
        all.size() > most ? fmt::format("more than {} numbers", most) : fmt::format("{} numbers", all.size()),
        least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most));
  return all;
}

double number_in(const std::string& text, const std::string& place) {
  return numbers_in(text, place, 1, 1).front();
}

Eigen::Vector3d vector_in(const std::string& text, const std::string& place) {
  const std::vector<double> all = numbers_in(text, place, 3, 3);
  return {all[0], all[1], all[2]};
}

}  // namespace plumbline::exchange
