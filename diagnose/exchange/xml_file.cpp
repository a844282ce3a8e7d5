#include "diagnose/exchange/xml_file.hpp"

#include <algorithm>
#include <cstring>
#include <sstream>

#include "diagnose/exchange/xml.hpp"
#include "diagnose/exchange/xml_document.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::exchange {
namespace {

using pugi::xml_node;

constexpr const char* blanks = " \t\r\n";

/// Where a node without a name or text stands, nothing tells: an empty comment.
void remove_empty(xml_node parent) {
  for (xml_node child = parent.first_child(); child;) {
    const xml_node next = child.next_sibling();
    if (child.offset_debug() < 0) {
      parent.remove_child(child);
    } else {
      remove_empty(child);
    }
    child = next;
  }
}

std::string start_of(xml_node node) {
  std::string text = std::string("<") + node.name();
  for (const pugi::xml_attribute one : node.attributes())
    text += std::string(" ") + one.name() + "=\"" + escaped(one.value()) + "\"";
  return text;
}

}  // namespace

XmlFile::XmlFile(const std::filesystem::path& file) : source_(files::read_text(file)) {
  parse(source_, file.string(), document);
  line_end_ = source_.find("\r\n") == std::string::npos ? "\n" : "\r\n";
  remove_empty(document);
  Origin whole{{0, source_.size()}};
  whole.closing = {source_.size(), source_.size()};
  register_children(document, whole);
  origins_[document] = std::move(whole);
}

std::size_t XmlFile::after(const char* mark, std::size_t from) const {
  const std::size_t at = source_.find(mark, from);
  return at == std::string::npos ? source_.size() : at + std::strlen(mark);
}

void XmlFile::register_children(xml_node parent, Origin& origin) {
  for (const xml_node child : parent.children()) {
    register_node(child);
    origin.children.push_back(child);
  }
}

XmlFile::Span XmlFile::register_node(xml_node node) {
  const auto at = static_cast<std::size_t>(node.offset_debug());
  Origin own{{at, at}};
  switch (node.type()) {
    case pugi::node_element:
      own = element(node, at - 1);
      break;
    case pugi::node_comment:
      own.all = {at - std::strlen("<!--"), after("-->", at)};
      break;
    case pugi::node_cdata:
      own.all = {at - std::strlen("<![CDATA["), after("]]>", at)};
      break;
    case pugi::node_doctype:
      own.all = {source_.rfind("<!DOCTYPE", at), at + std::strlen(node.value()) + 1};
      break;
    case pugi::node_declaration:
    case pugi::node_pi:
      own.all = {at - std::strlen("<?"), after("?>", at)};
      break;
    default:
      own.all.last = std::min(source_.find('<', at), source_.size());
  }
  own.value = node.value();
  const Span all = own.all;
  origins_[node] = std::move(own);
  return all;
}

XmlFile::Origin XmlFile::element(xml_node node, std::size_t first) {
  Origin own{{first, first}};
  std::size_t at = first + 1 + std::strlen(node.name());
  own.name = {first + 1, at};
  for (const pugi::xml_attribute one : node.attributes()) {
    own.attributes.push_back(attribute_at(at));
    own.attributes.back().name = one.name();
    own.attributes.back().value = one.value();
  }
  at = after(">", at);
  own.tag = {first, at};
  own.all.last = at;
  if (source_[at - 2] == '/') return own;
  register_children(node, own);
  if (!own.children.empty()) at = origins_.at(own.children.back()).all.last;
  own.closing.first = source_.find("</", at);
  own.all.last = own.closing.last = after(">", own.closing.first);
  return own;
}

/// \param at  before its blanks; then after its quotes
XmlFile::Attribute XmlFile::attribute_at(std::size_t& at) const {
  Attribute one;
  const std::size_t opening = source_.find_first_of("\"'", at);
  const std::size_t closing = source_.find(source_[opening], opening + 1);
  one.all = {at, closing + 1};
  one.quoted = {opening + 1, closing};
  at = closing + 1;
  return one;
}

std::string XmlFile::text(const std::vector<std::string>& lines) const {
  const Origin& whole = origins_.at(document);
  const xml_node root = document.document_element();
  const std::string above = content(document, whole);
  const std::size_t before = origins_.at(root).all.first;  // nothing above the root is edited
  return above.substr(0, before) + "<!--" + comment(lines, line_end_) + "-->" + line_end_ +
         above.substr(before);
}

