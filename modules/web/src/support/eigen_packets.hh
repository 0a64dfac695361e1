#pragma once

#define EIGEN_VECTORIZE

#include <Eigen/Core>

// Packets of Eigen for WebAssembly, which Eigen 3.4 has none for. They are here for the bytes of results more than for
// speed: with packets Eigen adds three doubles as (a + b) + c, without as a + (b + c). What Eigen does with packets
// follows from the traits, so these are those of SSE2, as far as no transcendental function is concerned. Each source
// includes this header first (-include).

namespace Eigen::internal {

using Packet2d [[gnu::vector_size(16)]] = double;
using Packet4f [[gnu::vector_size(16)]] = float;
using Packet4i [[gnu::vector_size(16)]] = int;
using Bits2 [[gnu::vector_size(16)]] = long long;

template <>
struct is_arithmetic<Packet2d> {
  enum { value = true };
};
template <>
struct is_arithmetic<Packet4f> {
  enum { value = true };
};
template <>
struct is_arithmetic<Packet4i> {
  enum { value = true };
};

template <class Packet, int n>
struct WasmPacketTraits : default_packet_traits {
  using type = Packet;
  using half = Packet;
  enum { Vectorizable = 1, AlignedOnScalar = 1, size = n, HasHalfPacket = 0 };
};
template <class Packet, int n>
struct WasmFloatPacketTraits : WasmPacketTraits<Packet, n> {
  enum { HasCmp = 1, HasDiv = 1, HasSqrt = 1, HasBlend = 0 };
};
template <>
struct packet_traits<double> : WasmFloatPacketTraits<Packet2d, 2> {};
template <>
struct packet_traits<float> : WasmFloatPacketTraits<Packet4f, 4> {};
template <>
struct packet_traits<int> : WasmPacketTraits<Packet4i, 4> {};

template <class Packet, class Scalar, int n>
struct WasmUnpacketTraits {
  using type = Scalar;
  using half = Packet;
  using integer_packet = Packet4i;
  enum {
    size = n,
    alignment = Aligned16,
    vectorizable = true,
    masked_load_available = false,
    masked_store_available = false
  };
};
template <>
struct unpacket_traits<Packet2d> : WasmUnpacketTraits<Packet2d, double, 2> {};
template <>
struct unpacket_traits<Packet4f> : WasmUnpacketTraits<Packet4f, float, 4> {};
template <>
struct unpacket_traits<Packet4i> : WasmUnpacketTraits<Packet4i, int, 4> {};

/// What all kinds of packets do alike.
template <class Packet>
struct WasmPacket {
  using Scalar = typename unpacket_traits<Packet>::type;
  struct [[gnu::packed, gnu::may_alias]] Anywhere {
    Packet value;
  };

