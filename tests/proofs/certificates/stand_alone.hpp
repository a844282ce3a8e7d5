#pragma once
/// \file
/// What the checkers that share nothing with Plumbline say.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "proofs/certificates/certificate.hpp"

namespace plumbline::proofs {

/// \param checker  in proofs/
/// \returns its exit status, 0 when all certificates hold
inline int check_alone(const std::string& checker, const char* format,
                       const std::vector<nlohmann::json>& certificates) {
  const auto path = std::filesystem::temp_directory_path() / ("plumbline-" + checker + ".json");
  std::ofstream(path) << certificate_file(format, {"test", "test", ""}, certificates);
  const std::string command =
      "python3 -B " PLUMBLINE_SOURCE_DIR "/proofs/certificates/" + checker + " " + path.string();
  const int status = std::system((command + " >/dev/null").c_str());
  std::filesystem::remove(path);
  return status;
}

}  // namespace plumbline::proofs
