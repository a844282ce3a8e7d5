#include "support/page/compact_svg.hpp"

#include <fmt/format.h>

#include <map>
#include <plumbline/base/error.hpp>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "support/page/compact_line.hpp"

namespace plumbline::page {
namespace {

using pugi::xml_attribute;
using pugi::xml_node;

std::vector<xml_node> children(const xml_node& node) {
  return {node.begin(), node.end()};
}

bool is(const xml_node& node, std::string_view name) {
  return node.name() == name;
}

/// What a style sheet may say as well; an element without one has its parent's.
const std::set<std::string> looks{
    "color",      "fill", "stroke", "stroke-width", "stroke-linecap", "stroke-linejoin", "stroke-dasharray",
    "text-anchor"};

// --- what is not seen

void remove_titles(xml_node node) {
  for (xml_node child : children(node)) {
    if (is(child, "title") || is(child, "desc") || child.type() == pugi::node_comment)
      node.remove_child(child);
    else
      remove_titles(child);
  }
}

/// Symbols that nothing uses, and then those that only they used.
void remove_unused(xml_node svg) {
  xml_node definitions = svg.child("defs");
  for (bool again = true; again;) {
    again = false;
    std::set<std::string> used;
    for (const pugi::xpath_node& one : svg.select_nodes("//use"))
      used.insert(one.node().attribute("xlink:href").as_string());
    for (xml_node one : children(definitions)) {
      if (used.contains(std::string("#") + one.attribute("id").value())) continue;
      definitions.remove_child(one);
      again = true;
    }
  }
  if (definitions.empty() || !definitions.first_child()) svg.remove_child(definitions);
}

// --- attributes

/// Gives the elements of a group its attributes, where they have none of their own, and takes its place.
void dissolve(xml_node group) {
  xml_node parent = group.parent();
  for (xml_node child : children(group)) {
    if (child.type() != pugi::node_element) continue;
    for (const xml_attribute attribute : group.attributes()) {
      const std::string name = attribute.name();
      if (name == "id") continue;
      if (name == "transform" && child.attribute("transform"))
        child.attribute("transform") =
            fmt::format("{} {}", attribute.value(), child.attribute("transform").value()).c_str();
      else if (!child.attribute(name.c_str()))
        child.append_attribute(name.c_str()) = attribute.value();
    }
    parent.insert_move_before(child, group);
  }
  parent.remove_child(group);
}

void dissolve_groups(xml_node node) {
  for (xml_node child : children(node)) {
    if (is(child, "defs")) continue;
    dissolve_groups(child);
    if (is(child, "g")) dissolve(child);
  }
}

/// A number without idle digits; any other value as it is.
std::string plain(const std::string& value) {
  std::size_t end = 0;
  try {
    const double number = std::stod(value, &end);
    return end == value.size() ? fmt::format("{:.6g}", number) : value;
  } catch (const std::exception&) {
    return value;
  }
}

/// Without the attributes that have no effect; `inherited` is what holds where the element says nothing.
void drop_idle(xml_node node, std::map<std::string, std::string> inherited) {
  node.remove_attribute("class");
  const std::string colour = node.attribute("color").as_string("black");
  if (!is(node, "use")) {
    for (xml_attribute attribute : node.attributes())
      if (std::string_view(attribute.value()) == "currentColor") attribute = colour.c_str();
    node.remove_attribute("color");
  }
  if (node.attribute("stroke").as_string() == std::string_view("none")) {
    for (const char* const name : {"stroke", "stroke-width"}) node.remove_attribute(name);
  }
  for (xml_attribute attribute = node.first_attribute(); attribute;) {
    const xml_attribute next = attribute.next_attribute();
    attribute = plain(attribute.value()).c_str();
    const auto before = inherited.find(attribute.name());
    if (before != inherited.end() && before->second == attribute.value())
      node.remove_attribute(attribute);
    else if (before != inherited.end() || looks.contains(attribute.name()))
      inherited[attribute.name()] = attribute.value();
    attribute = next;
  }
  for (const xml_node child : node.children()) drop_idle(child, inherited);
}

/// A text at its place, without marks that say nothing.
void set_text(xml_node text) {
  std::istringstream place(text.attribute("transform").value());
  char comma = 0, bracket = 0;
  double x = 0, y = 0;
  if (place.ignore(10, '(') && place >> x >> comma >> y >> bracket && (place >> std::ws).eof()) {
    text.remove_attribute("transform");
    text.append_attribute("x") = fmt::format("{:.5g}", x).c_str();
    text.append_attribute("y") = fmt::format("{:.5g}", y).c_str();
  }
  for (xml_node part : children(text)) {
    if (!is(part, "tspan") || part.first_attribute()) continue;
    for (const xml_node inner : children(part)) text.insert_move_before(inner, part);
    text.remove_child(part);
  }
}

/// What an element looks like, as declarations; they are taken from it.
std::string taken_style(xml_node node) {
  std::string style;
  for (const std::string& name : looks) {
    if (const xml_attribute attribute = node.attribute(name.c_str())) {
      std::string value = attribute.value();
      std::erase(value, ' ');
      style += name + ":" + value + ";";
      node.remove_attribute(attribute);
    }
  }
  return style;
}

// --- the whole

bool same_but_for_line(const xml_node& a, const xml_node& b) {
  const auto others = [](const xml_node& node) {
    std::map<std::string, std::string> found;
    for (const xml_attribute attribute : node.attributes()) found[attribute.name()] = attribute.value();
    found.erase("d");
    return found;
  };
  return others(a) == others(b);
}

/// Every look once, as a class, in a style sheet at the head.
void name_looks(xml_node svg) {
  std::map<std::string, std::string> classes;
  std::string sheet;
  for (xml_node node : children(svg)) {
    if (is(node, "defs")) continue;
    const std::string style = taken_style(node);
    if (style.empty()) continue;
    const auto [known, is_new] = classes.emplace(style, fmt::format("a{}", classes.size()));
    if (is_new) sheet += fmt::format(".{}{{{}}}", known->second, style.substr(0, style.size() - 1));
    node.append_attribute("class") = known->second.c_str();
  }
  svg.prepend_child("style").text() = sheet.c_str();
}

/// Neighbours that differ by their lines alone become one path.
void join_paths(xml_node svg) {
  for (xml_node node = svg.first_child(); node; node = node.next_sibling()) {
    if (!is(node, "path")) continue;
    std::string line = node.attribute("d").value();
    for (xml_node next = node.next_sibling(); is(next, "path") && same_but_for_line(node, next);
         next = node.next_sibling()) {
      line += next.attribute("d").value();
      svg.remove_child(next);
    }
    node.attribute("d") = compact_line(line).c_str();
  }
}

}  // namespace

std::string compact_svg(const std::string& text) {
  pugi::xml_document document;
  const pugi::xml_parse_result read =
      document.load_string(text.c_str(), pugi::parse_default | pugi::parse_ws_pcdata_single);
  if (!read) throw Error("drawing", read.description(), "SVG");
  xml_node svg = document.child("svg");
  remove_titles(svg);
  dissolve_groups(svg);
  remove_unused(svg);
  // what holds where nothing else is said
  const std::map<std::string, std::string> defaults{{"stroke-width", "1"},        {"stroke-linecap", "butt"},
                                                    {"stroke-linejoin", "miter"}, {"text-anchor", "start"},
                                                    {"font-family", "Helvetica"}, {"font-size", "12"}};
  for (const char* const name : {"font-family", "font-size"})
    svg.append_attribute(name) = defaults.at(name).c_str();
  for (xml_node node : children(svg)) {
    if (is(node, "defs")) continue;
    drop_idle(node, defaults);
    if (is(node, "text")) set_text(node);
  }
  name_looks(svg);
  join_paths(svg);
  std::ostringstream result;
  document.save(result, "",
                pugi::format_raw | pugi::format_attribute_single_quote | pugi::format_no_declaration,
                pugi::encoding_utf8);
  return result.str();
}

}  // namespace plumbline::page
