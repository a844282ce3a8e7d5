#pragma once
/// \file
/// XML of somebody's, to be edited: what is not touched stays as it stands.

#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "diagnose/exchange/xml.hpp"

namespace plumbline::exchange {

/// \throws Error where the file is no XML
void parse(const std::filesystem::path& file, pugi::xml_document& document);

/// Sets an attribute, or the text of a child, there already or not.
void set(pugi::xml_node element, const char* attribute, const std::string& value);
void set_child(pugi::xml_node element, const char* child, const std::string& text);

pugi::xml_node append(pugi::xml_node parent, const Xml& element);

/// The child of such a name= ; or none.
pugi::xml_node named(pugi::xml_node parent, const char* kind, const std::string& name);

/// Numbers between blanks.
std::vector<double> numbers_in(const char* text);

/// The file, with these lines as a comment before the root.
std::string text_of(pugi::xml_document& document, const std::vector<std::string>& lines);

}  // namespace plumbline::exchange
