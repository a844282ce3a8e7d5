#include "verify/judging/matrix_formula.hpp"

#include <Eigen/LU>
#include <cctype>
#include <plumbline/base/error.hpp>

namespace plumbline::verify {
namespace {

using Value = std::optional<Matrix<Rational>>;

bool scalar(const Matrix<Rational>& m) {
  return m.rows() == 1 && m.cols() == 1;
}

Value sum(const Value& a, const Value& b, int sign) {
  if (!a || !b || a->rows() != b->rows() || a->cols() != b->cols()) return std::nullopt;
  return Matrix<Rational>(*a + Rational(sign) * *b);
}

Value product(const Value& a, const Value& b) {
  if (!a || !b) return std::nullopt;
  if (scalar(*a)) return Matrix<Rational>((*a)(0, 0) * *b);
  if (scalar(*b)) return Matrix<Rational>((*b)(0, 0) * *a);
  if (a->cols() != b->rows()) return std::nullopt;
  return Matrix<Rational>(*a * *b);
}

Value transposed(const Value& a) {
  return a ? Value(Matrix<Rational>(a->transpose())) : std::nullopt;
}

Value inverse(const Value& a) {
  if (!a || a->rows() != a->cols()) return std::nullopt;
  const Eigen::FullPivLU<Matrix<Rational>> lu(*a);
  if (!lu.isInvertible()) return std::nullopt;
  return Matrix<Rational>(lu.inverse());
}

Value pseudoinverse(const Value& a) {
  if (a && a->rows() < a->cols()) return transposed(pseudoinverse(transposed(a)));
  return product(inverse(product(transposed(a), a)), transposed(a));
}

/// Reads from left to right.
class Reader {
 public:
  Reader(std::string formula, const NamedMatrices& values) : text_(std::move(formula)), values_(values) {}

  Value whole() {
    const Value value = read_sum();
    if (at_ != text_.size()) fail();
    return value;
  }

 private:
  [[noreturn]] void fail() const {
    throw Error("claim", "'" + text_ + "'", "a matrix formula in the names of the claim");
  }

  bool next(const std::string& token) {
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }

  Value read_sum() {
    const bool negative = next("-");
    if (!negative) next("+");
    Value value = read_product();
    if (negative && value) value = Matrix<Rational>(-*value);
    for (;;) {
      if (next("+"))
        value = sum(value, read_product(), 1);
      else if (next("-"))
        value = sum(value, read_product(), -1);
      else
        return value;
    }
  }

  Value read_product() {
    Value value = read_factor();
    while (next("*")) value = product(value, read_factor());
    return value;
  }

  Value in_brackets() {
    const Value value = read_sum();
    if (!next(")")) fail();
    return value;
  }

  Value read_factor() {
    Value value = next("pinv(")  ? pseudoinverse(in_brackets())
                  : next("inv(") ? inverse(in_brackets())
                  : next("(")    ? in_brackets()
                                 : read_name();
    while (next("^T")) value = transposed(value);
    return value;
  }

  Value read_name() {
    std::string name;
    while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_])) != 0)
      name += text_[at_++];
    if (name.empty()) fail();
    if (name.find_first_not_of("0123456789") == std::string::npos)
      return Matrix<Rational>(Matrix<Rational>::Constant(1, 1, Rational(name)));
    const auto found = values_.find(name);
    if (found == values_.end()) fail();
    return found->second;
  }

  std::string text_;
  const NamedMatrices& values_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<Matrix<Rational>> evaluated(const std::string& formula, const NamedMatrices& values) {
  return Reader(formula, values).whole();
}

}  // namespace plumbline::verify
