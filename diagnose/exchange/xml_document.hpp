#pragma once
/// \file
/// XML of somebody's, to be read.

#include <Eigen/Core>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "diagnose/exchange/xml.hpp"

namespace plumbline::exchange {

/// Elements of a model stand in each other no deeper than this.
constexpr int deepest_element = 2000;

/// \param file  named in errors
/// \throws Error where the text is no XML, declares entities, or is deeper than `deepest_element`
void parse(const std::string& text, const std::string& file, pugi::xml_document& document);

/// Sets an attribute, the text of an element, or of a child, there already or not. Numbers that the file has
/// already stay as it writes them.
void set(pugi::xml_node element, const char* attribute, const std::string& value);
void set_text(pugi::xml_node element, const std::string& text);
void set_child(pugi::xml_node element, const char* child, const std::string& text);

/// The text of a child; empty where it is not there.
std::string text_in(pugi::xml_node element, const char* child);

pugi::xml_node append(pugi::xml_node parent, const Xml& element);

/// The child of such a name= ; or none.
pugi::xml_node named(pugi::xml_node parent, const char* kind, const std::string& name);

/// An element as errors call it: `arm.xml: <joint name="hip">`.
std::string place_of(const std::string& file, pugi::xml_node element);

/// Numbers between blanks.
/// \throws Error at the place where one is no finite number, or there are fewer or more than said
std::vector<double> numbers_in(const std::string& text, const std::string& place, std::size_t least,
                               std::size_t most);
double number_in(const std::string& text, const std::string& place);
Eigen::Vector3d vector_in(const std::string& text, const std::string& place);

}  // namespace plumbline::exchange
