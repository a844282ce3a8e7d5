#pragma once
/// \file
/// Whether readings that stand off together do so by one event of the device, or each by chance.

#include <functional>

#include "diagnose/outside/outside_cause.hpp"

namespace plumbline::diagnose {

/// An order of the readings of a run, and where in it an event may lie.
struct EventOrder {
  std::size_t run;
  std::vector<std::size_t> readings;
  std::size_t most;       ///< readings of an event, one at least
  bool at_first = false;  ///< events begin at the first of this order; else anywhere
};

/// Logarithm of the Bayes factor of one event over independent outliers. In an event readings that follow
/// each other in one of the orders lie anywhere (the Cauchy density of an outlier), in some of the channels,
/// whichever; every place and length is as probable.
/// \param left   what a model leaves, flat, declared sigmas
/// \param noise  of the readings, with the outliers that were marked
double log_departure(const Measurements& measurements, const VectorXd& left, const NoiseEstimate& noise,
                     const std::vector<EventOrder>& orders);

/// By run: its readings as they were taken; an event is of up to eight in a row, and a quarter of the run.
std::vector<EventOrder> in_order_of_reading(const Measurements& measurements);

/// By run, for every direction in which its command varies: its readings from the farthest on; an event is of
/// up to half of them.
std::vector<EventOrder> from_the_ends(const Measurements& measurements, const CommandStates& states);

/// Readings that follow each other in some order lie anywhere, and nothing is left in the others.
class EventDeparture final : public OutsideCause {
 public:
  using Orders = std::function<std::vector<EventOrder>(const Measurements&, const CommandStates&)>;
  explicit EventDeparture(Orders orders) : orders_(std::move(orders)) {}
  [[nodiscard]] OutsideFit fit(const Leftover& left) const override;

 private:
  Orders orders_;
};

}  // namespace plumbline::diagnose
