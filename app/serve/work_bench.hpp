#pragma once
/// \file
/// State of one user's work on the page: files, drafted experiment, diagnosis.

#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/drafted_folder.hpp"
#include "diagnose/draft/read_draft_model.hpp"
#include "diagnose/draft/seen_tables.hpp"
#include "support/files/temporary_folder.hpp"

namespace plumbline::app {

/// A file as it was dropped, or as it is to be downloaded.
struct NamedFile {
  std::string name, text;
};

/// One user's work. Calls are sequential; the diagnosis runs in a thread of its own. Every failure is an
/// Error whose line the page shows.
class WorkBench {
 public:
  WorkBench() = default;
  WorkBench(const WorkBench&) = delete;
  WorkBench& operator=(const WorkBench&) = delete;
  ~WorkBench() { cancel(); }

  /// Takes a model and tables, in place of those before, and drafts the experiment.
  /// \param joints   that make the chain; empty: all
  /// \param columns  what they hold, as told_columns() takes it; or empty
  nlohmann::json take(const NamedFile& model, const std::vector<NamedFile>& tables,
                      const std::vector<std::string>& joints, const std::string& columns = "");
  /// Takes the example that the program has in it.
  nlohmann::json take_example();
  /// Takes experiment.toml as the person corrected it, and says what it is read as.
  nlohmann::json correct(const std::string& settings);
  /// Begins the diagnosis; one that goes on is given up.
  nlohmann::json begin(bool as_is);
  /// How far it is, and what came of it.
  [[nodiscard]] nlohmann::json progress() const;
  void cancel();

  /// The report's page; empty before there is one.
  [[nodiscard]] std::string report() const;
  /// The corrected models.
  [[nodiscard]] std::vector<NamedFile> corrected() const;
  /// A complaint with the files by the names that the person gave, without our folder for them.
  [[nodiscard]] std::string in_own_names(std::string text) const;
  /// The experiment's folder.
  [[nodiscard]] std::vector<NamedFile> folder() const;

 private:
  enum class State { nothing, busy, done, failed, cancelled };
  struct Outcome {
    State state = State::nothing;
    std::string words;  ///< the report for a terminal, or what went wrong
    std::string page;
    std::vector<NamedFile> models;
  };

  [[nodiscard]] nlohmann::json described() const;
  void diagnose(bool as_is, const std::stop_token& stop);

  std::optional<files::TemporaryFolder> place_;
  std::string model_;  ///< its name in the place; or none
  diagnose::ReadDraftModel read_;
  std::vector<diagnose::SeenTable> seen_;
  diagnose::Draft draft_;
  mutable std::mutex mutex_;  ///< of the outcome
  Outcome outcome_;
  std::atomic<double> share_ = 0;
  std::jthread job_;
};

}  // namespace plumbline::app
