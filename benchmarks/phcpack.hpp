#pragma once
/// \file
/// PHCpack as a peer of the census: the equilibrium equations as a polynomial system that is nearly the same,
/// all of whose complex roots it follows.

#include <filesystem>
#include <vector>

#include "proofs/census/census_task.hpp"

namespace plumbline::bench {

constexpr double near_enough = 1e-6;  ///< of angles, and of imaginary parts to nothing

/// What is asked, the absolute angle within which the polynomials are near sine and cosine, and their degree.
struct Question {
  proofs::CensusTask task;
  double widest;
  int degree;
};

/// The degree from which on Chebyshev polynomials are so near sine and cosine at all angles up to `widest`.
int degree_for(double widest, double accuracy);

struct Peer {
  double seconds = 0;                     ///< processor time
  std::size_t paths = 0;                  ///< that are followed: to all complex roots
  std::size_t roots = 0;                  ///< of them found; 0 where it was not done in time
  std::vector<std::vector<double>> real;  ///< theta, and the force where the end point is held
};

/// The blackbox solver, without tasks, its random numbers those of a seed.
/// \throws Error where it fails before its time is over
Peer phc(const std::filesystem::path& folder, const Question& question, int seed, int most_seconds);

}  // namespace plumbline::bench
