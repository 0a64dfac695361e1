#include "cost/attributes/wedge_quadrics.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "cost/attributes/wedge_pairs.hh"

namespace whittle {
namespace {

constexpr std::size_t weight_at = WedgeLayout::weight;
constexpr std::size_t spread_at = WedgeLayout::spread;
constexpr std::size_t functions_at = WedgeLayout::functions;
constexpr std::size_t functions_length = WedgeLayout::functions_length;

/// No slope is longer. A texture of even scale has a slope of its weight.
constexpr double steepest = 4;

/// Of four components. \tparam Real Float4, or Double4 for sums
template <class Real>
struct Functions {
  Real x{}, y{}, z{}, value{};

  WHITTLE_INLINE static Functions at(const float* from) {
    return {load_lanes<Real>(from), load_lanes<Real>(from + 4), load_lanes<Real>(from + 8),
            load_lanes<Real>(from + 12)};
  }
  WHITTLE_INLINE void store(float* to) const {
    store_lanes(x, to), store_lanes(y, to + 4), store_lanes(z, to + 8), store_lanes(value, to + 12);
  }
  WHITTLE_INLINE Functions about(const PointLanes<Real>& t) const { return {x, y, z, value_at(t)}; }
  WHITTLE_INLINE Real value_at(const PointLanes<Real>& t) const { return value + (x * t.x + y * t.y + z * t.z); }
  template <class Number>
  WHITTLE_INLINE Functions times(Number factor) const {
    return {factor * x, factor * y, factor * z, factor * value};
  }
  WHITTLE_INLINE friend Functions operator-(const Functions& a, const Functions& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.value - b.value};
  }
  WHITTLE_INLINE Functions& operator+=(const Functions& o) {
    x += o.x, y += o.y, z += o.z, value += o.value;
    return *this;
  }
};

template <class Real>
WHITTLE_INLINE PointLanes<Real> in_all_lanes(const Vec3& p) {
  using Number = std::decay_t<decltype(Real{}[0])>;
  const auto lanes = [](double number) WHITTLE_INLINE_LAMBDA { return Real{} + static_cast<Number>(number); };
  return {lanes(p.x()), lanes(p.y()), lanes(p.z())};
}

/// {Σ a, Σ b, Σ c, Σ d}
WHITTLE_INLINE Float4 sums_of(const Float4& a, const Float4& b, const Float4& c, const Float4& d) {
  const Float4 ab = shuffled<0, 4, 1, 5>(a, b) + shuffled<2, 6, 3, 7>(a, b);  // a0 + a2, b0 + b2, a1 + a3, b1 + b3
  const Float4 cd = shuffled<0, 4, 1, 5>(c, d) + shuffled<2, 6, 3, 7>(c, d);
  return shuffled<0, 1, 4, 5>(ab, cd) + shuffled<2, 3, 6, 7>(ab, cd);
}

template <class Real>
WHITTLE_INLINE auto sum_of(const Real& lanes) {
  return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]);
}

/// Σ f², as the ten numbers of a quadric.
template <class Real>
class SquareSum {
 public:
  WHITTLE_INLINE void add(const Functions<Real>& f) { add(f, f); }
  /// w f², from f and w f.
  WHITTLE_INLINE void add(const Functions<Real>& f, const Functions<Real>& weighted) {
    const auto& [x, y, z, value] = weighted;
    xx_ += x * f.x, xy_ += x * f.y, xz_ += x * f.z, yy_ += y * f.y, yz_ += y * f.z, zz_ += z * f.z;
    x_ += x * f.value, y_ += y * f.value, z_ += z * f.value, constant_ += value * f.value;
  }
  /// Times a factor. The last two numbers are of no meaning.
  WHITTLE_INLINE std::array<float, 12> times(float factor) const {
    std::array<float, 12> numbers;
    store_lanes(factor * sums_of(xx_, xy_, xz_, yy_), numbers.data());
    store_lanes(factor * sums_of(yz_, zz_, x_, y_), numbers.data() + 4);
    store_lanes(factor * sums_of(z_, constant_, z_, constant_), numbers.data() + 8);
    return numbers;
  }
  WHITTLE_INLINE Quadric quadric() const {
    return {{sum_of(xx_), sum_of(xy_), sum_of(xz_), sum_of(yy_), sum_of(yz_), sum_of(zz_)},
            {sum_of(x_), sum_of(y_), sum_of(z_)},
            sum_of(constant_)};
  }

