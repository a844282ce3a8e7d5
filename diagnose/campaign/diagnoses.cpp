#include "diagnose/campaign/diagnoses.hpp"

#include <nlohmann/json.hpp>
#include <plumbline/base/parallel.hpp>

#include "support/files/experiment_files.hpp"
#include "support/files/json_file.hpp"
#include "support/files/printable.hpp"
#include "support/files/sha256.hpp"

namespace plumbline::campaign {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The digest of everything that a diagnosis reads.
std::string digest_of_inputs(const Assignment& one) {
  std::vector<fs::path> files = files::files_read(one.experiment);
  files.insert(files.end(), one.inputs.begin(), one.inputs.end());
  return files::sha256(files);
}

std::string as_item(const Assignment& one, const std::string& digest) {
  return Json{{"experiment", files::text_of(one.experiment)},
              {"report", files::text_of(one.report)},
              {"words", one.words},
              {"alone", one.alone ? Json(one.alone->count()) : Json()},
              {"inputs", digest}}
      .dump();
}

std::vector<std::string> as_items(const std::vector<Assignment>& assignments, bool digests) {
  std::vector<std::string> items(assignments.size());
  in_parallel(items.size(), available_threads(), [&](std::size_t i) {
    items[i] = as_item(assignments[i], digests ? digest_of_inputs(assignments[i]) : "");
  });
  return items;
}

Diagnosed diagnosed(const std::string& result) {
  const Json json = Json::parse(result);
  return {json["seconds"], json["failure"]};
}

std::string result_of(const std::string& item) {
  const Json told = Json::parse(item);
  const fs::path executable = fs::read_symlink("/proc/self/exe"),
                 experiment = std::string(told["experiment"]);
  const std::string report = told["report"];
  Diagnosed done;
  if (!told["alone"].is_null()) {
    done = diagnose_alone(executable, experiment, report, std::chrono::duration<double>(told["alone"]));
  } else {
    std::vector<std::string> words = told["words"];
    words.insert(words.end(), {"--json", report});
    done = run_diagnosis(executable, experiment, words);
  }
  return Json{{"seconds", done.seconds}, {"failure", done.failure}}.dump(-1, ' ', false,
                                                                         Json::error_handler_t::replace);
}

}  // namespace

const work::Task diagnosis_task{"diagnosis", result_of};

std::vector<Diagnosed> diagnose_all(const std::vector<Assignment>& assignments, work::Journal* journal,
                                    const std::function<void()>& advance) {
  const work::WorkList list{diagnosis_task, as_items(assignments, journal != nullptr),
                            [&](std::size_t i, const std::string& result) {
                              return diagnosed(result).failure.empty() && fs::exists(assignments[i].report);
                            }};
  std::vector<Diagnosed> all;
  for (const std::string& result : work::results(list, journal, advance)) all.push_back(diagnosed(result));
  return all;
}

}  // namespace plumbline::campaign
