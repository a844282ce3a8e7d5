#pragma once
/// \file
/// A study out of files: an experiment, its nominal model, and effects that its user states.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// The files that say what is to be diagnosed.
struct StudyFiles {
  std::filesystem::path folder;   ///< with experiment.toml and its tables; empty: the example of the README
  std::filesystem::path model;    ///< the nominal model; empty: the experiment's own
  std::filesystem::path effects;  ///< effects of the user's; or empty
  std::string state = {};         ///< of the device: its runs alone; empty: all runs are of one

  /// Every file that is read.
  [[nodiscard]] std::vector<std::filesystem::path> all() const;
  /// The file of the nominal model: this one, or that which experiment.toml names for an arm; empty where
  /// there is none.
  /// \throws Error where experiment.toml cannot be read
  [[nodiscard]] std::filesystem::path nominal_model() const;
};

/// The experiment with every reading.
/// \throws Error, one line with its place: for a file that cannot be read or a value that makes no sense
Experiment experiment_of(const StudyFiles& files);
/// The bench before any measurement: its runs may be without samples, or hold commands alone.
/// \throws Error as experiment_of()
Experiment bench_of(const StudyFiles& files);

/// The experiment, decimated, with the user's effects among the candidates.
/// \param effects  a file of effects; or empty
/// \throws Error where one of them is undefined along the nominal model's runs
Study study_of(const Experiment& experiment, const std::filesystem::path& effects = {});

}  // namespace plumbline::diagnose
