#pragma once
/// \file
/// XML to be written.

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

namespace plumbline::exchange {

/// Numbers that differ by less than this share of the largest beside them differ by arithmetic alone.
inline constexpr double last_digit = 1e-14;

/// A number, and several of them, as attributes have them. What is but rounding beside the others is nought.
std::string number(double value);
std::string numbers(const std::vector<double>& values);
std::string numbers_of(const Eigen::Vector3d& vector);

/// As a value between quotes, or as text, has it.
std::string escaped(const std::string& text);

class Xml {
 public:
  explicit Xml(std::string name) : name_(std::move(name)) {}

  /// An attribute, in place of one of that name.
  Xml& set(const std::string& key, const std::string& value);
  Xml& add(Xml child) {
    children_.push_back(std::move(child));
    return *this;
  }
  Xml& content(std::string text) {
    text_ = std::move(text);
    return *this;
  }
  /// An element with text alone.
  Xml& add(const std::string& name, const std::string& text) {
    children_.emplace_back(name).text_ = text;
    return *this;
  }
  [[nodiscard]] bool empty() const { return children_.empty() && text_.empty(); }
  [[nodiscard]] std::string text(std::size_t depth) const;

 private:
  std::string name_, text_;
  std::vector<std::pair<std::string, std::string>> attributes_;
  std::vector<Xml> children_;
};

/// What stands between the marks of a comment with these lines.
std::string comment(const std::vector<std::string>& lines, const std::string& line_end = "\n");
/// A file: the declaration, a comment with these lines, the root.
std::string document(const std::vector<std::string>& lines, const Xml& root);

}  // namespace plumbline::exchange
