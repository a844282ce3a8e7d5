#include "diagnose/bench/read_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/part_reader.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Parts that were taken at the same times, or a single one.
class Joined {
 public:
  explicit Joined(std::vector<const PartReader*> parts) : parts_(std::move(parts)) {
    for (std::size_t c = 0; c < format().columns.size(); ++c) {
      const auto owner =
          std::find_if(parts_.begin(), parts_.end(), [c](const PartReader* one) { return one->has(c); });
      owners_.push_back(owner == parts_.end() ? parts_.front() : *owner);
      has_wrench_ |= format().columns[c].says == Says::wrench && owner != parts_.end();
    }
    for (const PartReader* other : parts_)
      if (other != parts_.front()) require_same_times(*other);
    rows_ = parts_.front()->rows();
    while (rows_ > 1 && is_empty(rows_ - 1)) --rows_;
  }

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] const PartReader& first() const { return *parts_.front(); }

  [[nodiscard]] Reading reading(std::size_t row, Control control) const {
    const bool one_way = format().end().place.size() == 1, is_free = format().free_end;
    Reading reading{
        value(0, row),
        {no_value, one_way ? 0 : no_value, is_free ? 0 : no_value, one_way || is_free ? 0 : no_value}};
    for (std::size_t c = 0; c < owners_.size(); ++c) {
      const Column& column = format().columns[c];
      const double one = value(c, row);
      if (column.says == Says::channel && owners_[c]->has(c)) column.reads->in(reading) = one;
      if (column.says == Says::command && owners_[c]->has(c)) reading.rest.push_back(one);
      if (column.says == Says::wrench && has_wrench_) reading.wrench.push_back(owners_[c]->has(c) ? one : 0);
      if (column.says == Says::covariate) reading.covariates.push_back(one);
    }
    make_relative(reading);
    require_given(reading, row, control);
    return reading;
  }

  /// What neither channels nor commands say, in the order of the columns.
  [[nodiscard]] std::vector<double> further(std::size_t row) const {
    std::vector<double> all;
    for (std::size_t c = 0; c < owners_.size(); ++c)
      if (format().columns[c].says == Says::other) all.push_back(value(c, row));
    return all;
  }

  [[nodiscard]] std::vector<Origin> origins() const {
    std::vector<Origin> all;
    for (std::size_t c = 0; c < owners_.size(); ++c) all.push_back(owners_[c]->origin(c));
    return all;
  }

 private:
  [[nodiscard]] const SampleFormat& format() const { return first().format(); }

  [[nodiscard]] bool is_empty(std::size_t row) const {
    return std::all_of(parts_.begin(), parts_.end(),
                       [row](const PartReader* one) { return one->is_empty(row); });
  }

  void require_same_times(const PartReader& other) const {
    for (std::size_t row = 0; row < std::max(first().rows(), other.rows()); ++row) {
      if (row >= other.rows())
        throw Error(
            other.source(), fmt::format("{} readings", other.rows()),
            fmt::format("one more, at the time {} of {}", first().written_time(row), first().where(row)));
      if (row >= first().rows())
        throw Error(other.where(row) + ", t", other.written_time(row),
                    fmt::format("{} readings, as in {}", first().rows(), first().source()));
      if (other.value(0, row) != first().value(0, row))
        throw Error(other.where(row) + ", t", other.written_time(row),
                    fmt::format("{}, the time of {}", first().written_time(row), first().where(row)));
    }
  }

  [[nodiscard]] double value(std::size_t c, std::size_t row) const { return owners_[c]->value(c, row); }

  /// The part that has the first column of a key.
  [[nodiscard]] const PartReader& owner_of(std::string_view key) const {
    const auto column =
        std::ranges::find_if(format().columns, [&](const Column& one) { return one.key() == key; });
    return column == format().columns.end()
               ? first()
               : *owners_[static_cast<std::size_t>(column - format().columns.begin())];
  }

  /// Joint angles and commands that count from x, not from the link before.
  void make_relative(Reading& reading) const {
    if (owner_of("q_command").format().absolute_commands)
      std::adjacent_difference(reading.rest.begin(), reading.rest.end(), reading.rest.begin());
    if (!owner_of("q").format().absolute_angles) return;
    const std::ptrdiff_t joints = std::ranges::count(format().columns, "q", &Column::group);
    if (std::ssize(reading.value) < column_q + joints) return;  // none is read
    const auto first = reading.value.begin() + column_q;
    std::adjacent_difference(first, first + joints, first);
  }

  void require_given(const Reading& r, std::size_t row, Control control) const {
    if (std::isnan(r.t)) throw Error(first().where(row) + ", t", "an empty field", "the time of the reading");
    const EndKind& end = format().end();
    const std::vector<Channel>& imposed = control == Control::end_point ? end.place : end.load;
    if (std::ranges::any_of(imposed, [&](const Channel& one) { return std::isnan(one.of(r)); }))
      throw Error(owner_of(imposed.front().label()).where(row), "an empty imposed channel",
                  "the commanded " + imposed.front().label() +
                      (imposed.size() > 1 ? " and " + imposed.back().label() : ""));
    if (std::ranges::any_of(r.rest, [](double angle) { return std::isnan(angle); }))
      throw Error(owner_of("q_command").where(row), "an empty q_command",
                  "the commanded angle of every joint");
    if (std::ranges::any_of(r.wrench, [](double component) { return std::isnan(component); }))
      throw Error(first().where(row), "an empty load", "the load of every reading");
  }

  std::vector<const PartReader*> parts_;
  std::vector<const PartReader*> owners_;  ///< by column of the format, the part that has it
  bool has_wrench_ = false;
  std::size_t rows_ = 0;
};

