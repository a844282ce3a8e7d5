#pragma once
/// \file
/// What a correction took several elements of a format for, in the words of the catalogue: instructions
/// <?plumbline …?> at the head of the file, which other programs pass over.

#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "diagnose/bench/nominal_chain.hpp"

namespace plumbline::exchange {

struct CatalogueRows {
  std::vector<diagnose::NominalEffect> effects;
  std::vector<diagnose::FreeLaw> laws;
  std::set<std::string> added;  ///< names of the elements that act them out

  [[nodiscard]] bool empty() const { return effects.empty() && laws.empty(); }
};

/// \param file  named in errors
/// \throws Error where an instruction says none of them
CatalogueRows catalogue_rows_in(const pugi::xml_document& document, const std::string& file);

/// The file with the rows at its head.
/// \param bare  the file as it is without them: what it does not name is what they added
std::string with_catalogue_rows(const std::string& text, const CatalogueRows& rows, const std::string& bare);

}  // namespace plumbline::exchange
