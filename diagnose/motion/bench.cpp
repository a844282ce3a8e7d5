#include "diagnose/motion/bench.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/base/parallel.hpp>
#include <set>

#include "diagnose/motion/roll_out.hpp"

namespace plumbline::motion {
namespace {

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

Study::Study(Bench bench, double duration)
    : bench_(std::move(bench)),
      sizes_(bench_.logs, bench_.nominal),
      unknown_(unknown_parameters(sizes_, bench_.unknown)),
      rows_(catalogue(sizes_, bench_.nominal, bench_.unknown, bench_.periods)),
      segments_(segments_of(bench_.logs, duration)) {
  for (const Segment& one : segments_) begins_.push_back(initial_state(bench_.logs[one.log], one.first));
  resolve_motions();
}

Quantities Study::sigmas() const {
  Quantities all{bench_.sigma};
  std::copy(bench_.sigma_beside.begin(), bench_.sigma_beside.end(), all.begin() + 1);
  return all;
}

std::vector<Parameter> Study::parameters(const Candidate& candidate) const {
  std::vector<Parameter> all = unknown_;
  for (const Row* row : candidate.rows) all.insert(all.end(), row->parameters.begin(), row->parameters.end());
  return all;
}

Drive<double> Study::drive(const std::vector<Parameter>& parameters,
                           const std::vector<double>& values) const {
  Drive<double> drive = bench_.nominal;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    for (const Term term : parameters[p].terms) drive[term] += values[p];
    if (parameters[p].periods) drive[Term::periods] = *parameters[p].periods;
  }
  return drive;
}

namespace {

/// Where the means of a segment begin. One lasts as long as one value is shown, for such readings have one
/// error; and so a value counts once in the variance of a mean.
std::vector<std::size_t> mean_begins(const std::vector<double>& time, const std::vector<double>& shown,
                                     const Segment& place) {
  std::vector<std::size_t> first{0};
  for (std::size_t k = 1; k < place.end - place.first; ++k) {
    const std::size_t now = place.first + k, begin = place.first + first.back();
    const bool moves = shown[now] != shown[now - 1] || shown[now] != shown[begin];
    if (moves && time[now] - time[begin] >= mean_duration) first.push_back(k);
  }
  return first;
}

/// One mean of a quantity, with its derivatives.
template <class Number>
struct Mean {
  std::size_t quantity;
  double time = 0, measured = 0, variance;
  Number predicted{0};
};

/// \param sigma  of one reading
template <class Number>
void add_means(std::vector<Mean<Number>>& means, std::size_t quantity, const MotionLog& log,
               const Segment& place, const std::vector<double>& shown, const std::vector<Number>& predicted,
               double sigma) {
  std::vector<std::size_t> first = mean_begins(log.time, shown, place);
  first.push_back(predicted.size());
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    Mean<Number> mean{quantity, 0, 0, 0, Number(0)};
    const auto count = static_cast<double>(first[i + 1] - first[i]);
    std::set<double> told;
    for (std::size_t k = first[i]; k < first[i + 1]; ++k) {
      mean.time += log.time[place.first + k] / count;
      mean.measured += shown[place.first + k] / count;
      mean.predicted = mean.predicted + predicted[k];
      told.insert(shown[place.first + k]);
    }
    mean.predicted = mean.predicted / count;
    mean.variance = sigma * sigma / static_cast<double>(told.size());
    means.push_back(std::move(mean));
  }
}

}  // namespace

template <int size>
SegmentMeans Study::left_of(std::size_t segment, const std::vector<Parameter>& parameters,
                            const std::vector<double>& values, const Begin& begin) const {
  using Number = Dual<size>;
  constexpr int at_begin = size - 2;
  auto carried = carried_by<Number>(drive(parameters, values));
  for (std::size_t p = 0; p < parameters.size(); ++p)
    for (const Term term : parameters[p].terms) carried[term].derivative(static_cast<Eigen::Index>(p)) = 1;
  const Segment& place = segments_[segment];
  const MotionLog& log = bench_.logs[place.log];
  const InitialState& rough = begins_[segment];
  const Eigen::Vector2d unit(sizes_.angle, sizes_.speed);
  const std::vector<std::vector<Number>> read =
      readings_of(carried, log, place, Number::variable(rough.q + unit(0) * begin(0), at_begin),
                  Number::variable(rough.v + unit(1) * begin(1), at_begin + 1));
  std::vector<Mean<Number>> means;
  add_means(means, 0, log, place, log.position, read[0], bench_.sigma);
  for (std::size_t i = 0; i < log.beside.size(); ++i) {
    const auto channel = static_cast<std::size_t>(log.beside[i].channel);
    add_means(means, 1 + channel, log, place, log.beside[i].value, read[1 + i], bench_.sigma_beside[channel]);
  }
  const auto rows = static_cast<Eigen::Index>(means.size()),
             columns = static_cast<Eigen::Index>(parameters.size());
  SegmentMeans left{place.log,
                    {},
                    Eigen::VectorXd(rows),
                    Eigen::VectorXd(rows),
                    Eigen::MatrixXd(rows, columns),
                    Eigen::MatrixXd(rows, 2),
                    Eigen::VectorXd(rows),
                    begin};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Mean<Number>& mean = means[static_cast<std::size_t>(i)];
    left.quantity.push_back(mean.quantity);
    left.time(i) = mean.time;
    left.residual(i) = mean.measured - mean.predicted.value;
    left.slopes.row(i) = mean.predicted.derivative.head(columns).matrix().transpose();
    left.initial.row(i) = mean.predicted.derivative.tail(2).matrix().transpose() * unit.asDiagonal();
    left.variance(i) = mean.variance;
  }
  return left;
}

