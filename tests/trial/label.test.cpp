#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>
#include <set>

#include "support/files/json_file.hpp"
#include "support/files/text_file.hpp"
#include "trial/label.hpp"

using namespace plumbline;
using namespace plumbline::files;
using namespace plumbline::trial;

namespace {

std::set<std::string> keys(const nlohmann::json& object) {
  std::set<std::string> names;
  for (const auto& [key, value] : object.items()) names.insert(key);
  return names;
}

const nlohmann::json full = nlohmann::json::parse(R"json({
  "name": "bench", "effects": [{"id": "backlash", "joint": 2, "parameters": {"b": 0.03}, "strength_sigma": 7.5}],
  "equivalent": [["joint_stop(2)"]], "strength_sigma": 12.5, "noise": "declared", "noise_scale": 1.25,
  "description": "a thinner pin", "family": "pins", "channel": "Fx"})json");

}  // namespace

TEST_CASE("a label has the keys of its schema, and all are read") {
  const std::string path = PLUMBLINE_SOURCE_DIR "/docs/schemas/label.schema.json";
  const nlohmann::json schema = parse_json(read_text(path), path);
  CHECK(keys(full) == keys(schema["properties"]));
  CHECK(keys(full["effects"][0]) == keys(schema["properties"]["effects"]["items"]["properties"]));
  CHECK(nlohmann::json(as_json(label_from(full, "test"))) == full);
}

TEST_CASE("a cause outside the catalogue is unknown to the diagnosis, and described by its name") {
  const Label label = label_from(full, "test");
  CHECK(as_json(in_terms_of({{"backlash(j)", "backlash"}, {"play", "play"}}, label)) == as_json(label));
  const Label lacking = in_terms_of({{"backlash", "backlash"}, {"play", "play"}}, label);
  CHECK(outside_catalogue(lacking));
  CHECK(lacking.effects.front().joint == 2);
  CHECK(lacking.equivalent.empty());
  CHECK(lacking.description == "backlash: a thinner pin");
  Label two = label;
  two.effects.push_back({"play", 0, {}, 9});
  CHECK(as_json(in_terms_of({{"backlash(j)", "backlash"}, {"play", "play"}}, two)) == as_json(two));
  CHECK(in_terms_of({{"backlash(j)", "backlash"}}, two).description == "play: a thinner pin");
  CHECK(in_terms_of({{"backlash(j)", "backlash"}}, two).effects.size() == 1);
  // at whichever joint it is: a row for one joint will do
  Label anywhere = label;
  anywhere.effects.front().joint = 0;
  CHECK(as_json(in_terms_of({{"backlash(j)", "backlash"}}, anywhere)) == as_json(anywhere));
  for (const char* none : {R"({"effects": []})", R"({"effects": [{"id": "unknown"}]})"})
    CHECK(as_json(in_terms_of({}, label_from(nlohmann::json::parse(none), ""))) ==
          as_json(label_from(nlohmann::json::parse(none), "")));
}

TEST_CASE("an invalid label is refused in one line") {
  CHECK_THROWS_WITH_AS(label_from(nlohmann::json::array(), "x/label.json"), doctest::Contains("x/label.json"),
                       Error);
  const auto nameless = nlohmann::json::parse(R"({"effects": [{"joint": 1}]})");
  CHECK_THROWS_WITH_AS(label_from(nameless, "x/label.json"),
                       doctest::Contains("x/label.json, effects[1]: found no key \"id\""), Error);
}
