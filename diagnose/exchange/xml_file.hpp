#pragma once
/// \file
/// A file of XML to be edited: what is not touched stays byte by byte.

#include <cstddef>
#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace plumbline::exchange {

class XmlFile {
 public:
  /// \throws Error as parse() does
  explicit XmlFile(const std::filesystem::path& file);

  /// To be read and edited.
  pugi::xml_document document;

  /// The file with the edits in it. Values that change are replaced in their places; elements that were added
  /// stand in lines of their own, indented like their neighbours.
  /// \param lines  of a comment before the root
  [[nodiscard]] std::string text(const std::vector<std::string>& lines) const;

 private:
  /// Bytes of the source, from first to before last.
  struct Span {
    std::size_t first, last;
  };
  struct Attribute {
    std::string name, value;  ///< as parsed
    Span all, quoted;         ///< with the blanks before it; between its quotes
  };
  /// A node as the file has it.
  struct Origin {
    Span all, name = {}, tag = {};  ///< of an element: its name, and its start tag
    Span closing = {};              ///< its end tag; empty where there is none
    std::string value = {};         ///< as parsed
    std::vector<Attribute> attributes = {};
    std::vector<pugi::xml_node> children = {};
  };

  Span register_node(pugi::xml_node node);
  void register_children(pugi::xml_node parent, Origin& origin);
  Origin element(pugi::xml_node node, std::size_t first);
  [[nodiscard]] Attribute attribute_at(std::size_t& at) const;
  [[nodiscard]] std::size_t after(const char* mark, std::size_t from) const;

  [[nodiscard]] std::string written(pugi::xml_node node, const std::string& indent) const;
  [[nodiscard]] std::string start_tag(pugi::xml_node node, const Origin& origin) const;
  [[nodiscard]] std::string content(pugi::xml_node node, const Origin& origin) const;
  [[nodiscard]] std::string added(pugi::xml_node node, const std::string& indent) const;
  [[nodiscard]] bool begins_its_line(std::size_t at) const;
  [[nodiscard]] std::string indent_before(std::size_t at) const;
  [[nodiscard]] std::string indent_of_children(const Origin& origin) const;
  [[nodiscard]] std::string bytes(Span span) const {
    return source_.substr(span.first, span.last - span.first);
  }

  std::string source_, line_end_;
  std::map<pugi::xml_node, Origin> origins_;
};

}  // namespace plumbline::exchange
