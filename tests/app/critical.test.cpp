#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "tests/app/process.hpp"
#include "tests/close_to.hpp"

TEST_CASE("without arguments the command lists its verbs, and critical computes the bundled example") {
  const Workplace here;
  const Outcome help = here.plumbline("");
  CHECK(help.status == 0);
  CHECK(contains(help.out, "critical"));
  CHECK(here.plumbline("critical --help").status == 0);
  const Outcome example = here.plumbline("critical");
  CHECK(example.status == 0);
  CHECK(contains(example.out, "Critical force 0.924027591295903, shape U"));
  CHECK(contains(example.out, "-0.3057"));  // the paper's Table 2, second vector: -0.2026 / 0.6628
}

TEST_CASE("a wrong command line is bad input, and what is wrong of it is said") {
  const Workplace here;
  const struct {
    const char *arguments, *said;
  } cases[] = {
      {"nonsense", "command line: found nonsense, expected one of "},
      {"diagnos fb", "command line: found diagnos, expected diagnose, or one of "},
      {"critical --digts 20", "the nearest option is --digits"},
      {"critical --nonsense", "command line: found --nonsense, expected what --help lists"},
      {"verify folder extra", "command line: found extra, expected what --help lists"},
      {"verify nosuch", "nosuch: found no paper.toml, expected the folder of a paper"},
      {"critical a.toml b.toml", "command line: found b.toml, expected what --help lists"},
      {"critical --digits 0", "--digits: found 0, expected a whole number"},
      {"critical --digits x", "--digits: found x, expected a whole number"},
      {"critical --digits", "--digits: found too few or too many values"},
  };
  for (const auto& [arguments, said] : cases) {
    CAPTURE(arguments);
    const Outcome refused = here.plumbline(arguments);
    check_refused(refused);
    CHECK(contains(refused.err, said));
  }
}

TEST_CASE("the bad chain files are refused in one line that says where, what and what instead") {
  const Workplace here;
  const struct {
    const char *content, *where, *found, *expected;
  } cases[] = {
      {"lengths = [1, -1]\nstiffness = [1, 1]", "lengths, entry 2", "not positive", "positive"},
      {"lengths = [0, 1]\nstiffness = [1, 1]", "lengths, entry 1", "not positive", "positive"},
      {"lengths = [1, nan]\nstiffness = [1, 1]", "bad.toml:1: lengths, entry 2", "nan", "a decimal number"},
      {"lengths = [1, inf]\nstiffness = [1, 1]", "bad.toml:1: lengths, entry 2", "inf", "a decimal number"},
      {"lengths = [1, 'x']\nstiffness = [1, 1]", "bad.toml:1: lengths, entry 2", "x", "a decimal number"},
      {"lengths = [1, 1e999999999]\nstiffness = [1, 1]", "bad.toml:1: lengths, entry 2", "1e999999999",
       "an exponent from -100000 to 100000"},
      {"lengths = [1, 1]\nstiffness = [1, -1e-400]", "stiffness, entry 2", "negative",
       "zero (passive) or positive"},
      {"lengths = [1, 1]\nstiffness = [1]", "stiffness", "1 values", "one per link, 2"},
      {"lengths = [1, 1]\nstiffness = [1, 1]\nrest = [0]", "rest", "1 values", "one per link, 2"},
      {"lengths = [1, 1]\nstiffness = [1, 1]\nmass = [1, 1]", "bad.toml:3", "unknown key mass",
       "one of lengths"},
      {"lengths = [1,\n1,\n # 1, 1\n 1]\nstiffness = [1, 1\n, 1]\nmass = 1", "bad.toml:7", "unknown key mass",
       "one of lengths"},
      {"lengths = [1, 1,\n# 1, 1\n1, -1]\nstiffness = [1, 1, 1]", "bad.toml:1: lengths, entry 4", "-1",
       "a positive length"},
      {"lengths = [1,, 1]\nstiffness = [1, 1]", "bad.toml:1", "not TOML", "key = value"},
      {"lengths = [1, 1]", "bad.toml", "no key stiffness", "expected stiffness = "},
      {"lengths = 1\nstiffness = [1, 1]", "bad.toml:1: lengths", "found 1", "a list"},
      {"lengths = [1, 1]\nstiffness = [1, 1", "bad.toml:2", "not TOML", "key = value"},
      {"lengths = []\nstiffness = []", "lengths", "no link", "at least one"},
      {"lengths = [1]\nstiffness = [1]", "bad.toml: chain", "one link", "two links or more"},
      {"lengths = [1,1,1]\nstiffness = [0,1,0]", "bad.toml: stiffness", "2 passive joints", "at most one"},
      {"", "bad.toml", "an empty file", "some content"},
      {" \n", "bad.toml", "an empty file", "some content"},
  };
  for (const auto& [content, where, found, expected] : cases) {
    CAPTURE(content);
    here.write("bad.toml", content);
    const Outcome outcome = here.plumbline("critical bad.toml --csv out.csv");
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.starts_with("plumbline: bad.toml"));
    CHECK(contains(outcome.err, where));
    const std::size_t at = outcome.err.find(": found ");
    REQUIRE(at != std::string::npos);
    CHECK(contains(outcome.err.substr(at), found));
    const std::size_t instead = outcome.err.find(", expected ", at);
    REQUIRE(instead != std::string::npos);
    CHECK(contains(outcome.err.substr(instead), expected));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(here.files() == 1);  // nothing written
  }
}

