#pragma once
/// \file
/// Critical forces of the straight chain by a two-term recursion (proofs/theorems.md, theorem "Recursion").
///
/// With z_i = L_i + … + L_n, r_i = z_i^2 / k_i and p_i = z_i z_{i+1} / L_i,
///
///     h_1 = 1, g_1 = k_1 / z_1^2;   g_{i+1} = g_i - F h_i / p_i,   h_{i+1} = h_i + r_{i+1} g_{i+1}.
///
/// The critical forces are the roots of h_n(F); the number of sign changes in h_1 … h_n counts those below F.

#include <plumbline/mode.hpp>

namespace plumbline {

/// The number of critical forces below F.
/// \throws Error for n = 1 or a mechanism
template <Ordered Real>
std::size_t count_below(const Chain<Real>& chain, const Real& F) {
  mode_count(chain);
  const std::vector<Real> z = distance_to_end(chain);
  Real h(1), g = chain.stiffness()[0] / (z[0] * z[0]);
  std::size_t count = 0;
  bool negative = false;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    g = g - F * h * chain.length()[i - 1] / (z[i - 1] * z[i]);
    const Real& k = chain.stiffness()[i];
    if (k == Real(0)) {  // r infinite: h becomes g, and what is left of g is nothing
      h = g;
      g = Real(0);
      if (h == Real(0))
        h = negative ? Real(-1) : Real(1);  // F is a critical force of the part below: start afresh
    } else {
      h = h + z[i] * z[i] / k * g;
    }
    const bool now_negative = h == Real(0) ? negative : h < Real(0);
    count += now_negative != negative ? 1 : 0;
    negative = now_negative;
  }
  return count;
}

}  // namespace plumbline
