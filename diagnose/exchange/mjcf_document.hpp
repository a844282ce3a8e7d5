#pragma once
/// \file
/// A user's own MJCF, to be edited: what is not touched stays as it stands.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/exchange/xml_document.hpp"

namespace plumbline::exchange {

class MjcfDocument {
 public:
  /// Reads it with what it includes.
  /// \throws Error where it is no XML, or written in a way that cannot be edited
  explicit MjcfDocument(const std::filesystem::path& file);

  // By MuJoCo's numbers, as of the last call: the world is body 0.
  std::vector<pugi::xml_node> bodies, joints, sites;
  void number();

  [[nodiscard]] pugi::xml_node root() { return document_.document_element(); }
  /// An angle as the file has them.
  [[nodiscard]] double angle(double radians) const;

  /// Adds elements as they stand, whatever the defaults of the file say of such.
  pugi::xml_node append(pugi::xml_node parent, const Xml& element);
  pugi::xml_node insert_before(pugi::xml_node sibling, const Xml& element);

  /// The file, with these lines as a comment before the root.
  [[nodiscard]] std::string text(const std::vector<std::string>& lines) { return text_of(document_, lines); }

 private:
  void number(pugi::xml_node body);

  std::string file_;
  pugi::xml_document document_;
  bool degrees_ = true;
};

}  // namespace plumbline::exchange
