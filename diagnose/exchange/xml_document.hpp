#pragma once
/// \file
/// XML of somebody's, to be read or edited: what is not touched stays as it stands.

#include <Eigen/Core>
#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "diagnose/exchange/xml.hpp"

namespace plumbline::exchange {

/// Elements of a model stand in each other no deeper than this.
constexpr int deepest_element = 2000;

/// \throws Error where the file is no XML, declares entities, or is deeper than `deepest_element`
void parse(const std::filesystem::path& file, pugi::xml_document& document);

/// Sets an attribute, or the text of a child, there already or not.
void set(pugi::xml_node element, const char* attribute, const std::string& value);
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

/// The file, with these lines as a comment before the root.
std::string text_of(pugi::xml_document& document, const std::vector<std::string>& lines);

}  // namespace plumbline::exchange
