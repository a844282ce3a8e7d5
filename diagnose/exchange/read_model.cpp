#include "diagnose/exchange/read_model.hpp"

#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/exchange/read_mjcf.hpp"
#include "diagnose/exchange/read_sdf.hpp"
#include "diagnose/exchange/read_urdf.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::exchange {

PlanarChain read_model(const std::filesystem::path& file, const std::vector<std::string>& kept) {
  const auto chain_of = [&](const ReadModel& model) { return planar_chain(model, file.string(), kept); };
  switch (format_of(file)) {
    case Format::mjcf:
      return chain_of(read_mjcf(file));
    case Format::urdf:
      return chain_of(read_urdf(file));
    case Format::sdf:
      return chain_of(read_sdf(file));
    case Format::toml:
      break;
  }
  if (!kept.empty()) throw Error(file.string(), "joints to keep of a chain", "a simulator's model");
  return {diagnose::parse_nominal(files::read_text(file), file.string()), {}};
}

}  // namespace plumbline::exchange
