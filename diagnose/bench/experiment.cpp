#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {
namespace {

using Name = Channel::Name;

constexpr std::array<Channel, 2> end_point{{{Name::x}, {Name::y}}};
constexpr std::array<Channel, 2> force{{{Name::Fx}, {Name::Fy}}};

}  // namespace

std::array<Channel, 2> Run::imposed() const {
  return holds_end_point() ? end_point : force;
}

Eigen::Vector2d Run::command(const Reading& reading) const {
  const std::array<Channel, 2> channels = imposed();
  return {channels[0].of(reading), channels[1].of(reading)};
}

std::vector<Channel> Run::measured() const {
  const std::array<Channel, 2>& answer = holds_end_point() ? force : end_point;
  std::vector<Channel> channels(answer.begin(), answer.end());
  for (std::size_t j = 0; !readings.empty() && j < readings.front().q.size(); ++j)
    channels.push_back({Name::q, j});
  return channels;
}

}  // namespace plumbline::diagnose
