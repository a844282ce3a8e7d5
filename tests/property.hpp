#pragma once
/// \file
/// RapidCheck inside doctest: a property that fails prints its smallest counterexample.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <sstream>
#include <string>

/// Checks a property (a callable, its arguments generated) and reports it as one doctest assertion.
template <class Testable>
void check_property(const std::string& description, Testable&& property) {
  const rc::detail::TestMetadata metadata{description, description};
  const rc::detail::TestResult result = rc::detail::checkTestable(std::forward<Testable>(property), metadata);
  std::ostringstream report;
  rc::detail::printResultMessage(result, report);
  INFO(report.str());
  CHECK(result.template is<rc::detail::SuccessResult>());
}

/// Hundredths from `low` to below `high`; to be called inside a property.
inline double random_hundredths(int low, int high) {
  return *rc::gen::inRange(low * 100, high * 100) / 100.0;
}
