// Signs of determinants. Rounded arithmetic is used where its error bound decides the sign. Else the determinant is
// computed exactly, as an expansion: a sum of doubles that don't overlap, smallest first. Bounds and algorithms:
// Shewchuk: Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates (1997). There is no stage
// between filter and exact value. Expansions leave out zeros, so coordinates with few digits make short ones.
#include "intersections/predicates.hh"

#include <array>
#include <cmath>
#include <cstddef>

#include "whittle/core/detail/error_free.hh"

namespace whittle::metrics {

namespace {

constexpr double epsilon = 0x1p-53;  // half a unit in the last place of 1
constexpr double orient2d_error_rel = (3.0 + 16.0 * epsilon) * epsilon;
constexpr double orient3d_error_rel = (7.0 + 56.0 * epsilon) * epsilon;

int sign(double x) { return (x > 0.0) - (x < 0.0); }

/// An exact sum of at most N doubles.
template <std::size_t N>
struct Expansion {
  std::array<double, N> terms;
  std::size_t size = 0;

  void push(double term) {
    if (term != 0.0) terms[size++] = term;
  }
  int sign_of() const { return size > 0 ? sign(terms[size - 1]) : 0; }
};

Expansion<2> difference(double a, double b) {
  const auto [value, error] = detail::two_sum(a, -b);
  Expansion<2> result;
  result.push(error);
  result.push(value);
  return result;
}

/// Shewchuk's Fast-Expansion-Sum with zero elimination: merges the terms of both by size, then adds them up.
template <std::size_t N, std::size_t M>
Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> result;
  double rest = 0.0;
  std::size_t i = 0, j = 0;
  while (i < e.size || j < f.size) {
    const bool take_e = j >= f.size || (i < e.size && std::abs(e.terms[i]) <= std::abs(f.terms[j]));
    const auto [value, error] = detail::two_sum(rest, take_e ? e.terms[i++] : f.terms[j++]);
    result.push(error);
    rest = value;
  }
  result.push(rest);
  return result;
}

template <std::size_t N>
Expansion<N> operator-(Expansion<N> e) {
  for (std::size_t i = 0; i < e.size; ++i) e.terms[i] = -e.terms[i];
  return e;
}

/// Shewchuk's Scale-Expansion with zero elimination.
template <std::size_t N>
Expansion<2 * N> scale(const Expansion<N>& e, double factor) {
  Expansion<2 * N> result;
  double rest = 0.0;
  for (std::size_t i = 0; i < e.size; ++i) {
    const auto [product, product_error] = detail::two_product(e.terms[i], factor);
    const auto [middle, low] = detail::two_sum(rest, product_error);
    const auto [high, error] = detail::two_sum(product, middle);
    result.push(low);
    result.push(error);
    rest = high;
  }
  result.push(rest);
  return result;
}

template <std::size_t N>
Expansion<4 * N> operator*(const Expansion<N>& e, const Expansion<2>& f) {
  return scale(e, f.size > 0 ? f.terms[0] : 0.0) + scale(e, f.size > 1 ? f.terms[1] : 0.0);
}

int orient2d_exact(const Vec3& a, const Vec3& b, const Vec3& c, int x, int y) {
  const Expansion<2> acx = difference(a[x], c[x]), bcx = difference(b[x], c[x]);
  const Expansion<2> acy = difference(a[y], c[y]), bcy = difference(b[y], c[y]);
  return (acx * bcy + -(acy * bcx)).sign_of();
}

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Expansion<2> adx = difference(a.x(), d.x()), ady = difference(a.y(), d.y()), adz = difference(a.z(), d.z());
  const Expansion<2> bdx = difference(b.x(), d.x()), bdy = difference(b.y(), d.y()), bdz = difference(b.z(), d.z());
  const Expansion<2> cdx = difference(c.x(), d.x()), cdy = difference(c.y(), d.y()), cdz = difference(c.z(), d.z());
  const Expansion<64> a_part = (bdx * cdy + -(cdx * bdy)) * adz;
  const Expansion<64> b_part = (cdx * ady + -(adx * cdy)) * bdz;
  const Expansion<64> c_part = (adx * bdy + -(bdx * ady)) * cdz;
  return (a_part + b_part + c_part).sign_of();
}

}  // namespace

int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int x, int y) {
  const double left = (a[x] - c[x]) * (b[y] - c[y]), right = (a[y] - c[y]) * (b[x] - c[x]);
  const double det = left - right, size = std::abs(left) + std::abs(right);
  if (std::abs(det) > orient2d_error_rel * size || size == 0.0) return sign(det);
  return orient2d_exact(a, b, c, x, y);
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ad = a - d, bd = b - d, cd = c - d;
  const double bc = bd.x() * cd.y(), cb = cd.x() * bd.y();
  const double ca = cd.x() * ad.y(), ac = ad.x() * cd.y();
  const double ab = ad.x() * bd.y(), ba = bd.x() * ad.y();
  const double det = ad.z() * (bc - cb) + bd.z() * (ca - ac) + cd.z() * (ab - ba);
  const double size = (std::abs(bc) + std::abs(cb)) * std::abs(ad.z()) +
                      (std::abs(ca) + std::abs(ac)) * std::abs(bd.z()) +
                      (std::abs(ab) + std::abs(ba)) * std::abs(cd.z());
  if (std::abs(det) > orient3d_error_rel * size || size == 0.0) return sign(det);
  return orient3d_exact(a, b, c, d);
}

}  // namespace whittle::metrics
