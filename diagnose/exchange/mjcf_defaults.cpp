#include "diagnose/exchange/mjcf_defaults.hpp"

#include <plumbline/base/error.hpp>
#include <utility>

#include "diagnose/exchange/xml_document.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using pugi::xml_attribute, pugi::xml_node;

constexpr const char* main_class = "";

std::string class_of(xml_node element) {
  if (const auto own = element.attribute("class")) return own.value();
  for (xml_node holder = element.parent(); holder; holder = holder.parent())
    if (const auto all = holder.attribute("childclass")) return all.value();
  return main_class;
}

std::string place(const std::string& file, xml_node element, const char* attribute) {
  return place_of(file, element) + ": " + attribute;
}

}  // namespace

MjcfDefaults::MjcfDefaults(xml_node root, std::string file) : file_(std::move(file)) {
  Class& main = classes_[main_class];
  for (const xml_node top : root.children("default")) {
    main.elements.push_back(top);
    for (const xml_node inner : top.children("default")) add(inner, main_class);
  }
  // The outermost may have a name too.
  for (const xml_node top : root.children("default"))
    if (const auto name = top.attribute("class")) classes_.try_emplace(name.value(), Class{main_class, {}});
  classes_.try_emplace("main", Class{main_class, {}});
}

void MjcfDefaults::add(xml_node element, const std::string& parent) {
  const std::string name = element.attribute("class").value();
  const auto [known, fresh] = classes_.try_emplace(name, Class{parent, {element}});
  if (!fresh)
    throw Error(file_, "the default class " + files::shown(name) + " twice", "a class for each name");
  for (const xml_node inner : element.children("default")) add(inner, name);
}

std::vector<xml_node> MjcfDefaults::inherited(xml_node element, const char* kind) const {
  std::vector<xml_node> all;
  for (std::string name = class_of(element);;) {
    const auto known = classes_.find(name);
    if (known == classes_.end())
      throw Error(place_of(file_, element), "the class " + files::shown(name), "a class that <default> has");
    for (const xml_node one : known->second.elements)
      for (const xml_node own : one.children(kind)) all.push_back(own);
    if (name == main_class) return all;
    name = known->second.parent;
  }
}

xml_attribute MjcfDefaults::attribute(xml_node element, const char* name) const {
  if (const auto own = element.attribute(name)) return own;
  for (const xml_node one : inherited(element, element.name()))
    if (const auto theirs = one.attribute(name)) return theirs;
  return {};
}

double MjcfDefaults::number(xml_node element, const char* name, double otherwise) const {
  return numbers(element, name, 1, 1, {otherwise}).front();
}

Eigen::Vector3d MjcfDefaults::vector(xml_node element, const char* name,
                                     const Eigen::Vector3d& otherwise) const {
  const xml_attribute said = attribute(element, name);
  return said ? vector_in(said.value(), place(file_, element, name)) : otherwise;
}

std::vector<double> MjcfDefaults::numbers(xml_node element, const char* name, std::size_t least,
                                          std::size_t most, std::vector<double> otherwise) const {
  const xml_attribute said = attribute(element, name);
  return said ? numbers_in(said.value(), place(file_, element, name), least, most) : std::move(otherwise);
}

}  // namespace plumbline::exchange
