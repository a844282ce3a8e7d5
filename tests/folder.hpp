#pragma once
/// \file
/// A temporary folder that a test fills.

#include <fstream>

#include "support/files/temporary_folder.hpp"

class Folder : public plumbline::files::TemporaryFolder {
 public:
  void write(const std::string& name, const std::string& text) const { std::ofstream(*this / name) << text; }
};
