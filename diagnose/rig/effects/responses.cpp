#include "diagnose/rig/effects/responses.hpp"

#include "diagnose/rig/sizes.hpp"

namespace plumbline::diagnose {
namespace {

Effect late(const Responder& one, Possible possible, const char* how, const char* parameter,
            double Response::*by) {
  return {.id = one.id,
          .words = one.words + how,
          .dissipates = true,
          .parameters = one_of(ParameterKind::lag, parameter),
          .add =
              [responses = one.responses, by](const Addition& to) {
                for (Response* own : responses(to)) own->*by += to.value[0];
              },
          .possible = std::move(possible)};
}

}  // namespace

std::function<std::vector<Response*>(const Addition& to)> sensors_of(std::vector<Channel::Name> names) {
  return [names = std::move(names)](const Addition& to) {
    std::vector<Response*> all;
    for (const Channel::Name name : names) all.push_back(&to.rig.sensors.responses[name]);
    return all;
  };
}

Effect lagging(const Responder& one, Possible possible, std::string_view form) {
  Effect row = late(one, std::move(possible), " with a time constant", "tau", &Response::lag);
  row.form = form;
  return row;
}

Effect delayed(const Responder& one, Possible possible, std::string_view form) {
  Effect row = late(one, std::move(possible), " with a delay", "delay", &Response::delay);
  row.form = form;
  row.initial_guesses = [](const Place& at, const Excitation&) {
    const double size = of(ParameterKind::lag, "delay", at).scale;
    return InitialGuesses{{{0.0}, {0.3 * size}, {size}, {3 * size}}, 2};
  };
  return row;
}

}  // namespace plumbline::diagnose