std::string XmlFile::written(xml_node node, const std::string& indent) const {
  const auto found = origins_.find(node);
  if (found == origins_.end()) return added(node, indent);
  const Origin& own = found->second;
  if (node.type() != pugi::node_element)
    return own.value == node.value() ? bytes(own.all) : escaped(node.value());
  const std::string inside = content(node, own), start = start_tag(node, own);
  if (own.closing.last > 0)
    return start + inside + "</" + node.name() +
           bytes({own.closing.first + 2 + own.name.last - own.name.first, own.closing.last});
  if (inside.empty()) return start;
  const std::string open = start.substr(0, start.find_last_not_of(blanks, start.size() - 3) + 1) + ">";
  return open + inside + "</" + node.name() + ">";
}

std::string XmlFile::start_tag(xml_node node, const Origin& origin) const {
  std::string text = std::string("<") + node.name();
  std::size_t at = origin.name.last;
  std::vector<std::string> known;
  for (const Attribute& old : origin.attributes) {
    known.push_back(old.name);
    const pugi::xml_attribute now = node.attribute(old.name.c_str());
    at = old.all.last;
    if (!now) continue;
    text += old.value == now.value() ? bytes(old.all)
                                     : bytes({old.all.first, old.quoted.first}) + escaped(now.value()) +
                                           bytes({old.quoted.last, old.all.last});
  }
  for (const pugi::xml_attribute one : node.attributes())
    if (std::find(known.begin(), known.end(), one.name()) == known.end())
      text += std::string(" ") + one.name() + "=\"" + escaped(one.value()) + "\"";
  return text + bytes({at, origin.tag.last});
}

/// What was there in its place with the blanks before it; what was not in lines of its own.
std::string XmlFile::content(xml_node node, const Origin& origin) const {
  const std::vector<xml_node>& old = origin.children;
  const std::string indent = indent_of_children(origin);
  std::string text;
  bool own_line = false;
  std::size_t at = origin.tag.last, next = 0;
  for (const xml_node child : node.children()) {
    const auto kept = std::find(old.begin() + static_cast<std::ptrdiff_t>(next), old.end(), child);
    if (kept == old.end()) {
      own_line = child.type() != pugi::node_pcdata;
      text += own_line ? line_end_ + indent + written(child, indent) : escaped(child.value());
      continue;
    }
    for (; old[next] != child; ++next) at = origins_.at(old[next]).all.last;  // removed
    const Span own = origins_.at(child).all;
    text += bytes({at, own.first}) + written(child, indent);
    at = own.last;
    own_line = false;
    ++next;
  }
  for (; next < old.size(); ++next) at = origins_.at(old[next]).all.last;
  const std::string rest = bytes({at, std::max(at, origin.closing.first)});
  const bool breaks = own_line && rest.find('\n') == std::string::npos;
  return text + (breaks ? line_end_ + indent_before(origin.all.first) : rest);
}

std::string XmlFile::added(xml_node node, const std::string& indent) const {
  if (node.type() != pugi::node_element) {
    std::ostringstream text;
    node.print(text, "", pugi::format_raw);
    return text.str();
  }
  const std::string start = start_of(node);
  if (!node.first_child()) return start + "/>";
  std::string inside;
  bool lines = false;
  for (const xml_node child : node.children()) {
    const bool is_text = child.type() == pugi::node_pcdata;
    lines = lines || !is_text;
    inside += is_text ? escaped(child.value()) : line_end_ + indent + "  " + written(child, indent + "  ");
  }
  return start + ">" + inside + (lines ? line_end_ + indent : "") + "</" + node.name() + ">";
}

/// The blanks with which the line of a place begins.
std::string XmlFile::indent_before(std::size_t at) const {
  const std::size_t line = at == 0 ? 0 : source_.rfind('\n', at - 1) + 1;
  return source_.substr(line, std::min(source_.find_first_not_of(" \t", line), at) - line);
}

bool XmlFile::begins_its_line(std::size_t at) const {
  const std::size_t before = at == 0 ? std::string::npos : source_.find_last_not_of(" \t", at - 1);
  return before == std::string::npos || source_[before] == '\n';
}

std::string XmlFile::indent_of_children(const Origin& origin) const {
  for (const xml_node child : origin.children)
    if (const Span own = origins_.at(child).all;
        child.type() == pugi::node_element && begins_its_line(own.first))
      return indent_before(own.first);
  return indent_before(origin.all.first) + "  ";
}

}  // namespace plumbline::exchange
