#include "tests/diagnose/exchange/urdf_end.hpp"

#include <pugixml.hpp>
#include <sstream>

#include "diagnose/exchange/planar_chain.hpp"
#include "diagnose/exchange/tree.hpp"
#include "diagnose/exchange/urdf_parts.hpp"
#include "diagnose/exchange/xml_document.hpp"

namespace plumbline::exchange {

std::string with_end_kept(const std::string& urdf) {
  pugi::xml_document document;
  if (!document.load_string(urdf.c_str())) return urdf;
  pugi::xml_node root = document.document_element();
  for (const pugi::xml_node joint : root.children("joint")) {
    const std::string link = joint.child("child").attribute("link").value();
    if (std::string(joint.attribute("type").value()) != "fixed" || !names_an_end(link)) continue;
    pugi::xml_node keep = root.append_child("gazebo");
    set(keep, "reference", joint.attribute("name").value());
    set_child(keep, "preserveFixedJoint", "true");
    pugi::xml_node end = named(root, "link", link);
    if (!end || end.child("inertial")) continue;
    append(end, urdf_inertial(speck, {0, 0}, 1e-6));
  }
  std::ostringstream text;
  document.save(text);
  return text.str();
}

}  // namespace plumbline::exchange