  static Packet load(const Scalar* from) { return reinterpret_cast<const Anywhere*>(from)->value; }
  static void store(Scalar* to, const Packet& from) { reinterpret_cast<Anywhere*>(to)->value = from; }
};

// NOLINTBEGIN(bugprone-macro-parentheses): the macro's parameters are types
#define WHITTLE_EIGEN_PACKET(Packet, Scalar)                                                    \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pload<Packet>(const Scalar* from) {                                \
    return WasmPacket<Packet>::load(from);                                                      \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet ploadu<Packet>(const Scalar* from) {                               \
    return WasmPacket<Packet>::load(from);                                                      \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE void pstore<Scalar>(Scalar * to, const Packet& from) {                    \
    WasmPacket<Packet>::store(to, from);                                                        \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE void pstoreu<Scalar>(Scalar * to, const Packet& from) {                   \
    WasmPacket<Packet>::store(to, from);                                                        \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pset1<Packet>(const Scalar& from) {                                \
    return from - Packet{};                                                                     \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pzero(const Packet& /*a*/) {                                       \
    return Packet{};                                                                            \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pconj(const Packet& a) {                                           \
    return a;                                                                                   \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pabs(const Packet& a) {                                            \
    return __builtin_elementwise_abs(a);                                                        \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pmin<Packet>(const Packet& a, const Packet& b) { /* as std::min */ \
    return b < a ? b : a;                                                                       \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pmax<Packet>(const Packet& a, const Packet& b) {                   \
    return a < b ? b : a;                                                                       \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pand<Packet>(const Packet& a, const Packet& b) {                   \
    return reinterpret_cast<Packet>(reinterpret_cast<Bits2>(a) & reinterpret_cast<Bits2>(b));   \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet por<Packet>(const Packet& a, const Packet& b) {                    \
    return reinterpret_cast<Packet>(reinterpret_cast<Bits2>(a) | reinterpret_cast<Bits2>(b));   \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pcmp_eq(const Packet& a, const Packet& b) {                        \
    return reinterpret_cast<Packet>(a == b);                                                    \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pcmp_lt(const Packet& a, const Packet& b) {                        \
    return reinterpret_cast<Packet>(a < b);                                                     \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Packet pcmp_le(const Packet& a, const Packet& b) {                        \
    return reinterpret_cast<Packet>(a <= b);                                                    \
  }                                                                                             \
  template <>                                                                                   \
  EIGEN_STRONG_INLINE Scalar pfirst<Packet>(const Packet& a) {                                  \
    return a[0];                                                                                \
  }

WHITTLE_EIGEN_PACKET(Packet2d, double)
WHITTLE_EIGEN_PACKET(Packet4f, float)
WHITTLE_EIGEN_PACKET(Packet4i, int)
#undef WHITTLE_EIGEN_PACKET
// NOLINTEND(bugprone-macro-parentheses)

template <>
EIGEN_STRONG_INLINE Packet2d psqrt<Packet2d>(const Packet2d& a) {
  return __builtin_elementwise_sqrt(a);
}
template <>
EIGEN_STRONG_INLINE Packet4f psqrt<Packet4f>(const Packet4f& a) {
  return __builtin_elementwise_sqrt(a);
}
template <>
EIGEN_STRONG_INLINE Packet2d preverse(const Packet2d& a) {
  return __builtin_shufflevector(a, a, 1, 0);
}
template <>
EIGEN_STRONG_INLINE Packet4f preverse(const Packet4f& a) {
  return __builtin_shufflevector(a, a, 3, 2, 1, 0);
}
template <>
EIGEN_STRONG_INLINE Packet4i preverse(const Packet4i& a) {
  return __builtin_shufflevector(a, a, 3, 2, 1, 0);
}
template <>
EIGEN_STRONG_INLINE Packet2d plset<Packet2d>(const double& a) {
  return Packet2d{a, a + 1};
}
template <>
EIGEN_STRONG_INLINE Packet4f plset<Packet4f>(const float& a) {
  return Packet4f{a, a + 1, a + 2, a + 3};
}
template <>
EIGEN_STRONG_INLINE Packet4i plset<Packet4i>(const int& a) {
  return Packet4i{a, a + 1, a + 2, a + 3};
}

template <>
EIGEN_STRONG_INLINE Packet2d ploaddup<Packet2d>(const double* from) {
  return Packet2d{from[0], from[0]};
}
template <>
EIGEN_STRONG_INLINE Packet4f ploaddup<Packet4f>(const float* from) {
  return Packet4f{from[0], from[0], from[1], from[1]};
}
template <>
EIGEN_STRONG_INLINE Packet2d pgather<double, Packet2d>(const double* from, Index stride) {
  return Packet2d{from[0], from[stride]};
}
template <>
EIGEN_STRONG_INLINE Packet4f pgather<float, Packet4f>(const float* from, Index stride) {
  return Packet4f{from[0], from[stride], from[2 * stride], from[3 * stride]};
}
template <>
EIGEN_STRONG_INLINE void pscatter<double, Packet2d>(double* to, const Packet2d& from, Index stride) {
  for (int i = 0; i < 2; ++i) to[i * stride] = from[i];
}
template <>
EIGEN_STRONG_INLINE void pscatter<float, Packet4f>(float* to, const Packet4f& from, Index stride) {
  for (int i = 0; i < 4; ++i) to[i * stride] = from[i];
}
EIGEN_STRONG_INLINE void ptranspose(PacketBlock<Packet2d, 2>& rows) {
  const Packet2d first = rows.packet[0];
  rows.packet[0] = __builtin_shufflevector(first, rows.packet[1], 0, 2);
  rows.packet[1] = __builtin_shufflevector(first, rows.packet[1], 1, 3);
}

// Sums and products in SSE2's order.
template <>
EIGEN_STRONG_INLINE double predux<Packet2d>(const Packet2d& a) {
  return a[0] + a[1];
}
template <>
EIGEN_STRONG_INLINE float predux<Packet4f>(const Packet4f& a) {
  return (a[0] + a[2]) + (a[1] + a[3]);
}
template <>
EIGEN_STRONG_INLINE int predux<Packet4i>(const Packet4i& a) {
  return (a[0] + a[2]) + (a[1] + a[3]);
}
template <>
EIGEN_STRONG_INLINE double predux_mul<Packet2d>(const Packet2d& a) {
  return a[0] * a[1];
}
template <>
EIGEN_STRONG_INLINE float predux_mul<Packet4f>(const Packet4f& a) {
  return (a[0] * a[2]) * (a[1] * a[3]);
}
template <>
EIGEN_STRONG_INLINE double predux_min<Packet2d>(const Packet2d& a) {
  return a[1] < a[0] ? a[1] : a[0];
}
template <>
EIGEN_STRONG_INLINE double predux_max<Packet2d>(const Packet2d& a) {
  return a[0] < a[1] ? a[1] : a[0];
}
template <>
EIGEN_STRONG_INLINE float predux_min<Packet4f>(const Packet4f& a) {
  const Packet4f halves = pmin<Packet4f>(a, __builtin_shufflevector(a, a, 2, 3, 2, 3));
  return halves[1] < halves[0] ? halves[1] : halves[0];
}
template <>
EIGEN_STRONG_INLINE float predux_max<Packet4f>(const Packet4f& a) {
  const Packet4f halves = pmax<Packet4f>(a, __builtin_shufflevector(a, a, 2, 3, 2, 3));
  return halves[0] < halves[1] ? halves[1] : halves[0];
}
template <>
EIGEN_STRONG_INLINE int predux_min<Packet4i>(const Packet4i& a) {
  return __builtin_reduce_min(a);
}
template <>
EIGEN_STRONG_INLINE int predux_max<Packet4i>(const Packet4i& a) {
  return __builtin_reduce_max(a);
}

}  // namespace Eigen::internal