TEST_CASE("files that cannot be read or written are named, and nothing is left behind") {
  const Workplace here;
  std::filesystem::create_directory(here.path() / "folder");
  for (const char* arguments :
       {"critical missing.toml", "critical folder", "critical --csv folder", "critical --csv missing/out.csv",
        "critical --json missing/out.json", "critical --csv /dev/full", "critical >/dev/full"}) {
    CAPTURE(arguments);
    const Outcome outcome = here.plumbline(arguments);
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, "expected"));
    CHECK(here.files() == 1);
  }
  here.write("chain.csv", "chain,lengths,stiffness\na,1;1,1;1\n");
  CHECK(here.plumbline("critical chain.csv --csv chain.csv").status == 2);
  CHECK(here.read("chain.csv") == "chain,lengths,stiffness\na,1;1,1;1\n");
}

TEST_CASE("what is written to one file does not depend on the others") {
  const Workplace here;
  here.write("chain.toml", "lengths = [1, 1, 1]\nstiffness = [0, 1, 1]");
  CHECK(here.plumbline("critical chain.toml --csv a.csv").status == 0);
  CHECK(here.plumbline("critical chain.toml --json a.json").status == 0);
  CHECK(here.plumbline("critical chain.toml --csv b.csv --json b.json").status == 0);
  CHECK(here.read("a.csv") == "chain,mode,force\nchain,1,1.00000000000000\nchain,2,3.00000000000000\n");
  CHECK(here.read("b.csv") == here.read("a.csv"));
  CHECK(here.read("b.json") == here.read("a.json"));
}

TEST_CASE("the keys of a chain are those of an experiment too") {
  const Workplace here;
  here.write("chain.toml", "link_length = [1, 1]\njoint_stiffness = [0, 1]");
  CHECK(here.plumbline("critical chain.toml --csv").out == "chain,mode,force\nchain,1,2.00000000000000\n");
  here.write("both.toml", "lengths = [1, 1]\nlink_length = [1, 1]\nstiffness = [0, 1]");
  const Outcome both = here.plumbline("critical both.toml");
  check_refused(both);
  CHECK(both.err ==
        "plumbline: both.toml:2: link_length: found both lengths and this, expected one of the two, which "
        "mean the same\n");
}

TEST_CASE("a chain, a table and values come from standard input too") {
  const Workplace here;
  here.write("chain.toml", "lengths = [1, 1, 1]\nstiffness = [0, 1, 1]");
  here.write("chains.csv", "chain,lengths,stiffness\na,1;1,0;1\n");
  CHECK(here.plumbline("critical - --csv < chain.toml").out ==
        "chain,mode,force\nchain,1,1.00000000000000\nchain,2,3.00000000000000\n");
  CHECK(here.plumbline("critical - --csv < chains.csv").out == "chain,mode,force\na,1,2.00000000000000\n");
  here.write("values.csv", "chain,mode,force\na,1,2.0\n");
  CHECK(here.plumbline("check - --chains chains.csv < values.csv").status == 0);
  here.write("bad.toml", "lengths = [1, -1]\nstiffness = [1, 1]");
  CHECK(here.plumbline("critical - < bad.toml")
            .err.starts_with("plumbline: standard input:1: lengths, entry 2"));
  CHECK(here.plumbline("critical - < /dev/null")
            .err.starts_with("plumbline: standard input: found an empty file"));
}

TEST_CASE("numbers are taken exactly as they are written, far beyond double") {
  const Workplace here;
  // F_c = (k1 z2^2 + k2 z1^2) / (L1 L2 (L1 + L2)), here 5 k / (2 L)
  here.write("huge.toml", "lengths = [1e400, 1e400] # 'quote\nstiffness = [ 1e400, 1_0e399,]");
  CHECK(here.plumbline("critical huge.toml --csv --digits 3").out == "chain,mode,force\nhuge,1,2.50\n");
  here.write("tenth.toml", "stiffness = [0.1, +0.1]\nlengths = [1, 1]");
  here.write("extreme.toml", "lengths = [1e-400, 1e-400]\nstiffness = [1e400, 1e400]");
  CHECK(here.plumbline("critical extreme.toml --csv --digits 3").out ==
        "chain,mode,force\nextreme,1,2.50e+800\n");
  CHECK(here.plumbline("critical extreme.toml --csv --digits 1").out ==
        "chain,mode,force\nextreme,1,3e+800\n");  // exactly half-way: to the larger
  CHECK(here.plumbline("critical tenth.toml --csv --digits 40").out ==
        "chain,mode,force\ntenth,1,0.2500000000000000000000000000000000000000\n");
}

