#include "diagnose/exchange/corrected.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/carried.hpp"
#include "diagnose/exchange/edit_mjcf.hpp"
#include "diagnose/exchange/edit_sdf.hpp"
#include "diagnose/exchange/edit_urdf.hpp"
#include "diagnose/exchange/mjcf.hpp"
#include "diagnose/exchange/sdf.hpp"
#include "diagnose/exchange/toml.hpp"
#include "diagnose/exchange/urdf.hpp"
#include "diagnose/exchange/written_arm.hpp"
#include "diagnose/inference/calibration.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::Candidate, diagnose::CauseVerdict, diagnose::Diagnosis, diagnose::NominalEffect,
    diagnose::Study;

/// \param values  in catalogue units, by effect and parameter
std::vector<NominalEffect> effects_of(const Study& study, const Candidate& candidate,
                                      const std::vector<double>& values) {
  std::vector<NominalEffect> all;
  std::size_t next = 0;
  for (const diagnose::EffectAt& at : candidate.effects) {
    NominalEffect& one = all.emplace_back(NominalEffect{std::string(at.effect->id), at.joint, {}});
    for (const diagnose::ParameterRange& range : study.ranges(at))
      one.parameters[std::string(range.name)] = values.at(next++);
  }
  return all;
}

std::vector<double> in_catalogue_units(const Study& study, const Candidate& candidate,
                                       std::vector<double> parameters) {
  std::size_t next = 0;
  for (const diagnose::ParameterRange& range : study.ranges(candidate)) {
    parameters[next] = catalogue_value(range.coordinate, parameters[next]);
    ++next;
  }
  return parameters;
}

/// The values that the report gives for the best explanation.
std::vector<double> reported(const Diagnosis& diagnosis) {
  std::vector<double> values;
  for (const auto& effect : diagnosis.estimates)
    for (const diagnose::Estimate& one : effect) values.push_back(one.value);
  return values;
}

/// "backlash-2-gravity"; "user-cogging", for some systems allow no colon in the names of files
std::string file_word(const Candidate& candidate) {
  std::string word;
  for (const diagnose::EffectAt& at : candidate.effects) {
    word += (word.empty() ? "" : "-") + std::string(at.effect->id);
    if (at.joint > 0) word += "-" + std::to_string(at.joint);
  }
  std::replace(word.begin(), word.end(), ':', '-');
  return word;
}

class Models {
 public:
  explicit Models(const Study& study) : study_(study) {}

  void add(const std::string& cause, const std::string& with, const std::vector<NominalEffect>& effects,
           const std::vector<diagnose::FreeLaw>& laws = {}) {
    add_to(study_.experiment(), cause, with, effects, laws);
  }
  /// \param values  in catalogue units
  void add(const diagnose::Hypothesis& found, const std::vector<double>& values, bool alone) {
    add_to(beside(study_, {found.candidate, found.parameters}), alone ? "" : file_word(found.candidate),
           "with " + found.candidate.label(), effects_of(study_, found.candidate, values), {});
  }
  void add_law(const diagnose::OfferedLaw& law, bool alone) {
    add(alone ? "" : "torque_law", "with a free torque law", {}, free_laws(study_, law.law));
  }

  std::vector<Corrected> result() { return std::move(all_); }

 private:
  void add_to(const diagnose::Experiment& nominal, const std::string& cause, const std::string& with,
              const std::vector<NominalEffect>& effects, const std::vector<diagnose::FreeLaw>& laws) {
    Model model{fmt::format("Corrected model of \"{}\": the nominal model {}.", nominal.name, with), nominal,
                nominal.rest.empty() ? nominal.runs.front().rest : nominal.rest};
    model.experiment.effects.insert(model.experiment.effects.end(), effects.begin(), effects.end());
    model.experiment.laws.insert(model.experiment.laws.end(), laws.begin(), laws.end());
    all_.push_back({cause, std::move(model)});
  }

  const Study& study_;
  std::vector<Corrected> all_;
};

}  // namespace

std::vector<Corrected> corrected_models(const Study& study, const Diagnosis& diagnosis,
                                        const std::filesystem::path& source) {
  const diagnose::Cause& cause = diagnosis.cause;
  const diagnose::Calibration* const calibration = study.experiment().arm_bench.calibration.get();
  Models models(study);
  if (calibration && !cause.is_explained()) {
    models.add("", "with every joint calibrated", calibration->beside);
  } else if (cause.verdict == CauseVerdict::none) {
    models.add("", "as it is, for there is no gap", {});
  } else if (cause.leaves_a_rest() && diagnosis.law) {
    models.add_law(*diagnosis.law, true);
  } else if (cause.verdict == CauseVerdict::unknown) {
    models.add("", "as it is, for the cause is unknown and no torque law closes the gap", {});
  } else {
    models.add(cause.ranking.front().hypothesis, reported(diagnosis), cause.named == 1 && !diagnosis.law);
    for (std::size_t i = 1; i < cause.named; ++i) {
      const diagnose::Hypothesis& other = cause.ranking[i].hypothesis;
      models.add(other, in_catalogue_units(study, other.candidate, other.parameters), false);
    }
    if (diagnosis.law) models.add_law(*diagnosis.law, false);
  }
  std::vector<Corrected> all = models.result();
  for (Corrected& one : all) one.model.source = source;
  return all;
}

namespace {

using Writer = Written (*)(const Model&);

/// What writes the user's own file with the correction in it; none for our own format, which is written anew.
Writer editor(Format format) {
  switch (format) {
    case Format::mjcf:
      return edit_mjcf;
    case Format::urdf:
      return edit_urdf;
    case Format::sdf:
      return edit_sdf;
    case Format::toml:
      break;
  }
  return nullptr;
}

Writer writer(Format format) {
  switch (format) {
    case Format::mjcf:
      return to_mjcf;
    case Format::urdf:
      return to_urdf;
    case Format::sdf:
      return to_sdf;
    case Format::toml:
      break;
  }
  return to_toml;
}

}  // namespace

namespace {

/// With the rows that it took several elements for.
Written in_format(const Model& model, Format format, Writer writes) {
  Written file = writes(model);
  const CatalogueRows rows = rows_beside(model, file.effects, format);
  if (rows.empty()) return file;
  Model bare = model;
  bare.experiment.laws.clear();
  std::erase_if(bare.experiment.effects, [&](const NominalEffect& one) {
    return std::find(rows.effects.begin(), rows.effects.end(), one) != rows.effects.end();
  });
  file.text = with_catalogue_rows(file.text, rows, writes(bare).text);
  return file;
}

}  // namespace

Written written(const Model& model, Format format) {
  if (!model.experiment.has_links() && format != Format::toml)
    throw Error("corrected model", "a joint alone, and a format of bodies", "a file that ends in .toml");
  if (model.experiment.arm) return written_arm(model, format);
  if (format == Format::toml) return to_toml(model);
  if (model.source.empty() || format_of(model.source) != format)
    return in_format(model, format, writer(format));
  try {
    return in_format(model, format, editor(format));
  } catch (const Error& error) {
    Written file = in_format(model, format, writer(format));
    file.note = std::string("a chain of its own, for the model's file cannot be edited: ") + error.what();
    return file;
  }
}

}  // namespace plumbline::exchange