 private:
  Real xx_{}, xy_{}, xz_{}, yy_{}, yz_{}, zz_{}, x_{}, y_{}, z_{}, constant_{};
};

Quadric quadric_of(const float* q) { return {{q[0], q[1], q[2], q[3], q[4], q[5]}, {q[6], q[7], q[8]}, q[9]}; }

void store(const Quadric& q, float* to) {
  const auto& [a, b, c] = q;
  const std::array numbers{a.xx, a.xy, a.xz, a.yy, a.yz, a.zz, b.x(), b.y(), b.z(), c};
  for (std::size_t i = 0; i < numbers.size(); ++i) to[i] = static_cast<float>(numbers[i]);
}

/// \pre both have one origin
void join_numbers(float* into, const float* other, std::size_t n_groups) {
  const float both = into[weight_at] + other[weight_at];
  if (!(both > 0)) return;
  const float share = other[weight_at] / both;
  SquareSum<Float4> squares;
  for (std::size_t i = functions_at; i < functions_at + n_groups * functions_length; i += functions_length) {
    const auto mean = Functions<Float4>::at(into + i);
    const Functions<Float4> apart = Functions<Float4>::at(other + i) - mean;
    squares.add(apart);
    Functions<Float4>{mean.x + share * apart.x, mean.y + share * apart.y, mean.z + share * apart.z,
                      mean.value + share * apart.value}
        .store(into + i);
  }
  const std::array<float, 12> between = squares.times(into[weight_at] * share);
  for (std::size_t i = 0; i < 10; ++i) into[spread_at + i] += other[spread_at + i] + between[i];
  into[weight_at] = both;
}

/// Of four components, in double precision.
struct Slopes {
  Double4 x, y, z;

  /// Through values at the corners of a face, less where too steep.
  WHITTLE_INLINE static Slopes of(const WedgeFace& face, std::size_t group) {
    const Double4 u = row(face, 1, group) - row(face, 0, group);
    const Double4 v = row(face, 2, group) - row(face, 0, group);
    const Vec3& dual_u = face.gradient.dual_u;
    const Vec3& dual_v = face.gradient.dual_v;
    Slopes slopes{u * dual_u.x() + v * dual_v.x(), u * dual_u.y() + v * dual_v.y(), u * dual_u.z() + v * dual_v.z()};
    slopes.cut();
    return slopes;
  }
  WHITTLE_INLINE static Double4 row(const WedgeFace& face, std::size_t corner, std::size_t group) {
    return load_lanes<Double4>(face.values[corner] + 4 * group);
  }

 private:
  WHITTLE_INLINE void cut() {
    Double4 length = x * x + y * y + z * z;
    const auto is_too_steep = length > steepest * steepest;
    if (!any_lane(is_too_steep)) return;
    take_square_roots(length);
    const Double4 factor = select_lanes(is_too_steep, steepest / length, Double4{} + 1.0);
    x *= factor, y *= factor, z *= factor;
  }
};

}  // namespace

FaceGradient::FaceGradient(const std::array<Vec3, 3>& corners) : center((corners[0] + corners[1] + corners[2]) / 3) {
  const Vec3 u = corners[1] - corners[0];
  const Vec3 v = corners[2] - corners[0];
  const Vec3 n = u.cross(v);
  const double square = n.squaredNorm();
  const double inverse = 1 / square;
  area = 0.5 * std::sqrt(square);
  dual_u = inverse * v.cross(n);
  dual_v = inverse * n.cross(u);
}

WedgeQuadrics::WedgeQuadrics(std::size_t n_wedges, std::size_t n_components)
    : n_components_(n_components),
      stride_(functions_at + n_groups() * functions_length),
      numbers_(n_wedges * stride_, 0.0F) {}

Quadric WedgeQuadrics::quadric(Index w) const { return quadric_of(of(w) + spread_at); }

Quadric WedgeQuadrics::quadric_of_both(Index a, Index b, const Vec3& a_to_b) const {
  const auto number = [&](int i) { return static_cast<float>(-a_to_b[i]); };
  const PointLanes<float> b_to_a{number(0), number(1), number(2)};
  const auto q = whittle::quadric_of_both<float>(OneWedge{of(a)}, OneWedge{of(b)}, n_components_, b_to_a);
  return {{q.xx, q.xy, q.xz, q.yy, q.yz, q.zz}, {q.bx, q.by, q.bz}, q.c};
}

