#include "cost/attributes/wedge_quadrics.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "whittle/core/detail/lanes.hh"

namespace whittle {
namespace {

/// How the numbers of a wedge lie: the weight; the quadric, ten numbers; then for each four components the slopes along
/// x, along y, along z, and the values at the origin.
constexpr std::size_t weight_at = 0;
constexpr std::size_t spread_at = 1;
constexpr std::size_t functions_at = 12;
constexpr std::size_t functions_length = 16;

/// No slope is longer. A texture of even scale has a slope of its weight.
constexpr float steepest = 4;

/// Of four components.
struct Functions {
  Float4 x, y, z, value;

  WHITTLE_INLINE static Functions at(const float* from) {
    return {load_lanes<Float4>(from), load_lanes<Float4>(from + 4), load_lanes<Float4>(from + 8),
            load_lanes<Float4>(from + 12)};
  }
  WHITTLE_INLINE void store(float* to) const {
    store_lanes(x, to), store_lanes(y, to + 4), store_lanes(z, to + 8), store_lanes(value, to + 12);
  }
  WHITTLE_INLINE Functions about(const PointLanes<Float4>& t) const { return {x, y, z, value_at(t)}; }
  WHITTLE_INLINE Float4 value_at(const PointLanes<Float4>& t) const { return value + (x * t.x + y * t.y + z * t.z); }
  WHITTLE_INLINE friend Functions operator-(const Functions& a, const Functions& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.value - b.value};
  }
};

PointLanes<Float4> in_all_lanes(const Vec3& p) {
  const auto lanes = [](double number) { return Float4{} + static_cast<float>(number); };
  return {lanes(p.x()), lanes(p.y()), lanes(p.z())};
}

/// {Σ a, Σ b, Σ c, Σ d}
WHITTLE_INLINE Float4 sums_of(const Float4& a, const Float4& b, const Float4& c, const Float4& d) {
  const Float4 ab = shuffled<0, 4, 1, 5>(a, b) + shuffled<2, 6, 3, 7>(a, b);  // a0 + a2, b0 + b2, a1 + a3, b1 + b3
  const Float4 cd = shuffled<0, 4, 1, 5>(c, d) + shuffled<2, 6, 3, 7>(c, d);
  return shuffled<0, 1, 4, 5>(ab, cd) + shuffled<2, 3, 6, 7>(ab, cd);
}

float sum_of(const Float4& lanes) { return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]); }

/// Σ f², as the ten numbers of a quadric.
class SquareSum {
 public:
  WHITTLE_INLINE void add(const Functions& f) {
    xx_ += f.x * f.x, xy_ += f.x * f.y, xz_ += f.x * f.z, yy_ += f.y * f.y, yz_ += f.y * f.z, zz_ += f.z * f.z;
    x_ += f.x * f.value, y_ += f.y * f.value, z_ += f.z * f.value, constant_ += f.value * f.value;
  }
  /// Times a factor. The last two numbers are of no meaning.
  WHITTLE_INLINE std::array<float, 12> times(float factor) const {
    std::array<float, 12> numbers;
    store_lanes(factor * sums_of(xx_, xy_, xz_, yy_), numbers.data());
    store_lanes(factor * sums_of(yz_, zz_, x_, y_), numbers.data() + 4);
    store_lanes(factor * sums_of(z_, constant_, z_, constant_), numbers.data() + 8);
    return numbers;
  }

 private:
  Float4 xx_{}, xy_{}, xz_{}, yy_{}, yz_{}, zz_{}, x_{}, y_{}, z_{}, constant_{};
};

Quadric quadric_of(const float* q) { return {{q[0], q[1], q[2], q[3], q[4], q[5]}, {q[6], q[7], q[8]}, q[9]}; }

void store(const Quadric& q, float* to) {
  const auto& [a, b, c] = q;
  const std::array numbers{a.xx, a.xy, a.xz, a.yy, a.yz, a.zz, b.x(), b.y(), b.z(), c};
  for (std::size_t i = 0; i < numbers.size(); ++i) to[i] = static_cast<float>(numbers[i]);
}

/// W₁ W₂ / W
float reduced_weight(float first, float second) {
  const float both = first + second;
  return both > 0 ? first * (second / both) : 0;
}

/// Of two wedges, or of a wedge and a face, with one origin.
void join_numbers(float* into, const float* other, std::size_t n_groups) {
  const float both = into[weight_at] + other[weight_at];
  if (!(both > 0)) return;
  const float share = other[weight_at] / both;
  SquareSum squares;
  for (std::size_t i = functions_at; i < functions_at + n_groups * functions_length; i += functions_length) {
    const Functions mean = Functions::at(into + i);
    const Functions apart = Functions::at(other + i) - mean;
    squares.add(apart);
    Functions{mean.x + share * apart.x, mean.y + share * apart.y, mean.z + share * apart.z,
              mean.value + share * apart.value}
        .store(into + i);
  }
  const std::array<float, 12> between = squares.times(into[weight_at] * share);
  for (std::size_t i = 0; i < 10; ++i) into[spread_at + i] += other[spread_at + i] + between[i];
  into[weight_at] = both;
}

