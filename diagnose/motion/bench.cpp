#include "diagnose/motion/bench.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/base/parallel.hpp>

#include "diagnose/motion/roll_out.hpp"

namespace plumbline::motion {
namespace {

/// Duration of a segment: a number of the method, s. It is long beside every delay, and short beside the time
/// after which a small error owns the rest.
constexpr double segment_duration = 2;
/// The angle at the begin of a segment is known to so many times the noise, its speed not at all: a parabola
/// through readings follows no servo that catches its command.
constexpr double begin_known = 10;

/// What the model leaves to the fit: begins at its typical size.
std::vector<Parameter> unknown_parameters(const Sizes& sizes, const std::vector<Term>& unknown) {
  std::vector<Parameter> all;
  for (const Stated& number : stated_numbers(sizes)) {
    if (std::find(unknown.begin(), unknown.end(), number.term) == unknown.end()) continue;
    const double far = 1e4 * number.typical;
    all.push_back({{number.id, number.unit, diagnose::Coordinate::plain, number.typical,
                    number.signed_ ? -far : 0, far},
                   {number.term},
                   number.signed_ ? 0 : number.typical});
  }
  return all;
}

}  // namespace

std::string Candidate::label() const {
  std::string text;
  for (const Row* row : rows) text += (text.empty() ? "" : " + ") + std::string(row->id);
  return text;
}

bool Candidate::has(const Row& row) const {
  return std::find(rows.begin(), rows.end(), &row) != rows.end();
}

Study::Study(Bench bench)
    : bench_(std::move(bench)),
      sizes_(bench_.logs),
      unknown_(unknown_parameters(sizes_, bench_.unknown)),
      rows_(catalogue(sizes_, bench_.nominal, bench_.unknown)),
      segments_(segments_of(bench_.logs, segment_duration)) {
  for (const Segment& one : segments_) begins_.push_back(initial_state(bench_.logs[one.log], one.first));
}

std::vector<Parameter> Study::parameters(const Candidate& candidate) const {
  std::vector<Parameter> all = unknown_;
  for (const Row* row : candidate.rows) all.insert(all.end(), row->parameters.begin(), row->parameters.end());
  return all;
}

Drive<double> Study::drive(const std::vector<Parameter>& parameters,
                           const std::vector<double>& values) const {
  Drive<double> drive = bench_.nominal;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    for (const Term term : parameters[p].terms) drive[term] += values[p];
  return drive;
}

SegmentMeans Study::left_of(std::size_t segment, const std::vector<Parameter>& parameters,
                            const std::vector<double>& values) const {
  constexpr int at_begin = static_cast<int>(most_parameters);
  using Number = Dual<at_begin + 2>;
  const Drive<double> drive = this->drive(parameters, values);
  Drive<Number> carried;
  for (std::size_t t = 0; t < static_cast<std::size_t>(Term::count); ++t)
    carried[static_cast<Term>(t)] = Number(drive[static_cast<Term>(t)]);
  for (std::size_t p = 0; p < parameters.size(); ++p)
    for (const Term term : parameters[p].terms) carried[term].derivative(static_cast<Eigen::Index>(p)) = 1;
  const Segment& place = segments_[segment];
  const MotionLog& log = bench_.logs[place.log];
  const InitialState& begin = begins_[segment];
  const std::vector<Number> angle = roll_out(carried, log, place, Number::variable(begin.q, at_begin),
                                             Number::variable(begin.v, at_begin + 1));

  std::vector<std::size_t> first{0};
  for (std::size_t k = 1; k < angle.size(); ++k)
    if (log.time[place.first + k] - log.time[place.first + first.back()] >= mean_duration) first.push_back(k);
  const auto rows = static_cast<Eigen::Index>(first.size()),
             columns = static_cast<Eigen::Index>(parameters.size());
  first.push_back(angle.size());
  SegmentMeans left{Eigen::VectorXd::Zero(rows), Eigen::VectorXd::Zero(rows), Eigen::MatrixXd(rows, columns),
                    Eigen::MatrixXd(rows, 2), Eigen::VectorXd(rows)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const std::size_t from = first[static_cast<std::size_t>(i)], to = first[static_cast<std::size_t>(i) + 1];
    const auto count = static_cast<double>(to - from);
    Number sum;
    for (std::size_t k = from; k < to; ++k) {
      left.time(i) += log.time[place.first + k] / count;
      left.residual(i) += log.position[place.first + k] / count;
      sum = sum + angle[k];
    }
    const Number mean = sum / count;
    left.residual(i) -= mean.value;
    left.slopes.row(i) = mean.derivative.head(columns).matrix().transpose();
    left.initial.row(i) << mean.derivative(at_begin) * begin_known * bench_.sigma,
        mean.derivative(at_begin + 1) * sizes_.speed;
    left.variance(i) = bench_.sigma * bench_.sigma / count;
  }
  return left;
}

std::vector<SegmentMeans> Study::left(const std::vector<Parameter>& parameters,
                                      const std::vector<double>& values) const {
  std::vector<SegmentMeans> all(segments_.size());
  in_parallel(all.size(), available_threads(),
              [&](std::size_t s) { all[s] = left_of(s, parameters, values); });
  return all;
}

std::vector<double> predicted(const Drive<double>& drive, const MotionLog& log) {
  const InitialState begin = initial_state(log, 0);
  return roll_out(drive, log, {0, 0, log.time.size()}, begin.q, begin.v);
}

double error_of(const Drive<double>& drive, const MotionLog& log) {
  const std::vector<double> angle = predicted(drive, log);
  double sum = 0;
  for (std::size_t k = 0; k < angle.size(); ++k) sum += std::abs(angle[k] - log.position[k]);
  return sum / static_cast<double>(angle.size());
}

}  // namespace plumbline::motion