double WedgeQuadrics::error_between(Index a, Index b, const Vec3& from_a, const Vec3& from_b) const {
  const float* const first = of(a);
  const float* const second = of(b);
  const PointLanes<Float4> at_a = in_all_lanes<Float4>(from_a);
  const PointLanes<Float4> at_b = in_all_lanes<Float4>(from_b);
  Float4 squares{};
  for (std::size_t i = functions_at; i < stride_; i += functions_length) {
    const Float4 apart =
        Functions<Float4>::at(first + i).value_at(at_a) - Functions<Float4>::at(second + i).value_at(at_b);
    squares += apart * apart;
  }
  return reduced_weight<float>(first[weight_at], second[weight_at]) * sum_of(squares);
}

/// E as Σ_t w_t f_tj² − W m_j², with the f_tj less the value at the origin: without cut slopes they are 0 there, so
/// nothing large cancels.
struct WedgeQuadrics::FaceSum {
  std::span<const WedgeFace> faces;
  const double* values;

  WHITTLE_INLINE void store(float* numbers, std::size_t n_groups) const {
    double weight = 0;
    for (const WedgeFace& face : faces) weight += face.gradient.area;
    if (!(weight > 0)) return;
    SquareSum<Double4> squares;
    for (std::size_t group = 0; group < n_groups; ++group) {
      const Double4 origin = load_lanes<Double4>(values + 4 * group);
      Functions<Double4> sum{};
      for (const WedgeFace& face : faces) {
        const double area = face.gradient.area;
        const auto [x, y, z] = Slopes::of(face, group);
        const Double4 center = (Slopes::row(face, 0, group) - origin) + (Slopes::row(face, 1, group) - origin) +
                               (Slopes::row(face, 2, group) - origin);
        const auto function =
            Functions<Double4>{x, y, z, center * (1.0 / 3)}.about(in_all_lanes<Double4>(face.from_center));
        const Functions<Double4> weighted = function.times(area);
        squares.add(function, weighted);
        sum += weighted;
      }
      const Functions<Double4> mean = sum.times(1 / weight);
      squares.add(mean, mean.times(-weight));
      Functions<Float4>{rounded(mean.x), rounded(mean.y), rounded(mean.z), rounded(origin + mean.value)}.store(
          numbers + functions_at + group * functions_length);
    }
    numbers[weight_at] = static_cast<float>(weight);
    whittle::store(squares.quadric(), numbers + spread_at);
  }
  WHITTLE_AVX2 void store_in_wide_registers(float* numbers, std::size_t n_groups) const { store(numbers, n_groups); }
};

void WedgeQuadrics::set(Index w, std::span<const WedgeFace> faces, const double* values) {
  const FaceSum sum{faces, values};
  has_double4 ? sum.store_in_wide_registers(of(w), n_groups()) : sum.store(of(w), n_groups());
}

void WedgeQuadrics::move_origin(Index w, const Vec3& by) {
  float* const numbers = of(w);
  const PointLanes<Float4> lanes = in_all_lanes<Float4>(by);
  for (std::size_t i = functions_at; i < stride_; i += functions_length) {
    store_lanes(Functions<Float4>::at(numbers + i).value_at(lanes), numbers + i + 12);
  }
  store(quadric(w).about(by), numbers + spread_at);
}

WedgeQuadrics WedgeQuadrics::of_same_kind(std::size_t n_wedges) const {
  WedgeQuadrics some;
  some.n_components_ = n_components_;
  some.stride_ = stride_;
  some.numbers_.resize(n_wedges * stride_);
  return some;
}

void WedgeQuadrics::copy(Index to, const WedgeQuadrics& from_table, Index from) {
  std::copy_n(from_table.of(from), stride_, of(to));
}

WedgeQuadrics WedgeQuadrics::gathered(std::span<const Index> wedges) const {
  WedgeQuadrics some = of_same_kind(0);
  some.numbers_.reserve(wedges.size() * stride_);
  for (const Index w : wedges) some.numbers_.insert(some.numbers_.end(), of(w), of(w) + stride_);
  return some;
}

void WedgeQuadrics::join(Index into, Index other) { join_numbers(of(into), of(other), n_groups()); }

}  // namespace whittle