TEST_CASE("in a table a wrong chain has one error line and no rows, and the others are computed") {
  const Workplace here;
  here.write("c.csv",
             "chain,lengths,stiffness\n"
             "good,1;1,1;1\n"
             "negative,1;-1,1;1\n"
             "\n"
             "short,1;1,1\n"
             "good,1;1,1;1\n"
             "mechanism,1;1;1,0;0;1\n"
             "word,1;x,1;1\n"
             "fields,1;1\n"
             "\"a, b\",1;1,2;2\n");
  const Outcome outcome = here.plumbline("critical c.csv --all --digits 5 --csv out.csv");
  CHECK(outcome.status == 2);
  CHECK(here.read("out.csv") == "chain,mode,force\ngood,1,2.5000\n\"a, b\",1,5.0000\n");
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 6);
  for (const char* line :
       {"c.csv:3: chain negative: lengths, entry 2", "c.csv:5: chain short: stiffness: found 1 values",
        "c.csv:6: chain good: found a name that occurred before",
        "c.csv:7: chain mechanism: stiffness: found 2 passive",
        "c.csv:8: chain word: lengths, entry 2: found x", "c.csv:9: found 2 fields, expected 3"}) {
    CAPTURE(line);
    CHECK(contains(outcome.err, line));
  }
  for (const char* content : {"chain,lengths\na,1;1\n", "chain,lengths,stiffness\n",
                              "chain,lengths,stiffness,mass\n", "chain,lengths,stiffness\na,-1;1,1;1\n"}) {
    CAPTURE(content);
    here.write("c.csv", content);
    CHECK(here.plumbline("critical c.csv --csv new.csv").status == 2);
    CHECK(!here.exists("new.csv"));
  }
}

TEST_CASE("a joint that does not turn is told from one that hardly does") {
  const Workplace here;
  here.write("symmetric.toml", "lengths = [1, 1, 1, 1]\nstiffness = [0, 1, 1, 1]");
  CHECK(contains(here.plumbline("critical symmetric.toml").out, "+-0+"));
  here.write("nearly.toml", "lengths = [1, 1, 1, 1.00000000000000000000000000001]\nstiffness = [0, 1, 1, 1]");
  CHECK(!contains(here.plumbline("critical nearly.toml").out, "+-0+"));
}

TEST_CASE("the certificates pass the stand-alone checker") {
  const Workplace here;
  here.write("c.csv",
             "chain,lengths,stiffness\nelastic,0.1;0.2;1e8,1e-8;3;1e8\npassive,1;2;3;4,0;1;1;1\n"
             "tie,1;1;1;1,1;1;0;1\n");
  CHECK(here.plumbline("critical c.csv --all --digits 40 --certify proof.json --csv values.csv").status == 0);
  const std::string check = "python3 '" PLUMBLINE_SOURCE_DIR "/proofs/certificates/check_certificates.py' '";
  CHECK(std::system((check + (here.path() / "proof.json").string() + "' >/dev/null").c_str()) == 0);
}

TEST_CASE("a chain that is not straight has no critical force") {
  const Workplace here;
  here.write("bent.toml", "lengths = [1, 1]\nstiffness = [1, 1]\nrest = [0, 0.1]");
  const Outcome outcome = here.plumbline("critical bent.toml");
  CHECK(outcome.status == 2);
  CHECK(contains(outcome.err, "bent.toml: rest, entry 2: found an angle that is not zero"));
}

TEST_CASE("of a long chain the text shows a thousand angles of a mode and says how many there are more") {
  const Workplace here;
  std::string ones = "1";
  for (int i = 1; i < 1005; ++i) ones += ", 1";
  here.write("long.toml", "lengths = [" + ones + "]\nstiffness = [" + ones + "]\n");
  const std::string text = here.plumbline("critical long.toml").out;
  CHECK(contains(text, "\n    and 5 more: --json"));
  const auto modes =
      nlohmann::json::parse(here.plumbline("critical long.toml --json").out)["chains"][0]["modes"];
  CHECK(modes[0]["q"].size() == 1005);
}

TEST_CASE("the JSON holds every mode with its shape") {
  const Workplace here;
  const auto json = nlohmann::json::parse(here.plumbline("critical --json --digits 20").out);
  const auto& modes = json.at("chains").at(0).at("modes");
  REQUIRE(modes.size() == 3);
  // characteristic polynomial after (40) of the paper: lambda^3 + 9/5 lambda^2 + 9/10 lambda + 2/15 = 0
  for (const auto& mode : modes) {
    const double lambda = -1 / std::stod(mode.at("force").get<std::string>());
    CHECK(std::abs(((lambda + 1.8) * lambda + 0.9) * lambda + 2.0 / 15) < 1e-15);
    CHECK(std::stod(mode.at("energy_factor").get<std::string>()) * lambda == close_to(-1).epsilon(1e-14));
  }
  CHECK(modes[1].at("shape") == "ZU");
  CHECK(modes[1].at("signs") == "+--+");
}
