#include "support/page/provenance.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <pugixml.hpp>

#include "support/page/markup.hpp"

using namespace plumbline::page;

namespace {

const Provenance from{"plumbline 1.2.3 (0123456789ab)", "plumbline path 'a<b>.toml' --to 1",
                      std::string(64, 'a')};

std::string text_of(const std::string& document, const char* element) {
  pugi::xml_document xml;
  REQUIRE(xml.load_string(document.c_str(), pugi::parse_default | pugi::parse_doctype));
  const pugi::xpath_node found =
      xml.select_node(("//*[local-name()='" + std::string(element) + "'][last()]").c_str());
  return found.node().text().get();
}

}  // namespace

TEST_CASE("JSON says last where it comes from, null where nothing was read") {
  const auto json = nlohmann::ordered_json::parse(json_text({{"answer", 42}}, from));
  CHECK(json["answer"] == 42);
  CHECK(json.items().begin().key() == "answer");
  CHECK(json["provenance"]["program"] == from.program);
  CHECK(json["provenance"]["command"] == from.command);
  CHECK(json["provenance"]["inputs_sha256"] == from.inputs);
  const auto none = nlohmann::ordered_json::parse(json_text({}, {from.program, from.command, ""}));
  CHECK(none["provenance"]["inputs_sha256"].is_null());
}

TEST_CASE("a drawing and a page stay well-formed, whatever the file is called") {
  const std::string drawing = in_drawing("<svg xmlns=\"http://www.w3.org/2000/svg\"><g/></svg>\n", from);
  CHECK(text_of(drawing, "metadata") ==
        from.program + ": " + from.command + "; SHA-256 of its inputs: " + from.inputs);
  const std::string page = on_page(document("A", "of", "<p>it</p>\n"), from);
  CHECK(text_of(page, "code") == from.command);
}

TEST_CASE("a page names files without their folders, and stands in the landmark at its end") {
  const Provenance asked{"plumbline", "plumbline diagnose /home/anna/lab --model ../models/arm.xml", ""};
  const std::string page = on_page(document("A", "of", "<p>it</p>\n<footer>\n</footer>\n"), asked);
  CHECK(text_of(page, "code") == "plumbline diagnose lab --model arm.xml");
  CHECK(page.find("provenance") < page.find("</footer>"));
  CHECK(on_page("<body></body>", asked).find("</footer>") != std::string::npos);
}

TEST_CASE("the date of a page is that of SOURCE_DATE_EPOCH") {
  setenv("SOURCE_DATE_EPOCH", "86400", 1);
  CHECK(on_page("<body></body>", from).find("Made on 1970-01-02 by") != std::string::npos);
  unsetenv("SOURCE_DATE_EPOCH");
  CHECK(on_page("<body></body>", from).find("Made on 20") != std::string::npos);
}

TEST_CASE("the command for a fleet of thousands does not fill its page") {
  std::string command = "plumbline diagnose";
  for (int i = 0; i < 5000; ++i) command += " lab/arm-" + std::to_string(i);
  CHECK(on_page("<body></body>", {from.program, command, ""}).size() < 1000);
  CHECK(json_text({}, {from.program, command, ""}).find("lab/arm-4999") != std::string::npos);
}
