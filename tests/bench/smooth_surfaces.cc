#include "bench/smooth_surfaces.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "support/random.hh"

namespace whittle::bench {
namespace {

constexpr double pi = std::numbers::pi;

/// Share of an edge's length by which vertices are off a regular mesh, along the surface.
constexpr double jitter = 0.3;

/// An icosahedron's faces, each divided into n² faces, on the unit sphere.
IndexedMesh geodesic_sphere(std::size_t n_faces) {
  const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(n_faces) / 20))));
  const double g = std::numbers::phi;
  const std::array<Vec3, 12> corners{{{-1, g, 0},
                                      {1, g, 0},
                                      {-1, -g, 0},
                                      {1, -g, 0},
                                      {0, -1, g},
                                      {0, 1, g},
                                      {0, -1, -g},
                                      {0, 1, -g},
                                      {g, 0, -1},
                                      {g, 0, 1},
                                      {-g, 0, -1},
                                      {-g, 0, 1}}};
  constexpr std::array<std::array<std::size_t, 3>, 20> sides{
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  IndexedMesh mesh;
  std::map<std::array<std::int64_t, 3>, Index> numbers;  // vertices on edges of the icosahedron come up twice or more
  const auto vertex = [&](const Vec3& p) {
    const auto rounded = [](double x) { return static_cast<std::int64_t>(std::llround(x * 1e8)); };
    const auto [it, is_new] = numbers.try_emplace({rounded(p.x()), rounded(p.y()), rounded(p.z())},
                                                  static_cast<Index>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back(p);
    return it->second;
  };
  for (const auto& [a, b, c] : sides) {
    std::vector<std::vector<Index>> rows(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n - i; ++j) {
        rows[static_cast<std::size_t>(i)].push_back(
            vertex(((n - i - j) * corners[a] + i * corners[b] + j * corners[c]) / n));
      }
    }
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
      for (std::size_t j = 0; j + 1 < rows[i].size(); ++j) {
        mesh.faces.push_back({rows[i][j], rows[i + 1][j], rows[i][j + 1]});
        if (j + 1 < rows[i + 1].size()) mesh.faces.push_back({rows[i + 1][j], rows[i + 1][j + 1], rows[i][j + 1]});
      }
    }
  }
  test::Random random(5);
  for (Vec3& p : mesh.positions) {
    p.normalize();
    p = (p + jitter / n * random.uniform_vector(-1, 1)).normalized();
  }
  return mesh;
}

Vec3 on_sphere(double u, double v) {
  const double z = 1 - 2 * v;
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), z};
}

/// The distance from the ellipsoid x²/a² + y²/b² + z²/c² = 1, outside or inside. The foot is a² x / (a² + t) and so on;
/// t is the largest root of an equation whose left side falls.
double distance_from_ellipsoid(const Vec3& axes, const Vec3& p) {
  const Vec3 squares = axes.cwiseProduct(axes);
  const Vec3 q = p.cwiseAbs();
  const auto excess = [&](double t) {
    double sum = -1;
    for (int i = 0; i < 3; ++i) sum += std::pow(axes[i] * q[i] / (t + squares[i]), 2);
    return sum;
  };
  double low = -squares.minCoeff() + axes[2] * q[2];
  double high = low + 2 * axes.cwiseProduct(q).norm() + squares.maxCoeff();
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (excess(middle) > 0 ? low : high) = middle;
  }
  const double t = 0.5 * (low + high);
  const Vec3 foot = squares.cwiseProduct(q).cwiseQuotient(squares + Vec3::Constant(t));
  return (foot - q).norm();
}

SmoothSurface ellipsoid(const std::string& name, const Vec3& axes) {
  SmoothSurface surface;
  surface.name = name;
  surface.at = [axes](double u, double v) { return Vec3(axes.cwiseProduct(on_sphere(u, v))); };
  surface.curvature = [axes, at = surface.at](double u, double v) {
    const Vec3 p = at(u, v);
    const Vec3 fourth = axes.cwiseProduct(axes).cwiseProduct(axes).cwiseProduct(axes);
    const double sum = p.cwiseProduct(p).cwiseQuotient(fourth).sum();
    return 1 / std::pow(axes.prod() * sum, 2);
  };
  surface.distance = [axes](const Vec3& p) { return distance_from_ellipsoid(axes, p); };
  surface.mesh = [axes](std::size_t n_faces) {
    IndexedMesh mesh = geodesic_sphere(n_faces);
    for (Vec3& p : mesh.positions) p = axes.cwiseProduct(p);
    return mesh;
  };
  return surface;
}

