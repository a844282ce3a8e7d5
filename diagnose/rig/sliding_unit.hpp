#pragma once
/// \file
/// The units of the catalogue's parameters at a joint that slides.

#include <array>
#include <string_view>
#include <utility>

namespace plumbline::diagnose {

/// The unit of a joint that turns, as that of one that slides: "N m/rad" is "N/m". Others stay.
constexpr std::string_view sliding_unit(std::string_view turning) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> all{{{"rad", "m"},
                                                                              {"N m", "N"},
                                                                              {"N m/rad", "N/m"},
                                                                              {"N m/s", "N/s"},
                                                                              {"1/rad", "1/m"},
                                                                              {"1/rad²", "1/m²"},
                                                                              {"rad/s", "m/s"},
                                                                              {"rad/(N m)", "m/N"}}};
  for (const auto& [turns, slides] : all)
    if (turns == turning) return slides;
  return turning;
}

}  // namespace plumbline::diagnose
