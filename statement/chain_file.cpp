#include "statement/chain_file.hpp"

#include "statement/decimal_toml.hpp"

namespace plumbline::statement {
namespace {

/// Where the keys of a chain stand: in the table [nominal], as experiments and `plumbline chain` have it, or
/// in the file itself.
const toml::table& chain_table(const toml::table& file, const std::string& source) {
  const toml::table* const nominal = file["nominal"].as_table();
  if (nominal == nullptr) return file;
  files::refuse_unknown_keys(file, {"nominal"}, source);
  for (const char* beyond : {"effect", "torque_law"})
    if (const toml::node* const more = nominal->get(beyond))
      throw Error(files::place(*more, source), std::string("[[nominal.") + beyond + "]]", "springs alone");
  return *nominal;
}

}  // namespace

StatedChain read_chain(const toml::table& file, const std::string& source) {
  try {
    const toml::table& table = chain_table(file, source);
    if (table.contains("joints")) return read_space(table, source);
    return read_plane(table, source);
  } catch (const Error& error) {  // of the chain's parts, which know no source
    const std::string what = error.what();
    throw Error(what.starts_with(source) ? what : source + ": " + what);
  }
}

StatedChain parse_chain(const std::string& text, const std::string& source) {
  return read_chain(parse_decimal_toml(text, source), source);
}

PlaneChain parse_plane_chain(const std::string& text, const std::string& source) {
  StatedChain chain = parse_chain(text, source);
  if (auto* plane = std::get_if<PlaneChain>(&chain)) return std::move(*plane);
  throw Error(source, "a chain in space", "one in the plane");
}

}  // namespace plumbline::statement