/// Whether a part follows another, for it has the same columns; else the two are to be joined.
/// \throws Error where they have some columns in common, or no time to be joined by
bool follows(const SamplePart& part, const ColumnPlaces& places, const SamplePart& other,
             const ColumnPlaces& of_other) {
  std::string common;
  bool differs = false;
  for (std::size_t c = 1; c < places.size(); ++c) {
    if (places[c] && of_other[c]) common = part.format.columns[c].channel;
    if (places[c].has_value() != of_other[c].has_value()) differs = true;
  }
  if (!differs) return true;
  if (!common.empty())
    throw Error(part.source, common + " as in " + other.source + ", and other channels",
                "the same channels, to follow it, or different ones alone, to be joined by t");
  for (const auto& [one, of_one] : {std::pair(&other, &of_other), std::pair(&part, &places)})
    if (!of_one->front())
      throw Error(one->source, "no column of t", "the times by which the parts of the run are joined");
  return false;
}

/// \throws Error where some parts follow one another and others are to be joined
bool all_follow(const std::vector<SamplePart>& parts, const std::vector<ColumnPlaces>& places) {
  const bool second = parts.size() == 1 || follows(parts[1], places[1], parts[0], places[0]);
  for (std::size_t p = 2; p < parts.size(); ++p)
    for (std::size_t q = 0; q < p; ++q)
      if (follows(parts[p], places[p], parts[q], places[q]) != second)
        throw Error(parts[p].source,
                    (second ? "other channels than in " : "the channels of ") + parts[q].source,
                    "parts of a run that all follow one another, or are all joined by t");
  return second;
}

void require_order(const Joined& part, std::size_t row, const Reading& now, const Reading& before) {
  if (now.t >= before.t) return;
  throw Error(part.first().where(row) + ", t", part.first().written_time(row),
              row > 0 ? "a time not before the last reading's, " + part.first().written_time(row - 1) +
                            "; where the table goes back in time: its rows turned round"
                      : "a time not before the last one of the part before");
}

}  // namespace

Samples read_samples(const std::vector<SamplePart>& parts, Control control) {
  const std::vector<ColumnPlaces> places = column_places(parts, control);
  const bool follow = all_follow(parts, places);
  std::vector<PartReader> readers;
  readers.reserve(parts.size());  // each is referred to
  for (std::size_t p = 0; p < parts.size(); ++p)
    readers.emplace_back(parts[p], places[p], follow && p > 0 ? &readers[p - 1] : nullptr);
  std::vector<std::vector<const PartReader*>> groups(follow ? parts.size() : 1);
  for (std::size_t p = 0; p < parts.size(); ++p) groups[follow ? p : 0].push_back(&readers[p]);
  Samples samples;
  for (const auto& group : groups) {
    const Joined part(group);
    if (samples.origins.empty()) samples.origins = part.origins();
    for (std::size_t row = 0; row < part.rows(); ++row) {
      samples.readings.push_back(part.reading(row, control));
      samples.further.push_back(part.further(row));
      samples.where.push_back(part.first().where(row));
      if (const std::size_t count = samples.readings.size(); count > 1)
        require_order(part, row, samples.readings[count - 1], samples.readings[count - 2]);
    }
  }
  return samples;
}

}  // namespace plumbline::diagnose
