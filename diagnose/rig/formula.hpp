#pragma once
/// \file
/// A user's expression, parsed once and evaluated often.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::diagnose {

/// A real-valued expression of named variables. Not thread-safe.
class Formula {
 public:
  /// \param names  all variables, in the order of their values
  /// \param place  named in errors
  /// \throws Error for a text that is no expression of these names
  Formula(const std::string& text, const std::vector<std::string>& names, const std::string& place);
  Formula(const Formula&) = delete;
  Formula& operator=(const Formula&) = delete;
  ~Formula();

  [[nodiscard]] bool uses(std::string_view name) const;

  /// The value for the first variables `first` and the others `others`; not finite where it is undefined.
  [[nodiscard]] double at(std::span<const double> first, std::span<const double> others) const;

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

/// Whether a name can be a variable: letters, digits and underscores, and no function or constant of
/// formulas.
bool can_be_named(const std::string& name);

}  // namespace plumbline::diagnose