Float4 rounded(const Double4& lanes) {
  return Float4{static_cast<float>(lanes[0]), static_cast<float>(lanes[1]), static_cast<float>(lanes[2]),
                static_cast<float>(lanes[3])};
}

/// Through values at the corners of a face. Functions that are too steep keep the value in the middle.
WHITTLE_INLINE Functions functions_of(const FaceGradient& face, const Vec3& from_center, const Double4& first,
                                      const Double4& second, const Double4& third) {
  const Float4 u = rounded(second - first);
  const Float4 v = rounded(third - first);
  const PointLanes<Float4> dual_u = in_all_lanes(face.dual_u);
  const PointLanes<Float4> dual_v = in_all_lanes(face.dual_v);
  Functions functions{u * dual_u.x + v * dual_v.x, u * dual_u.y + v * dual_v.y, u * dual_u.z + v * dual_v.z,
                      rounded((first + second + third) * (1.0 / 3))};
  auto& [x, y, z, value] = functions;
  const Float4 square = x * x + y * y + z * z;
  const auto is_too_steep = square > steepest * steepest;
  if (any_lane(is_too_steep)) {
    Float4 factor{};
    for (std::size_t j = 0; j < 4; ++j) factor[j] = is_too_steep[j] != 0 ? steepest / std::sqrt(square[j]) : 1;
    x *= factor, y *= factor, z *= factor;
  }
  return functions.about(in_all_lanes(from_center));
}

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
    : n_groups_((n_components + 3) / 4),
      stride_(functions_at + n_groups_ * functions_length),
      numbers_(n_wedges * stride_, 0.0F) {}

Quadric WedgeQuadrics::quadric(Index w) const { return quadric_of(of(w) + spread_at); }

Quadric WedgeQuadrics::quadric_of_both(Index a, Index b, const Vec3& a_to_b) const {
  const float* const first = of(a);
  const float* const second = of(b);
  const PointLanes<Float4> b_to_a = in_all_lanes(-a_to_b);
  SquareSum squares;
  for (std::size_t i = functions_at; i < stride_; i += functions_length) {
    squares.add(Functions::at(first + i) - Functions::at(second + i).about(b_to_a));
  }
  const std::array<float, 12> between = squares.times(reduced_weight(first[weight_at], second[weight_at]));
  Quadric both = quadric(b).about(-a_to_b);
  both += quadric(a);
  both += quadric_of(between.data());
  return both;
}

double WedgeQuadrics::error_between(Index a, Index b, const Vec3& from_a, const Vec3& from_b) const {
  const float* const first = of(a);
  const float* const second = of(b);
  const PointLanes<Float4> at_a = in_all_lanes(from_a);
  const PointLanes<Float4> at_b = in_all_lanes(from_b);
  Float4 squares{};
  for (std::size_t i = functions_at; i < stride_; i += functions_length) {
    const Float4 apart = Functions::at(first + i).value_at(at_a) - Functions::at(second + i).value_at(at_b);
    squares += apart * apart;
  }
  return reduced_weight(first[weight_at], second[weight_at]) * sum_of(squares);
}

void WedgeQuadrics::add_face(Index w, double weight, const FaceGradient& face, const Vec3& from_center,
                             const std::array<const double*, 3>& values) {
  thread_local std::vector<float> numbers;
  numbers.resize(stride_);
  std::fill_n(numbers.begin(), functions_at, 0.0F);
  numbers[weight_at] = static_cast<float>(weight);
  for (std::size_t i = 0; i < n_groups_; ++i) {
    const auto row = [&](std::size_t k) { return load_lanes<Double4>(values[k] + 4 * i); };
    functions_of(face, from_center, row(0), row(1), row(2)).store(numbers.data() + functions_at + i * functions_length);
  }
  join_numbers(of(w), numbers.data(), n_groups_);
}

void WedgeQuadrics::move_origin(Index w, const Vec3& by) {
  float* const numbers = of(w);
  const PointLanes<Float4> lanes = in_all_lanes(by);
  for (std::size_t i = functions_at; i < stride_; i += functions_length) {
    store_lanes(Functions::at(numbers + i).value_at(lanes), numbers + i + 12);
  }
  store(quadric(w).about(by), numbers + spread_at);
}

WedgeQuadrics WedgeQuadrics::gathered(std::span<const Index> wedges) const {
  WedgeQuadrics some;
  some.n_groups_ = n_groups_;
  some.stride_ = stride_;
  some.numbers_.reserve(wedges.size() * stride_);
  for (const Index w : wedges) some.numbers_.insert(some.numbers_.end(), of(w), of(w) + stride_);
  return some;
}

void WedgeQuadrics::join(Index into, Index other) { join_numbers(of(into), of(other), n_groups_); }

}  // namespace whittle
