#pragma once
/// \file
/// A folder of experiments with withheld labels:
///
///     NAME/experiment.toml, NAME/*.csv   an experiment, in the format "chain-experiment/1"
///     seals.json                         {"format": "experiment-seals/1", "seals": {"NAME": "SHA-256 …", …}}
///     labels/NAME.json                   {"salt": "…", "label": "… JSON as text …"}, looked at after the
///     diagnosis
///
/// The seal is the SHA-256 of salt, line feed, label. Instead of the last two a folder may hold
/// NAME/label.json, the label as it is: nothing is sealed then.

#include "trial/score.hpp"
#include "trial/seal.hpp"

namespace plumbline::trial {

class SealedFolder {
 public:
  /// Looks for experiments and seals, not for labels.
  /// \throws Error without an experiment, or where an experiment has no seal and no label
  explicit SealedFolder(std::filesystem::path folder);

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] std::filesystem::path experiment(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] std::size_t sealed() const { return seals_.size(); }
  /// SHA-256 of the file of the seals; empty without one.
  [[nodiscard]] const std::string& digest() const { return digest_; }

  /// Opens the seals. Before the diagnoses, where labels are present, it finds malformed ones.
  /// \throws Error for a missing or malformed label
  [[nodiscard]] Case open(const std::string& name) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::string> names_;
  Seals seals_;
  std::string digest_;
};

}  // namespace plumbline::trial
