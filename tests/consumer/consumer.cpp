// The installed core in two number types: the count of critical forces in fractions proves the double.
#include <cstdio>
#include <plumbline/straight/critical_force.hpp>

int main() {
  using namespace plumbline;
  const Chain<double> chain({1, 1, 1, 1}, {1, 1, 1, 1});
  const double force = critical_forces(chain, 1).front();
  const Chain<Rational> exact({1, 1, 1, 1}, {1, 1, 1, 1});
  const Rational low(force * (1 - 1e-15)), high(force * (1 + 1e-15));
  std::printf("critical force %.15g\n", force);
  return count_below(exact, low) == 0 && count_below(exact, high) == 1 ? 0 : 1;
}
