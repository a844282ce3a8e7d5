#pragma once
/// \file
/// For a suite that runs with PLUMBLINE_REACHED: writes to that file, for every test case, its name, its time
/// and the faults whose places it came by, separated by tabs. The tool puts this behind the suites' main.

#include <doctest/doctest.h>

#include <chrono>
#include <fstream>

namespace mutation {

struct Recorder : doctest::IReporter {
  std::ofstream file;
  const char* name = "";
  std::chrono::steady_clock::time_point begin;

  explicit Recorder(const doctest::ContextOptions& /*options*/) {
    if (recording) file.open(std::getenv("PLUMBLINE_REACHED"));
  }
  void write(const char* what, double seconds) {
    file << what << '\t' << seconds << '\t';
    for (std::size_t fault = 0; fault < reached.size(); ++fault)
      if (reached[fault]) file << fault << ' ';
    file << std::endl;
    reached.fill(false);
  }

  void test_run_start() override { write("", 0); }  // what is done before any test case counts for all
  void test_case_start(const doctest::TestCaseData& test) override {
    name = test.m_name;
    begin = std::chrono::steady_clock::now();
  }
  void test_case_end(const doctest::CurrentTestCaseStats& /*test*/) override {
    write(name, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  void report_query(const doctest::QueryData& /*query*/) override {}
  void test_run_end(const doctest::TestRunStats& /*run*/) override {}
  void test_case_reenter(const doctest::TestCaseData& /*test*/) override {}
  void test_case_exception(const doctest::TestCaseException& /*error*/) override {}
  void subcase_start(const doctest::SubcaseSignature& /*subcase*/) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData& /*data*/) override {}
  void log_message(const doctest::MessageData& /*data*/) override {}
  void test_case_skipped(const doctest::TestCaseData& /*test*/) override {}
};

REGISTER_LISTENER("reached", 1, Recorder);

}  // namespace mutation
