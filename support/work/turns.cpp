#include "support/work/turns.hpp"

namespace plumbline::work {

std::optional<Turns::Turn> Turns::next() {
  const std::scoped_lock lock(exchanging_);
  if (failure_ || left_ == 0) return std::nullopt;
  --left_;
  const std::size_t number = next_++;
  return Turn{number, exchange_.item(number)};
}

void Turns::done(std::size_t number, const std::string& result) {
  try {
    const std::scoped_lock lock(exchanging_);
    exchange_.take(number, result);
  } catch (...) {
    failed(number, std::current_exception());
  }
}

void Turns::failed(std::size_t number, const std::exception_ptr& failure) {
  const std::scoped_lock lock(exchanging_);
  if (failure_ && number > failed_) return;
  failed_ = number;
  failure_ = failure;
}

void Turns::work_through(const Task& task) {
  while (const auto turn = next()) {
    try {
      done(turn->number, task.result(turn->item));
    } catch (...) {
      failed(turn->number, std::current_exception());
    }
  }
}

void Turns::end() const {
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace plumbline::work
