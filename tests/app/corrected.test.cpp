// `diagnose --corrected` and `--model`, and `chain`, as a user runs them.
#include "tests/app/process.hpp"

TEST_CASE("an experiment has no gap against its own corrected model") {
  const Workplace place;
  const Outcome first = place.plumbline("diagnose --corrected bench.toml");
  REQUIRE(first.status == 0);
  CHECK(contains(first.out, "Corrected model: bench.toml"));
  const Outcome again = place.plumbline("diagnose --model bench.toml --corrected again.toml");
  REQUIRE(again.status == 0);
  CHECK(contains(again.out, "Is there a gap?  No"));
  CHECK(contains(place.read("again.toml"), "id = \"joint_friction\""));
  CHECK(contains(place.plumbline("chain bench.toml").out, "id = \"joint_friction\""));
}

TEST_CASE("a corrected model is written to an allowed place in a known format, or not at all") {
  const Workplace place;
  check_refused(place.plumbline("diagnose --corrected bench.step"));
  check_refused(place.plumbline("diagnose --corrected nowhere/bench.toml"));
  check_refused(place.plumbline("diagnose --corrected bench.toml --json bench.toml"));
  CHECK(place.files() == 0);
  place.write("own.toml",
              "[nominal]\nlink_length = [0.25, 0.25, 0.25, 0.25]\njoint_stiffness = [2, 2, 2, 2]\n");
  check_refused(place.plumbline("diagnose --model own.toml --corrected own.toml"));
  CHECK(contains(place.read("own.toml"), "joint_stiffness = [2, 2, 2, 2]\n"));
  check_refused(place.plumbline("diagnose --model nowhere.toml"));
  check_refused(place.plumbline("chain"));
  place.write("short.toml", "[nominal]\nlink_length = [0.5, 0.5]\njoint_stiffness = [2, 2]\n");
  const Outcome shorter = place.plumbline("diagnose --model short.toml");
  check_refused(shorter);
  CHECK(contains(shorter.err, "found 4 values, expected 2, one for each link of the model that is given"));
  place.write("rust.toml",
              "[nominal]\nlink_length = [0.25, 0.25, 0.25, 0.25]\njoint_stiffness = [2, 2, 2, 2]\n"
              "[[nominal.effect]]\nid = \"rust\"\nparameters = {}\n");
  const Outcome rust = place.plumbline("diagnose --model rust.toml");
  check_refused(rust);
  CHECK(contains(rust.err, "nominal.effect[1].id: found rust"));
}

TEST_CASE("a corrected model with user effects requires --effects") {
  const Workplace place;
  place.write("own.toml",
              "format = \"user-effects/1\"\n[[effect]]\nid = \"stiction\"\nwords = \"stiction\"\n"
              "where = \"every joint\"\ntorque = \"a * s\"\n"
              "[effect.parameters.a]\nunit = \"N m\"\nscale = 0.03\nlow = 0\nhigh = 1\n");
  const std::string nominal =
      "[nominal]\nlink_length = [0.25, 0.25, 0.25, 0.25]\njoint_stiffness = [2, 2, 2, 2]\n"
      "[[nominal.effect]]\nid = \"user:stiction\"\nparameters = { a = 0.035 }\n";
  place.write("known.toml", nominal);
  const Outcome known = place.plumbline(
      "diagnose --model known.toml --effects own.toml --corrected again.toml --json report.json");
  REQUIRE(known.status == 0);
  CHECK(contains(known.out, "Is there a gap?  No"));
  CHECK(contains(known.out, "user:stiction: as [[nominal.effect]], to be read with --effects again"));
  CHECK(contains(place.read("again.toml"), "id = \"user:stiction\"\nparameters = { a = 0.035 }"));
  CHECK(contains(place.plumbline("diagnose --model known.toml --effects own.toml --corrected bench.xml").out,
                 "not carried: user:stiction: an effect of your own"));
  const Outcome unnamed = place.plumbline("diagnose --model known.toml");
  check_refused(unnamed);
  CHECK(contains(unnamed.err, "user:NAME of the file that --effects names"));
}
