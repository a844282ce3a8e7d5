#pragma once
/// \file
/// Readings that a log may hold beside position, and what is wrong with such readings.

#include <array>
#include <string_view>

#include "diagnose/motion/drive.hpp"

namespace plumbline::motion {

enum class Channel : std::size_t {
  velocity,  ///< rad/s, on the encoder's side
  duty,      ///< that the servo asks for, -1 to 1
  torque,    ///< of the motor, less what its back EMF takes, N m
  count
};
inline constexpr auto channel_count = static_cast<std::size_t>(Channel::count);

/// What can be wrong with a reading, as a row of the catalogue.
struct ReadingError {
  std::string_view id, words;
  Term term;
};

struct ChannelKind {
  std::string_view name;  ///< of its key
  std::string_view unit;
  std::string_view of;  ///< what the log itself shows, in whose unit its look counts
  ReadingError scale, zero, delay;
};

/// In the order of Channel.
inline constexpr std::array<ChannelKind, channel_count> channel_kinds{
    {{"velocity",
      "rad/s",
      "times the speed of the positions",
      {"velocity_scale", "a scale of the velocity's reading", Term::velocity_scale},
      {"velocity_zero", "a zero of the velocity's reading", Term::velocity_zero},
      {"velocity_delay", "a late reading of velocity", Term::velocity_delay}},
     {"duty",
      "ratio",
      "times the duty by the command",
      {"duty_scale", "a scale of the duty's reading", Term::duty_scale},
      {"duty_zero", "a zero of the duty's reading", Term::duty_zero},
      {"duty_delay", "a late reading of duty", Term::duty_delay}},
     {"torque",
      "N m",
      "N m/V times the voltage by the command",
      {"torque_scale", "a scale of the torque's reading", Term::torque_scale},
      {"torque_zero", "a zero of the torque's reading", Term::torque_zero},
      {"torque_delay", "a late reading of torque", Term::torque_delay}}}};

inline const ChannelKind& kind_of(Channel channel) {
  return channel_kinds[static_cast<std::size_t>(channel)];
}

/// The quantity itself, without the errors of its reading.
template <class Real>
Real quantity_of(Channel channel, const Drive<Real>& drive, const Motion<Real>& state,
                 const Imposed<Real>& now) {
  const Real speed = state.speed(now.encoder);
  switch (channel) {
    case Channel::velocity:
      return speed / (1 + drive[Term::clock_rate]);
    case Channel::duty:
      return now.powered ? state.asked : Real(0);
    default:
      return now.powered
                 ? drive[Term::stall_torque] * now.supply * state.acting - drive[Term::back_emf] * speed
                 : Real(0);
  }
}

}  // namespace plumbline::motion
