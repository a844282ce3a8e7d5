#include "app/drafted_folder.hpp"

#include "app/experiment_schema.hpp"
#include "support/files/output_file.hpp"

namespace plumbline::app {

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
