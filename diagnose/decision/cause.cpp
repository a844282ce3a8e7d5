#include "diagnose/decision/cause.hpp"

namespace plumbline::diagnose {

std::string verdict_word(CauseVerdict verdict) {
  switch (verdict) {
    case CauseVerdict::none:
      return "none";
    case CauseVerdict::identified:
      return "identified";
    case CauseVerdict::ambiguous:
      return "ambiguous";
    case CauseVerdict::unknown:
      break;
  }
  return "unknown";
}

std::string reservation_words(Reservation reservation) {
  switch (reservation) {
    case Reservation::none:
      break;
    case Reservation::not_tested:
      return "no readings that can be held out show enough of the gap to test it";
    case Reservation::not_predicted:
      return "fitted without the held-out readings, it does not predict them";
    case Reservation::one_run:
      return "it shows in one run alone, so that no other run tests where it sets in: a wall, or "
             "whatever else the chain met there, would do the same";
    case Reservation::beyond_noise:
      return "it leaves more than the readings scatter, though no more than is tolerated";
    case Reservation::small_gap:
      return "it takes two effects, and noise is more than a tenth of the gap in the readings held out: so "
             "much two may imitate of a third";
    case Reservation::many_values:
      return "an effect with a value at every joint, link or run, many of them or beside another effect, "
             "explains much that it is not";
    case Reservation::machining_alone:
      return "what machining leaves has values at every joint or link, in which a cause of another kind may "
             "hide";
    case Reservation::shape_alone:
      return "it says how a torque goes with the angle, not why: a plateau, or whatever else gives way or "
             "stiffens smoothly, looks the same";
    case Reservation::load_alone:
      return "it is friction that goes with the load and hardly has a part of its own: that of a pulley or a "
             "drive in front of the chain looks the same";
    case Reservation::camera:
      return "in two effects it does what positions that are read turned or scaled as a whole do in one: a "
             "camera or a scale that is off looks the same";
    case Reservation::many_times:
      return "it says how a torque relaxes, not why: three times draw whatever relaxes over decades, as by a "
             "power of time";
    case Reservation::beyond_tolerance:
      return "its tolerances are wider than machining leaves";
    case Reservation::single_joint:
      return "it closes most of the gap, beside a spring that is not as it was believed, but leaves more "
             "than the readings scatter";
  }
  return "";
}

}  // namespace plumbline::diagnose
