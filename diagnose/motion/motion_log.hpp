#pragma once
/// \file
/// Logs of a joint in motion, as they were read.

#include <string>
#include <vector>

#include "diagnose/motion/channel.hpp"

namespace plumbline::motion {

/// Readings beside position.
struct ChannelReadings {
  Channel channel;
  std::vector<double> value;
};

/// One log. SI units, radians; all lists that are not empty are as long as `time`.
struct MotionLog {
  std::string name;
  std::vector<double> time;      ///< s, ascending
  std::vector<double> command;   ///< rad, held from its stamp to the next
  std::vector<double> position;  ///< rad
  std::vector<double> supply;    ///< V; one where none is read
  std::vector<bool> powered;
  std::vector<ChannelReadings> beside = {};
  std::vector<double> warmer = {};             ///< than the mean of the logs, K; empty where none is read
  std::vector<double> base_acceleration = {};  ///< m/s^2, as Imposed has it; empty where none is read
  std::size_t spikes = 0;                      ///< isolated readings of position that were replaced
  EncoderSide encoder = EncoderSide::joint;
  double gain = 0;      ///< of the servo: duty per rad of error
  double inertia = 0;   ///< of the load about the joint, kg m^2
  double gravity = 0;   ///< moment of the load's weight where it is horizontal, N m
  double step = 0.002;  ///< longest one of a roll-out of all of it, s
};

/// A stretch of a log that is predicted from an initial state of its own.
struct Segment {
  std::size_t log;
  std::size_t first, end;  ///< readings
  double step = 0.002;     ///< longest one of a roll-out, s
};

/// Angle, speed and acceleration at a reading, from a parabola through its neighbours.
struct InitialState {
  double q, v, a;
};

InitialState initial_state(const MotionLog& log, std::size_t reading);

/// Segments of about this duration, s. The first of a log begins a tenth of a second after it, for the
/// command before the log is not known, and a delay makes it act.
std::vector<Segment> segments_of(const std::vector<MotionLog>& logs, double duration);

}  // namespace plumbline::motion
