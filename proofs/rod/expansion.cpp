#include "proofs/rod/expansion.hpp"

namespace plumbline::proofs {

double Expansion::norm() const {
  double sum = rest_;
  for (const auto& row : rows_)
    for (const Interval& a : row) sum = upward(sum + size_of(a));
  return sum;
}

void Expansion::add(std::size_t i, std::size_t j, const Interval& value) {
  if (i > size_.s || j > size_.u) return add_rest(size_of(value));
  if (rows_.size() <= i) rows_.resize(i + 1);
  if (rows_[i].size() <= j) rows_[i].resize(j + 1);
  rows_[i][j] += value;
}

Expansion Expansion::operator-() const {
  Expansion result = *this;
  for (auto& row : result.rows_)
    for (Interval& a : row) a = -a;
  return result;
}

Expansion& Expansion::operator+=(const Expansion& other) {
  for (std::size_t i = 0; i < other.rows_.size(); ++i)
    for (std::size_t j = 0; j < other.rows_[i].size(); ++j) add(i, j, other.rows_[i][j]);
  add_rest(other.rest_);
  return *this;
}

Expansion operator*(const Expansion& a, const Expansion& b) {
  const auto is_zero = [](const Interval& x) { return size_of(x) == 0; };
  Expansion result(a.size_);
  for (std::size_t i = 0; i < a.rows_.size(); ++i) {
    for (std::size_t j = 0; j < a.rows_[i].size(); ++j) {
      if (is_zero(a.rows_[i][j])) continue;
      for (std::size_t k = 0; k < b.rows_.size(); ++k)
        for (std::size_t l = 0; l < b.rows_[k].size(); ++l)
          result.add(i + k, j + l, a.rows_[i][j] * b.rows_[k][l]);
    }
  }
  if (a.rest_ > 0) result.add_rest(Expansion::upward(a.rest_ * b.norm()));
  if (b.rest_ > 0) result.add_rest(Expansion::upward(b.rest_ * a.norm()));
  return result;
}

Expansion operator*(Expansion a, const Interval& b) {
  for (auto& row : a.rows_)
    for (Interval& each : row) each *= b;
  a.rest_ = Expansion::upward(a.rest_ * size_of(b));
  return a;
}

}  // namespace plumbline::proofs