namespace {

/// The error of a roll-out by steps of finite length, root mean square by quantity.
Quantities step_error(const Drive<double>& drive, const MotionLog& log, const Segment& segment,
                      const InitialState& begin) {
  Segment halved = segment;
  halved.step /= 2;
  const auto coarse = readings_of(drive, log, segment, begin.q, begin.v),
             fine = readings_of(drive, log, halved, begin.q, begin.v);
  Quantities error{};
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    double squares = 0;
    for (std::size_t k = 0; k < coarse[i].size(); ++k) squares += std::pow(coarse[i][k] - fine[i][k], 2);
    const std::size_t quantity = i == 0 ? 0 : 1 + static_cast<std::size_t>(log.beside[i - 1].channel);
    // It falls with the square of the step: three quarters of it go where the step is halved.
    error[quantity] = 4.0 / 3 * std::sqrt(squares / static_cast<double>(coarse[i].size()));
  }
  return error;
}

}  // namespace

void Study::resolve_motions() {
  constexpr double resolved = 0.1;  // of the noise of a reading
  constexpr int most_halvings = 3;
  std::vector<double> typical;
  for (const Parameter& one : unknown_) typical.push_back(one.guess);
  const Drive<double> stated = drive(unknown_, typical);
  const auto resolve = [&](MotionLog& log, Segment& part) {
    const InitialState begin = initial_state(log, part.first);
    for (int halving = 0; halving < most_halvings; ++halving, part.step /= 2)
      if (step_error(stated, log, part, begin)[0] < resolved * bench_.sigma) break;
    log.step = std::min(log.step, part.step);
  };
  for (Segment& one : segments_) resolve(bench_.logs[one.log], one);
  for (Segment one : segments_of(bench_.held_out, segment_duration)) resolve(bench_.held_out[one.log], one);
}

std::vector<Quantities> Study::numerical_errors(const std::vector<Parameter>& parameters,
                                                const std::vector<double>& values,
                                                const std::vector<Begin>& begins) const {
  const Drive<double> here = drive(parameters, values);
  std::vector<Quantities> error(bench_.logs.size());
  std::vector<double> count(bench_.logs.size());
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    const Segment& place = segments_[s];
    const InitialState begin{begins_[s].q + sizes_.angle * begins[s](0),
                             begins_[s].v + sizes_.speed * begins[s](1), 0};
    const Quantities own = step_error(here, bench_.logs[place.log], place, begin);
    for (std::size_t q = 0; q < quantity_count; ++q) error[place.log][q] += own[q] * own[q];
    ++count[place.log];
  }
  for (std::size_t l = 0; l < error.size(); ++l)
    for (double& one : error[l]) one = std::sqrt(one / std::max(1.0, count[l]));
  return error;
}

std::vector<SegmentMeans> Study::left(const std::vector<Parameter>& parameters,
                                      const std::vector<double>& values, const std::vector<Begin>& begins,
                                      std::size_t every) const {
  // As many derivatives as there are parameters, in steps of what the processor computes at once.
  const auto of = parameters.size() <= 6    ? &Study::left_of<8>
                  : parameters.size() <= 10 ? &Study::left_of<12>
                                            : &Study::left_of<most_parameters + 2>;
  std::vector<SegmentMeans> all((segments_.size() + every - 1) / every);
  in_parallel(all.size(), available_threads(),
              [&](std::size_t i) { all[i] = (this->*of)(i * every, parameters, values, begins[i * every]); });
  return all;
}

namespace {

/// The state at the first reading, by Gauss and Newton's steps from a parabola's.
InitialState settled_state(const Drive<double>& drive, const MotionLog& log) {
  constexpr double duration = 0.3;  // s
  constexpr int most_steps = 5;
  using Number = Dual<2>;
  const auto carried = carried_by<Number>(drive);
  Segment part{0, 0, 0, log.step};
  while (part.end < log.time.size() && log.time[part.end] <= log.time.front() + duration) ++part.end;
  InitialState state = initial_state(log, 0), best = state;
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    const std::vector<Number> angle =
        angles_of(carried, log, part, Number::variable(state.q, 0), Number::variable(state.v, 1));
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    double squares = 0;
    for (std::size_t k = 0; k < angle.size(); ++k) {
      const double residual = log.position[k] - angle[k].value;
      const Eigen::Vector2d slope = angle[k].derivative.matrix();
      normal += slope * slope.transpose();
      right += residual * slope;
      squares += residual * residual;
    }
    if (!(squares < least)) break;
    least = squares, best = state;
    const Eigen::Vector2d by = normal.ldlt().solve(right);
    if (!by.allFinite()) break;
    state.q += by(0), state.v += by(1);
  }
  return best;
}

}  // namespace

std::vector<double> predicted(const Drive<double>& drive, const MotionLog& log) {
  const InitialState begin = settled_state(drive, log);
  return angles_of(drive, log, {0, 0, log.time.size(), log.step}, begin.q, begin.v);
}

double error_of(const Drive<double>& drive, const MotionLog& log) {
  const std::vector<double> angle = predicted(drive, log);
  double sum = 0;
  for (std::size_t k = 0; k < angle.size(); ++k) sum += std::abs(angle[k] - log.position[k]);
  return sum / static_cast<double>(angle.size());
}

}  // namespace plumbline::motion
