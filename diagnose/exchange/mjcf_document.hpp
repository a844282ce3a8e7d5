#pragma once
/// \file
/// A user's own MJCF, to be read or edited: what is not touched stays as it stands.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "diagnose/exchange/xml_document.hpp"
#include "diagnose/exchange/xml_file.hpp"

namespace plumbline::exchange {

class MjcfDocument {
 public:
  /// Reads it with what it includes.
  /// \throws Error where it is no MJCF, or includes a file twice or one that cannot be read
  explicit MjcfDocument(const std::filesystem::path& file);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const pugi::xml_document& whole() const { return source_.document; }
  [[nodiscard]] pugi::xml_node root() const { return source_.document.document_element(); }
  /// What the last <compiler> that names it says; or `otherwise`.
  [[nodiscard]] std::string setting(const char* name, const char* otherwise) const;
  /// A value that <compiler> has as a switch.
  [[nodiscard]] bool is_on(const char* name, bool otherwise) const;
  /// Whether <option><flag> switches something off.
  [[nodiscard]] bool disabled(const char* flag) const;

  /// An angle as the file has them, and back.
  [[nodiscard]] double angle(double radians) const;
  [[nodiscard]] double radians(double angle) const;

  /// Adds elements as they stand, whatever the defaults of the file say of such.
  pugi::xml_node append(pugi::xml_node parent, const Xml& element);
  pugi::xml_node insert_before(pugi::xml_node sibling, const Xml& element);

  /// The file, with these lines as a comment before the root.
  [[nodiscard]] std::string text(const std::vector<std::string>& lines) const { return source_.text(lines); }

 private:
  void include(pugi::xml_node parent, const std::filesystem::path& folder, std::set<std::string>& included);
  [[nodiscard]] bool in_degrees() const;

  std::string file_;
  XmlFile source_;
};

}  // namespace plumbline::exchange
