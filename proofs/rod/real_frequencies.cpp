#include "proofs/rod/real_frequencies.hpp"

#include <cmath>

namespace plumbline::proofs {
namespace {

/// What is known of the function on a part of the line, at each factor.
enum class Course { positive, negative, rising, falling };

bool is_sign(Course course) {
  return course == Course::positive || course == Course::negative;
}

std::optional<Course> course_of(const Span& value) {
  if (certainly_positive(value)) return Course::positive;
  if (certainly_negative(value)) return Course::negative;
  return std::nullopt;
}

/// The line from left to right in parts on which the function has one sign or grows one way.
class Parts {
 public:
  Parts(const Characteristic& function, const Span& factor) : slab_(function, factor) {}

  /// \returns whether each part is known
  bool add(const Span& x, int halvings) {
    const Jet<Span> jet = slab_.at(x);
    if (const auto sign = course_of(jet.value)) return append(*sign);
    if (certainly_positive(jet.by_square)) return append(Course::rising);
    if (certainly_negative(jet.by_square)) return append(Course::falling);
    if (halvings == 0) return false;
    // frequencies of a rod are as the squares of whole numbers
    const double root = (std::pow(x.low, 0.25) + std::pow(x.high, 0.25)) / 2;
    const double middle = root * root * root * root;
    if (!(x.low < middle && middle < x.high)) return false;
    return add({x.low, middle}, halvings - 1) && add({middle, x.high}, halvings - 1);
  }
  bool add_point(double x) {
    const auto sign = course_of(slab_.at(x).value);
    return sign && append(*sign);
  }
  /// Between two signs a part that grows one way has one zero where they differ, else none.
  [[nodiscard]] std::optional<std::size_t> zeros() const {
    std::size_t count = 0;
    for (std::size_t i = 1; i < courses_.size(); ++i) {
      if (is_sign(courses_[i])) continue;
      if (!is_sign(courses_[i - 1]) || !is_sign(courses_[i + 1])) return std::nullopt;
      count += courses_[i - 1] != courses_[i + 1] ? 1 : 0;
    }
    return count;
  }

 private:
  bool append(Course course) {
    if (courses_.empty() || courses_.back() != course) courses_.push_back(course);
    return true;
  }

  Characteristic::Slab slab_;
  std::vector<Course> courses_;
};

}  // namespace

std::optional<std::size_t> simple_zeros(const Characteristic& function, const Span& factor, const Span& x) {
  constexpr int most_halvings = 12;
  Parts parts(function, factor);
  if (!parts.add_point(x.low) || !parts.add(x, most_halvings) || !parts.add_point(x.high))
    return std::nullopt;
  return parts.zeros();
}

}  // namespace plumbline::proofs
