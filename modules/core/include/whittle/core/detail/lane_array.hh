#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace whittle::detail {

/// n numbers side by side, for compilers that have no vectors: with their operators, lane by lane. A comparison has all
/// ones or zeros in each lane.
template <class T, std::size_t n>
class alignas(n * sizeof(T)) LaneArray {
 public:
  using Mask = LaneArray<std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>, n>;

  LaneArray() = default;
  LaneArray(T everywhere) { lanes_.fill(everywhere); }
  template <class... Ts>
  requires(sizeof...(Ts) == n) LaneArray(Ts... lanes) : lanes_{static_cast<T>(lanes)...} {}

  T& operator[](std::size_t lane) { return lanes_[lane]; }
  const T& operator[](std::size_t lane) const { return lanes_[lane]; }

  friend LaneArray operator+(const LaneArray& a, const LaneArray& b) {
    return each(a, b, [](T x, T y) { return x + y; });
  }
  friend LaneArray operator-(const LaneArray& a, const LaneArray& b) {
    return each(a, b, [](T x, T y) { return x - y; });
  }
  friend LaneArray operator*(const LaneArray& a, const LaneArray& b) {
    return each(a, b, [](T x, T y) { return x * y; });
  }
  friend LaneArray operator/(const LaneArray& a, const LaneArray& b) {
    return each(a, b, [](T x, T y) { return x / y; });
  }
  friend LaneArray operator&(const LaneArray& a, const LaneArray& b) {
    return each(a, b, [](T x, T y) { return x & y; });
  }
  friend LaneArray operator|(const LaneArray& a, const LaneArray& b) {
    return each(a, b, [](T x, T y) { return x | y; });
  }
  LaneArray operator-() const {
    return each(*this, *this, [](T x, T) { return -x; });
  }
  LaneArray operator~() const {
    return each(*this, *this, [](T x, T) { return ~x; });
  }

  LaneArray& operator+=(const LaneArray& o) { return *this = *this + o; }
  LaneArray& operator-=(const LaneArray& o) { return *this = *this - o; }
  LaneArray& operator*=(const LaneArray& o) { return *this = *this * o; }
  LaneArray& operator&=(const LaneArray& o) { return *this = *this & o; }
  LaneArray& operator|=(const LaneArray& o) { return *this = *this | o; }

  friend Mask operator<(const LaneArray& a, const LaneArray& b) {
    return mask(a, b, [](T x, T y) { return x < y; });
  }
  friend Mask operator<=(const LaneArray& a, const LaneArray& b) {
    return mask(a, b, [](T x, T y) { return x <= y; });
  }
  friend Mask operator>(const LaneArray& a, const LaneArray& b) {
    return mask(a, b, [](T x, T y) { return x > y; });
  }
  friend Mask operator>=(const LaneArray& a, const LaneArray& b) {
    return mask(a, b, [](T x, T y) { return x >= y; });
  }
  friend Mask operator==(const LaneArray& a, const LaneArray& b) {
    return mask(a, b, [](T x, T y) { return x == y; });
  }
  friend Mask operator!=(const LaneArray& a, const LaneArray& b) {
    return mask(a, b, [](T x, T y) { return x != y; });
  }

 private:
  template <class Operation>
  static LaneArray each(const LaneArray& a, const LaneArray& b, const Operation& operation) {
    LaneArray result;
    for (std::size_t lane = 0; lane < n; ++lane) result[lane] = operation(a[lane], b[lane]);
    return result;
  }
  template <class Comparison>
  static Mask mask(const LaneArray& a, const LaneArray& b, const Comparison& comparison) {
    Mask result;
    for (std::size_t lane = 0; lane < n; ++lane) result[lane] = comparison(a[lane], b[lane]) ? -1 : 0;
    return result;
  }

  std::array<T, n> lanes_;
};

template <class T, std::size_t n>
LaneArray<T, n> select_lanes(const typename LaneArray<T, n>::Mask& condition, const LaneArray<T, n>& yes,
                             const LaneArray<T, n>& no) {
  LaneArray<T, n> result;
  for (std::size_t lane = 0; lane < n; ++lane) result[lane] = condition[lane] != 0 ? yes[lane] : no[lane];
  return result;
}

template <int... from, class T, std::size_t n>
LaneArray<T, n> shuffled(const LaneArray<T, n>& a, const LaneArray<T, n>& b) {
  constexpr int size = n;
  return {(from < size ? a[from % size] : b[from % size])...};
}

}  // namespace whittle::detail