/// \param radius of the tube; that of its middle line is 1
IndexedMesh torus_mesh(std::size_t n_faces, double radius, const std::function<Vec3(double, double)>& at) {
  const double n_vertices = static_cast<double>(n_faces) / 2;
  const int n_around = static_cast<int>(std::lround(std::sqrt(n_vertices * radius)));  // the tube
  const int n_along = static_cast<int>(std::lround(n_vertices / n_around));
  IndexedMesh mesh;
  test::Random random(7);
  for (int i = 0; i < n_along; ++i) {
    for (int j = 0; j < n_around; ++j) {
      const double u = (i + random.uniform(-jitter, jitter)) / n_along;
      const double v = (j + random.uniform(-jitter, jitter)) / n_around;
      mesh.positions.push_back(at(u, v));
    }
  }
  const auto number = [=](int i, int j) { return static_cast<Index>(i % n_along * n_around + j % n_around); };
  for (int i = 0; i < n_along; ++i) {
    for (int j = 0; j < n_around; ++j) {
      mesh.faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      mesh.faces.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  }
  return mesh;
}

SmoothSurface torus(const std::string& name, double radius) {
  SmoothSurface surface;
  surface.name = name;
  surface.at = [radius](double u, double v) {
    const double from_axis = 1 + radius * std::cos(2 * pi * v);
    return Vec3(from_axis * std::cos(2 * pi * u), from_axis * std::sin(2 * pi * u), radius * std::sin(2 * pi * v));
  };
  surface.curvature = [radius](double, double v) {
    const double cosine = std::cos(2 * pi * v);
    return cosine / (radius * (1 + radius * cosine));
  };
  surface.distance = [radius](const Vec3& p) {
    return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - radius);
  };
  surface.mesh = [radius, at = surface.at](std::size_t n_faces) { return torus_mesh(n_faces, radius, at); };
  return surface;
}

/// Calls `use(area, curvature)` for small parts of the surface.
template <class Use>
void for_each_part(const SmoothSurface& surface, const Use& use) {
  constexpr int n = 1000;
  constexpr double half = 0.5 / n;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = (i + 0.5) / n;
      const double v = (j + 0.5) / n;
      const Vec3 along_u = surface.at(u + half, v) - surface.at(u - half, v);
      const Vec3 along_v = surface.at(u, v + half) - surface.at(u, v - half);
      use(along_u.cross(along_v).norm(), surface.curvature(u, v));
    }
  }
}

}  // namespace

std::vector<SmoothSurface> smooth_surfaces() {
  return {ellipsoid("sphere", {1, 1, 1}), ellipsoid("ellipsoid", {3, 2, 1}), torus("torus-0.5", 0.5),
          torus("torus-0.25", 0.25)};
}

Errors least_errors(const SmoothSurface& surface) {
  const double elliptic_mean = 1 / (6 * std::sqrt(3.0)) - 1 / (8 * pi);
  constexpr double hyperbolic_mean = 1.0 / 12;
  const double elliptic_rms = 1 / std::sqrt(180.0);
  const double hyperbolic_rms = 1 / std::sqrt(90.0);
  const double elliptic_max = 1 / (3 * std::sqrt(3.0));
  const double hyperbolic_max = std::sqrt(3.0) / 8;
  double area = 0;
  Errors sums;
  for_each_part(surface, [&](double part, double curvature) {
    const bool is_elliptic = curvature > 0;
    const double root = std::sqrt(std::abs(curvature));
    area += part;
    sums.mean += part * std::sqrt((is_elliptic ? elliptic_mean : hyperbolic_mean) * root);
    sums.rms += part * std::pow((is_elliptic ? elliptic_rms : hyperbolic_rms) * root, 2.0 / 3);
    sums.max += part * (is_elliptic ? elliptic_max : hyperbolic_max) * root;
  });
  return {sums.mean * sums.mean / area, std::pow(sums.rms, 1.5) / std::sqrt(area), sums.max};
}

Errors errors_of(const IndexedMesh& mesh, const SmoothSurface& surface, std::size_t n_samples) {
  const std::size_t per_face = n_samples / std::max<std::size_t>(1, mesh.faces.size()) + 1;
  test::Random random(3);
  Errors errors;
  double area = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3& origin = mesh.positions[a];
    const Vec3 ab = mesh.positions[b] - origin;
    const Vec3 ac = mesh.positions[c] - origin;
    const double weight = ab.cross(ac).norm() / static_cast<double>(per_face);
    for (std::size_t i = 0; i < per_face; ++i) {
      double x = random.uniform();
      double y = random.uniform();
      if (x + y > 1) {
        x = 1 - x;
        y = 1 - y;
      }
      const double distance = surface.distance(origin + x * ab + y * ac);
      area += weight;
      errors.mean += weight * distance;
      errors.rms += weight * distance * distance;
      errors.max = std::max(errors.max, distance);
    }
  }
  for (const Vec3& p : mesh.positions) errors.max = std::max(errors.max, surface.distance(p));
  return {errors.mean / area, std::sqrt(errors.rms / area), errors.max};
}

}  // namespace whittle::bench
