#pragma once
/// \file
/// Loops along lanes (lanes.hpp) compiled once more, for registers of eight doubles, which a machine that has
/// them takes: a program that is compiled for any machine is then nearly as fast as one compiled for this
/// one. There is no version for registers of four: with GCC 12 it is slower than the one for two.

namespace plumbline::detail {

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__AVX512F__)
/// Whether there are registers of eight doubles that the program is not compiled for.
inline bool widens() {
  return __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
         __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
}

// Features by name and not a level: functions become part of one that is compiled for more features, but not
// of one for another processor.
template <class Work>
[[gnu::target("avx2,fma,bmi,bmi2,lzcnt,popcnt,avx512f,avx512bw,avx512cd,avx512dq,avx512vl"),
  gnu::flatten]] auto
in_eights(const Work& work) {
  return work();
}

/// Does the work in the widest registers. All that it calls becomes part of it, as far as it is here to see.
/// Lanes are made and used up inside: what is compiled for narrower registers passes them otherwise, and
/// aligns them less, but in a Scratch.
template <class Work>
auto in_widest(const Work& work) {
  return widens() ? in_eights(work) : work();
}
#else
inline bool widens() {
  return false;
}
template <class Work>
auto in_widest(const Work& work) {
  return work();
}
#endif

}  // namespace plumbline::detail
