#pragma once
/// \file
/// Logs and the model with which they are compared; and what follows from them once and for all.

#include <filesystem>
#include <optional>

#include "diagnose/motion/catalogue.hpp"
#include "diagnose/motion/channel_look.hpp"

namespace plumbline::motion {

/// The file that the numbers of the drive come from, for corrections.
struct ModelFile {
  std::filesystem::path file;  ///< empty without one
  std::string joint;           ///< its name; empty where it is the only one
  std::optional<double> gain;  ///< of its servo, duty per rad
  std::string actuator;        ///< name that BAM has for it
};

/// An experiment as it was read.
struct Bench {
  std::string name;
  std::vector<MotionLog> logs;      ///< that models are fitted to
  std::vector<MotionLog> held_out;  ///< that they are judged by
  Drive<double> nominal;            ///< the numbers that the model states; the others are zero
  std::vector<Term> unknown;        ///< stated as unknown: fitted beside every cause
  std::vector<double> periods;      ///< in a turn of the joint, that its torque may have
  double sigma = 0;                 ///< standard deviation of a reading of position, rad
  std::array<double, channel_count> sigma_beside{};  ///< the same of the channels, in their units
  std::vector<ChannelLook> channels = {};            ///< those that are read beside position
  ModelFile model = {};
};

/// Rows that act together.
struct Candidate {
  std::vector<const Row*> rows;
  /// "command_delay + load_friction"
  [[nodiscard]] std::string label() const;
  [[nodiscard]] bool has(const Row& row) const;
};

/// Angle and speed at the begin of a segment, less a parabola's through its first readings, in units of the
/// motion's own: neither is known beforehand.
using Begin = Eigen::Vector2d;

/// The number of a quantity that is read: position, then the channels.
inline constexpr std::size_t quantity_count = 1 + channel_count;
using Quantities = std::array<double, quantity_count>;

/// The means of neighbouring readings of a segment, with their derivatives.
struct SegmentMeans {
  std::size_t log;
  std::vector<std::size_t> quantity;  ///< that each is of
  Eigen::VectorXd time;               ///< s
  Eigen::VectorXd residual;           ///< measured - predicted from `begin`, in the unit of its quantity
  Eigen::MatrixXd slopes;             ///< of the prediction by the parameters
  Eigen::MatrixXd initial;            ///< the same by the begin
  Eigen::VectorXd variance;           ///< of the noise of readings
  Begin begin;
};

/// Durations of segments, s. A segment is long beside every delay, and short beside the time after which a
/// small error owns the rest; fits from far away begin with short ones, in which no error grows.
inline constexpr double segment_duration = 2, short_segment = 0.4;

/// The bench under study.
class Study {
 public:
  explicit Study(Bench bench, double duration = segment_duration);

  [[nodiscard]] const Bench& bench() const { return bench_; }
  [[nodiscard]] const Sizes& sizes() const { return sizes_; }
  /// Standard deviation of a reading, by quantity.
  [[nodiscard]] Quantities sigmas() const;
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

  /// The unknown numbers of the drive, then the parameters of the rows.
  [[nodiscard]] std::vector<Parameter> parameters(const Candidate& candidate) const;
  [[nodiscard]] std::size_t unknowns() const { return unknown_.size(); }

  /// The drive with these values.
  [[nodiscard]] Drive<double> drive(const std::vector<Parameter>& parameters,
                                    const std::vector<double>& values) const;

  /// Begins by the parabolas alone.
  [[nodiscard]] std::vector<Begin> rough_begins() const {
    return std::vector<Begin>(segments_.size(), Begin::Zero());
  }
  /// The error of the prediction by steps of finite length, root mean square by log: from steps of half the
  /// length, for it falls with the square of the length.
  [[nodiscard]] std::vector<Quantities> numerical_errors(const std::vector<Parameter>& parameters,
                                                         const std::vector<double>& values,
                                                         const std::vector<Begin>& begins) const;
  /// What is left of every segment, or of one in `every` of them.
  [[nodiscard]] std::vector<SegmentMeans> left(const std::vector<Parameter>& parameters,
                                               const std::vector<double>& values,
                                               const std::vector<Begin>& begins, std::size_t every = 1) const;

 private:
  /// Steps by which the stated model computes the motions well within the noise, of segments and of logs.
  void resolve_motions();
  template <int size>
  [[nodiscard]] SegmentMeans left_of(std::size_t segment, const std::vector<Parameter>& parameters,
                                     const std::vector<double>& values, const Begin& begin) const;

  Bench bench_;
  Sizes sizes_;
  std::vector<Parameter> unknown_;
  std::vector<Row> rows_;
  std::vector<Segment> segments_;
  std::vector<InitialState> begins_;  ///< by segment
};

/// Most parameters of a hypothesis; so many derivatives are carried through a roll-out.
inline constexpr std::size_t most_parameters = 14;

/// Duration of the means of neighbouring readings, s: a number of the method.
inline constexpr double mean_duration = 0.05;

/// The positions of a log that is rolled out whole, from the state at its first reading with which its first
/// three tenths of a second are predicted best.
std::vector<double> predicted(const Drive<double>& drive, const MotionLog& log);
/// Mean of |predicted - measured|, rad.
double error_of(const Drive<double>& drive, const MotionLog& log);

}  // namespace plumbline::motion
