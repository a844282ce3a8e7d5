#include "app/drafted_folder.hpp"

#include <cmath>

#include "app/experiment_schema.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "support/files/output_file.hpp"

namespace plumbline::app {

ReadForDraft read_for_draft(const std::filesystem::path& model, const std::vector<std::string>& joints) {
  const exchange::PlanarChain read = exchange::read_model(model, joints);
  ReadForDraft result{{read.chain, read.names, {0, 0}, read.weighs}, read.notes};
  const Eigen::Vector2d base = read.plane.of(read.plane.origin);
  result.model.base = {base.x(), base.y()};
  return result;
}

std::vector<diagnose::DraftFile> files_of(const diagnose::Draft& draft) {
  std::vector<diagnose::DraftFile> all{{"experiment.toml", draft.settings},
                                       {"experiment.schema.json", experiment_schema}};
  all.insert(all.end(), draft.tables.begin(), draft.tables.end());
  return all;
}

void write_draft(const diagnose::Draft& draft, const std::filesystem::path& folder) {
  files::make_folder(folder);
  for (const diagnose::DraftFile& file : files_of(draft)) files::write_text(folder / file.name, file.text);
}

}  // namespace plumbline::app
