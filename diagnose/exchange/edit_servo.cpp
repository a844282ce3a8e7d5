#include "diagnose/exchange/edit_servo.hpp"

#include <plumbline/base/error.hpp>

namespace plumbline::exchange {
namespace {

using pugi::xml_node;

/// <position> has no word for where it is at ease beside its command: <general> has.
void make_general(xml_node servo) {
  servo.set_name("general");
  set(servo, "gaintype", "fixed");
  set(servo, "biastype", "affine");
  for (const char* own : {"kp", "kv", "dampratio"}) servo.remove_attribute(own);
}

}  // namespace

void edit_servo(const MjcfServo& servo, double factor, double moves, const std::string& file) {
  if (factor == 1 && moves == 0) return;
  xml_node own = servo.element;
  const bool by_kp = std::string(own.name()) != "general";
  if (by_kp && moves == 0) {
    set(own, "kp", number(servo.gain * factor));
    return;
  }
  if (by_kp && !servo.special.empty())
    throw Error(place_of(file, own), servo.special, "a servo without, whose rest can be moved");
  if (by_kp) make_general(own);
  std::vector<double> bias = servo.bias;
  bias[1] *= factor;
  bias[0] = bias[0] * factor - servo.gear * bias[1] * moves;
  set(own, "gainprm", number(servo.gain * factor));
  set(own, "biasprm", numbers(bias));
}

}  // namespace plumbline::exchange
