#pragma once
/// \file
/// What of a model goes into a file of some format.

#include "diagnose/exchange/catalogue_rows.hpp"
#include "diagnose/exchange/format.hpp"
#include "diagnose/exchange/model.hpp"
#include "diagnose/exchange/tree.hpp"

namespace plumbline::exchange {

/// The model with these effects in place of its own, and without a law.
diagnose::Rig rig_with(const Model& model, const std::vector<diagnose::NominalEffect>& effects);

/// Whether it is an effect of the catalogue, not one that the user stated.
bool of_catalogue(const diagnose::NominalEffect& effect);

/// Of every effect of the model, whether the format carries it and as what, or why not; then of its law.
std::vector<Carried> what_is_carried(const Model& model, Format format);

/// What of it the format has no word of its own for, so that the file has it as rows of the catalogue.
CatalogueRows rows_beside(const Model& model, const std::vector<Carried>& effects, Format format);

/// The tree of the model with what is carried alone.
Tree carried_tree(const Model& model, const std::vector<Carried>& effects, const Means& means);

}  // namespace plumbline::exchange
