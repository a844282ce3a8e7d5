#pragma once
/// \file
/// A chain as certificates carry it: the keys of its chain file with their values, every number an exact
/// text. So a checker assembles the chain from what was stated, and from nothing that a program made of it.

#include <nlohmann/json_fwd.hpp>
#include <plumbline/structure/structure.hpp>
#include <string>

namespace plumbline::statement {

/// The keys and values of a chain file that has been read (chain_file.hpp), in the spelling of chain files;
/// without the masses and the gravity of a simulator's model, which weigh nothing here.
nlohmann::json stated(const std::string& text, const std::string& source);
/// Of a structure that no file has said, with its loads at joints; what acts at the base, the ground takes.
nlohmann::json stated(const Structure<Rational>& structure);

}  // namespace plumbline::statement
