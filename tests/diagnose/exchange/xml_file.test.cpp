#include "diagnose/exchange/xml_file.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <sstream>

#include "diagnose/exchange/xml_document.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange {
namespace {

using pugi::xml_node;

/// Blanks, quotes, comments and entities as people and programs write them.
const char* const untidy = R"(<?xml version='1.0' encoding="utf-8"?>
<!-- drawn by hand: 1 < 2 -->
<!DOCTYPE mujoco [ <!ELEMENT mujoco ANY> ]>
<mujoco   model='leg "one"'>
	<option
      gravity = "0 0  -9.810"/><!---->
  <worldbody>  <body name="a&amp;b" pos="0.10 0 0" ><joint name="hip"   damping=".1"/> text &lt; more <geom/>
    </body>
    <![CDATA[ <raw> ]]>
    <?other program?>
  </worldbody>
  <empty></empty>
  <mass>  1.50 </mass>
</mujoco>

<!-- the end -->
)";

const std::vector<std::string> no_lines;

std::string without_head(const std::string& text) {
  const std::string head = "<!--\n-->\n";
  const std::size_t at = text.find(head);
  REQUIRE(at != std::string::npos);
  return std::string(text).erase(at, head.size());
}

XmlFile file_of(const Folder& folder, const std::string& text) {
  folder.write("a.xml", text);
  return XmlFile(folder / "a.xml");
}

/// Without blanks between elements, as the parser sees it.
std::string seen(const pugi::xml_document& document) {
  std::ostringstream text;
  document.save(text, "", pugi::format_raw);
  return text.str();
}

std::string drawn_element(int depth) {
  const std::string name = *rc::gen::element<std::string>("a", "bb", "c:c");
  std::string text = "<" + name;
  const int attributes = *rc::gen::inRange(0, 3);
  for (int i = 0; i < attributes; ++i) {
    const std::string quote = *rc::gen::element<std::string>("\"", "'");
    text += *rc::gen::element<std::string>(" ", "\n   ", "\t") + "k" + std::to_string(i) +
            *rc::gen::element<std::string>("=", " = ") + quote +
            *rc::gen::element<std::string>("1 2.50", "&lt;", "", "x>y") + quote;
  }
  const int children = depth > 0 ? *rc::gen::inRange(0, 4) : 0;
  if (children == 0 && *rc::gen::arbitrary<bool>()) return text + *rc::gen::element<std::string>("/>", " />");
  text += ">";
  for (int i = 0; i < children; ++i)
    text +=
        *rc::gen::element<std::string>("", " ", "\n  ", "<!-- > -->", "words &amp; ", "<![CDATA[</a>]]>") +
        drawn_element(depth - 1);
  return text + *rc::gen::element<std::string>("", "\n") + "</" + name +
         *rc::gen::element<std::string>(">", " >");
}

}  // namespace

TEST_CASE("what is not edited stays byte by byte, but for the comment at the head") {
  const Folder folder;
  CHECK(without_head(file_of(folder, untidy).text(no_lines)) == untidy);
  std::string windows = untidy;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2)
    windows.insert(at, "\r");
  const std::string text = file_of(folder, windows).text({"line"});
  CHECK(text.find("<!--\r\n  line\r\n-->\r\n") != std::string::npos);
  CHECK(text.size() == windows.size() + std::string("<!--\r\n  line\r\n-->\r\n").size());
}

TEST_CASE("an edit changes its own bytes") {
  const Folder folder;
  XmlFile file = file_of(folder, untidy);
  xml_node root = file.document.document_element(), body = root.child("worldbody").child("body");
  set(root.child("option"), "gravity", "0 0 -9.81");  // the same number
  set(body, "pos", "0.1 0 0.2");
  set(body.child("joint"), "frictionloss", "0.1");
  set_child(root, "mass", "2");
  root.child("empty").append_child("one");
  set(root.child("worldbody").append_child("body"), "name", "<new>");
  body.remove_child("geom");
  std::string expected = untidy;
  const auto replace = [&](const std::string& one, const std::string& other) {
    expected.replace(expected.find(one), one.size(), other);
  };
  replace("0.10 0 0", "0.1 0 0.2");
  replace("damping=\".1\"", "damping=\".1\" frictionloss=\"0.1\"");
  replace("  1.50 ", "2");
  replace("<empty></empty>", "<empty>\n    <one/>\n  </empty>");
  replace("<?other program?>", "<?other program?>\n    <body name=\"&lt;new&gt;\"/>");
  replace("<geom/>", "");
  CHECK(without_head(file.text(no_lines)) == expected);
}

TEST_CASE("a drawn file: unedited the same, edited what the edited document is") {
  const Folder folder;
  CHECK(rc::check([&] {
    const std::string text = "<r>" + drawn_element(3) + "\n" + drawn_element(2) + "</r>\n";
    XmlFile file = file_of(folder, text);
    RC_ASSERT(file.text(no_lines) == "<!--\n-->\n" + text);
    std::vector<xml_node> all;
    const auto gather = [&](const auto& self, xml_node node) -> void {
      if (node.type() == pugi::node_element) all.push_back(node);
      for (const xml_node child : node.children()) self(self, child);
    };
    gather(gather, file.document.document_element());
    xml_node one = *rc::gen::elementOf(all);
    switch (*rc::gen::inRange(0, 5)) {
      case 0:
        set(one, "k0", "3 & 4");
        break;
      case 1:
        one.remove_attribute("k1");
        break;
      case 2:
        one.append_child("new").append_child("inner").text() = "1 < 2";
        break;
      case 3:
        one.prepend_child("new");
        break;
      default:
        if (one.parent() != file.document) one.parent().remove_child(one);
    }
    pugi::xml_document again;
    const std::string edited = file.text(no_lines);
    parse(edited, "edited", again);
    again.remove_child(again.first_child());
    RC_ASSERT(seen(again) == seen(file.document));
  }));
}

}  // namespace plumbline::exchange
