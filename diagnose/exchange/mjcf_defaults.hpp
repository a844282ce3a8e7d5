#pragma once
/// \file
/// Attributes of MJCF elements as MuJoCo has them: those that stand in the element, and else those of its
/// class.

#include <Eigen/Core>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace plumbline::exchange {

class MjcfDefaults {
 public:
  /// \param file  named in errors
  /// \throws Error where a class occurs twice
  MjcfDefaults(pugi::xml_node root, std::string file);

  /// The elements of this kind in the element's class and in those that it inherits from, the nearest first.
  [[nodiscard]] std::vector<pugi::xml_node> inherited(pugi::xml_node element, const char* kind) const;
  /// The attribute of the element, or of its class; none where neither says.
  /// \throws Error where the class is not there
  [[nodiscard]] pugi::xml_attribute attribute(pugi::xml_node element, const char* name) const;

  // As numbers; `otherwise` where nothing is said. Errors name the element and the attribute.
  [[nodiscard]] double number(pugi::xml_node element, const char* name, double otherwise) const;
  [[nodiscard]] Eigen::Vector3d vector(pugi::xml_node element, const char* name,
                                       const Eigen::Vector3d& otherwise) const;
  [[nodiscard]] std::vector<double> numbers(pugi::xml_node element, const char* name, std::size_t least,
                                            std::size_t most, std::vector<double> otherwise) const;

 private:
  struct Class {
    std::string parent;  ///< empty for what all inherit from
    std::vector<pugi::xml_node> elements;
  };
  void add(pugi::xml_node element, const std::string& parent);

  std::string file_;
  std::map<std::string, Class> classes_;
};

}  // namespace plumbline::exchange
