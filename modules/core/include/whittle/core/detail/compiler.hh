#pragma once

// The words that only some compilers have, each with a portable fall-back. No other file has such words.
//
//   WHITTLE_HAS_LANES      defined if the compiler computes on vectors of numbers (GCC from 12 on, Clang), and
//                          WHITTLE_SCALAR, an option of the build, is not defined
//   WHITTLE_INLINE         inline, even where the compiler would not: lanes passed to a function cost time
//   WHITTLE_INLINE_LAMBDA  the same for lambdas, after the parameters
//   WHITTLE_USED           keeps a variable that nothing refers to
//   WHITTLE_AVX2           a function for processors with AVX2: call it only if `has_avx2()`
//
// GCC aligns no variable on the stack of Windows to 32 bytes (its bug 54412), as AVX2 needs.

#if defined(__GNUC__) && defined(__has_builtin) && !defined(WHITTLE_SCALAR)
#if __has_builtin(__builtin_shufflevector)
#define WHITTLE_HAS_LANES
#endif
#endif

#if defined(__GNUC__)
#define WHITTLE_INLINE [[gnu::always_inline]] inline
#define WHITTLE_INLINE_LAMBDA __attribute__((always_inline))
#define WHITTLE_USED [[gnu::used]]
#else
#ifdef _MSC_VER
#define WHITTLE_INLINE __forceinline
#else
#define WHITTLE_INLINE inline
#endif
#define WHITTLE_INLINE_LAMBDA
#define WHITTLE_USED [[maybe_unused]]
#endif

#if defined(WHITTLE_HAS_LANES) && defined(__x86_64__) && (defined(__clang__) || !defined(_WIN32))
#define WHITTLE_CHOOSES_AVX2
#define WHITTLE_AVX2 [[gnu::target("avx2")]]
#else
#define WHITTLE_AVX2
#endif

namespace whittle {

/// Asks for the cache line at `address`, which need not be valid.
inline void prefetch_line([[maybe_unused]] const void* address) {
#ifdef __GNUC__
  __builtin_prefetch(address);
  asm volatile("");  // without it GCC drops calls of this function, as without effect
#endif
}

/// Tells the processor that this thread waits for another.
inline void pause_processor() {
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
  __builtin_ia32_pause();
#endif
}

/// Whether functions marked WHITTLE_AVX2 are worth while, and this processor runs them.
inline bool has_avx2() {
#ifdef WHITTLE_CHOOSES_AVX2
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

#ifdef WHITTLE_HAS_LANES
namespace detail {

/// n numbers side by side.
template <class T, int n>
struct LaneVector {
  using Type [[gnu::vector_size(n * sizeof(T))]] = T;
};

}  // namespace detail

/// {both[from]…}, `both` the lanes of a and after them those of b. (lane_array.hh has this for arrays.)
template <int... from, class Vector>
WHITTLE_INLINE Vector shuffled(const Vector& a, const Vector& b) {
  return __builtin_shufflevector(a, b, from...);
}
#endif

}  // namespace whittle
