/// \file
/// Makes the committed experiments: every effect of the catalogue once, nothing but noise twice, two effects
/// at once twice, and three effects that are in no catalogue. What is made depends on the seed alone.
///
///     make-experiments SEED FOLDER

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <plumbline/base/parallel.hpp>
#include <string>
#include <vector>

#include "support/files/output_file.hpp"
#include "trial/simulator/write_experiment.hpp"

namespace {

using plumbline::simulator::Kind;
using plumbline::simulator::Wish;

struct Wanted {
  std::string name;
  Wish wish;
};

constexpr double clear = 15;  // sigmas rms: what a lab would go and look for

const Kind& kind(std::string_view id) {
  const auto& all = plumbline::simulator::catalogue();
  return *std::find_if(all.begin(), all.end(), [&](const Kind& one) { return one.id == id; });
}

std::vector<Wanted> all_wanted() {
  std::vector<Wanted> all;
  for (const Kind& one : plumbline::simulator::first_catalogue())
    all.push_back({std::string(one.id), {{&one}, {clear}}});
  for (const int number : {1, 2}) all.push_back({fmt::format("none-{}", number), {}});
  for (const auto& [one, other] :
       {std::pair("joint_friction", "force_bias"), std::pair("gravity", "joint_stiffness")})
    all.push_back({fmt::format("{}-{}", one, other), {{&kind(one), &kind(other)}, {clear, clear}}});
  for (const std::size_t number : {0U, 3U, 7U})
    all.push_back(
        {fmt::format("outside-{}", number), {{&plumbline::simulator::first_outside()[number]}, {clear}}});
  return all;
}

void make(std::uint64_t seed, const std::filesystem::path& folder) {
  const std::vector<Wanted> wanted = all_wanted();
  plumbline::in_parallel(wanted.size(), 2, [&](std::size_t i) {
    plumbline::simulator::Random random(seed, i);
    const auto made = plumbline::simulator::make_experiment(wanted[i].wish, wanted[i].name, random);
    plumbline::simulator::write_experiment(made, folder / wanted[i].name);
    plumbline::files::write_text(folder / wanted[i].name / "label.json", as_json(made.label).dump(1) + "\n");
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: make-experiments SEED FOLDER\n";
    return 2;
  }
  try {
    make(std::stoull(argv[1]), argv[2]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "make-experiments: " << error.what() << '\n';
    return 2;
  }
}
