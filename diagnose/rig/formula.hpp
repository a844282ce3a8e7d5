#pragma once
/// \file
/// An expression as a user wrote it, parsed once and evaluated often.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::diagnose {

/// A real number as an expression of named variables. Evaluated by one thread at a time.
class Formula {
 public:
  /// \param names  of all variables, in the order in which their values will come
  /// \param place  for errors
  /// \throws Error for what is no expression of these names
  Formula(const std::string& text, const std::vector<std::string>& names, const std::string& place);
  Formula(const Formula&) = delete;
  Formula& operator=(const Formula&) = delete;
  ~Formula();

  [[nodiscard]] bool uses(std::string_view name) const;

  /// Its value where the first variables have the values `first` and the others `others`. Not finite where it
  /// has none.
  [[nodiscard]] double at(std::span<const double> first, std::span<const double> others) const;

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

/// Whether a name could be a variable's: of letters, digits and underscores, and nothing that formulas know
/// already.
bool can_be_named(const std::string& name);

}  // namespace plumbline::diagnose
