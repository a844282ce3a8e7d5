#pragma once
/// \file
/// Files in a zip archive (APPNOTE.TXT of PKWARE, 6.3): stored, or deflated.

#include <map>
#include <string>

namespace plumbline::diagnose {

/// The contents of an archive by the names of its files.
/// \param source  named in errors
/// \throws Error where it is damaged, encrypted or packed in another way, or holds more than 256 MB
std::map<std::string, std::string> files_in_archive(const std::string& bytes, const std::string& source);

}  // namespace plumbline::diagnose
