#pragma once
/// \file
/// Logs and the model with which they are compared; and what follows from them once and for all.

#include "diagnose/motion/catalogue.hpp"

namespace plumbline::motion {

/// An experiment as it was read.
struct Bench {
  std::string name;
  std::vector<MotionLog> logs;      ///< that models are fitted to
  std::vector<MotionLog> held_out;  ///< that they are judged by
  Drive<double> nominal;            ///< the numbers that the model states; the others are zero
  std::vector<Term> unknown;        ///< stated as unknown: fitted beside every cause
  double sigma = 0;                 ///< standard deviation of a reading of position, rad
};

/// Rows that act together.
struct Candidate {
  std::vector<const Row*> rows;
  /// "command_delay + load_friction"
  [[nodiscard]] std::string label() const;
  [[nodiscard]] bool has(const Row& row) const;
};

/// The means of neighbouring readings of a segment, with their derivatives.
struct SegmentMeans {
  Eigen::VectorXd time;      ///< s
  Eigen::VectorXd residual;  ///< measured - predicted, rad
  Eigen::MatrixXd slopes;    ///< of the prediction by the parameters
  Eigen::MatrixXd initial;   ///< the same by angle and speed at the begin, times their standard deviations
  Eigen::VectorXd variance;  ///< of the noise of readings, rad^2
};

/// The bench under study.
class Study {
 public:
  explicit Study(Bench bench);

  [[nodiscard]] const Bench& bench() const { return bench_; }
  [[nodiscard]] const Sizes& sizes() const { return sizes_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

  /// The unknown numbers of the drive, then the parameters of the rows.
  [[nodiscard]] std::vector<Parameter> parameters(const Candidate& candidate) const;
  [[nodiscard]] std::size_t unknowns() const { return unknown_.size(); }

  /// The drive with these values.
  [[nodiscard]] Drive<double> drive(const std::vector<Parameter>& parameters,
                                    const std::vector<double>& values) const;

  /// What is left of every segment.
  [[nodiscard]] std::vector<SegmentMeans> left(const std::vector<Parameter>& parameters,
                                               const std::vector<double>& values) const;

 private:
  [[nodiscard]] SegmentMeans left_of(std::size_t segment, const std::vector<Parameter>& parameters,
                                     const std::vector<double>& values) const;

  Bench bench_;
  Sizes sizes_;
  std::vector<Parameter> unknown_;
  std::vector<Row> rows_;
  std::vector<Segment> segments_;
  std::vector<InitialState> begins_;  ///< by segment
};

/// Most parameters of a hypothesis; so many derivatives are carried through a roll-out.
inline constexpr std::size_t most_parameters = 14;

/// Duration of the means of neighbouring readings, s.
inline constexpr double mean_duration = 0.05;

/// The positions at the readings of a log that is rolled out whole from its first reading, rad.
std::vector<double> predicted(const Drive<double>& drive, const MotionLog& log);

/// Mean of |predicted - measured| over a log that is rolled out whole from its first reading, rad.
double error_of(const Drive<double>& drive, const MotionLog& log);

}  // namespace plumbline::motion
