#include "diagnose/exchange/xml_document.hpp"

#include <iterator>
#include <plumbline/base/error.hpp>
#include <sstream>

#include "support/files/text_file.hpp"

namespace plumbline::exchange {

using pugi::xml_node;

void parse(const std::filesystem::path& file, pugi::xml_document& document) {
  const std::string text = files::read_text(file);
  const auto read = document.load_string(text.c_str(), pugi::parse_full);
  if (!read) throw Error(file.string(), read.description(), "XML");
}

void set(xml_node element, const char* attribute, const std::string& value) {
  if (!element.attribute(attribute)) element.append_attribute(attribute);
  element.attribute(attribute) = value.c_str();
}

void set_child(xml_node element, const char* child, const std::string& text) {
  xml_node own = element.child(child);
  if (!own) own = element.append_child(child);
  own.text() = text.c_str();
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

std::vector<double> numbers_in(const char* text) {
  std::istringstream in(text);
  return {std::istream_iterator<double>(in), {}};
}

std::string text_of(pugi::xml_document& document, const std::vector<std::string>& lines) {
  document.insert_child_before(pugi::node_comment, document.document_element())
      .set_value(comment(lines).c_str());
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace plumbline::exchange
