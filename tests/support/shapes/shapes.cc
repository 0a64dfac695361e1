#include "support/shapes/shapes.hh"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "support/random.hh"

namespace whittle::test {
namespace {

constexpr double pi = std::numbers::pi;

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("test shape: ") + what);
}

Index index(int i) { return static_cast<Index>(i); }

/// The two triangles of a square a b c d, given counter-clockwise and cut along a–c.
void add_square(IndexedMesh& mesh, Index a, Index b, Index c, Index d) {
  mesh.faces.push_back({a, b, c});
  mesh.faces.push_back({a, c, d});
}

/// The squares of a periodic grid: nu × nv vertices in rows of nv, both directions closed.
void add_wrapped_squares(IndexedMesh& mesh, int nu, int nv) {
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const int next_i = (i + 1) % nu;
      const int next_j = (j + 1) % nv;
      add_square(mesh, index(i * nv + j), index(next_i * nv + j), index(next_i * nv + next_j), index(i * nv + next_j));
    }
}

/// One round of cutting each face in four, with new vertices at the middles of the edges.
void subdivide(IndexedMesh& mesh) {
  std::map<std::pair<Index, Index>, Index> middle;
  auto midpoint = [&](Index a, Index b) {
    auto [it, is_new] = middle.try_emplace(std::minmax(a, b), static_cast<Index>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    return it->second;
  };
  std::vector<Triangle> faces;
  faces.reserve(4 * mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces) {
    const Index ab = midpoint(a, b);
    const Index bc = midpoint(b, c);
    const Index ca = midpoint(c, a);
    faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.faces = std::move(faces);
}

Vec3 random_direction(Random& random) {
  while (true) {
    const Vec3 v = random.uniform_vector(-1, 1);
    if (v.squaredNorm() > 0.01 && v.squaredNorm() < 1.0) return v.normalized();
  }
}

Vec3 torus_point(double u, double v, double major_radius, double minor_radius) {
  const double ring = major_radius + minor_radius * std::cos(v);
  return {ring * std::cos(u), ring * std::sin(u), minor_radius * std::sin(v)};
}

/// A torus whose tube has the radius `radius_at()` at each vertex; called in the order of the vertices.
template <class RadiusAt>
IndexedMesh torus_with(int nu, int nv, double major_radius, RadiusAt radius_at) {
  require(nu >= 3 && nv >= 3, "a torus needs three vertices each way round");
  IndexedMesh mesh;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j)
      mesh.positions.push_back(torus_point(2 * pi * i / nu, 2 * pi * j / nv, major_radius, radius_at()));
  add_wrapped_squares(mesh, nu, nv);
  return mesh;
}

}  // namespace

IndexedMesh tetrahedron() {
  IndexedMesh mesh;
  mesh.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return mesh;
}

IndexedMesh octahedron() {
  IndexedMesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

IndexedMesh icosahedron() {
  IndexedMesh mesh;
  const double g = std::numbers::phi;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& p : mesh.positions) p.normalize();
  mesh.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return mesh;
}

IndexedMesh csaszar_torus() {
  // The seven-vertex triangulation of the torus in the cyclic order i, i+1, i+3 and i, i+3, i+2 (modulo 7). With the
  // well-known coordinates no two faces intersect.
  IndexedMesh mesh;
  mesh.positions = {{3, -3, 0}, {3, 3, 1}, {1, 2, 3}, {-1, -2, 3}, {-3, -3, 1}, {-3, 3, 0}, {0, 0, 15}};
  for (Index i = 0; i < 7; ++i) {
    mesh.faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    mesh.faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return mesh;
}

IndexedMesh sphere(int levels) {
  require(levels >= 0 && levels <= 10, "a sphere has 0 to 10 levels");
  IndexedMesh mesh = icosahedron();
  for (int level = 0; level < levels; ++level) {
    subdivide(mesh);
    for (Vec3& p : mesh.positions) p.normalize();
  }
  return mesh;
}

IndexedMesh uv_sphere(int n_lat, int n_lon) {
  require(n_lat >= 2 && n_lon >= 3, "a sphere needs two bands of three");
  IndexedMesh mesh;
  for (int i = 1; i < n_lat; ++i)
    for (int j = 0; j < n_lon; ++j) {
      const double lat = pi * i / n_lat;
      const double lon = 2 * pi * j / n_lon;
      mesh.positions.emplace_back(std::sin(lat) * std::cos(lon), std::sin(lat) * std::sin(lon), std::cos(lat));
    }
  const auto north = static_cast<Index>(mesh.positions.size());
  const Index south = north + 1;
  mesh.positions.emplace_back(0, 0, 1);
  mesh.positions.emplace_back(0, 0, -1);
  const int last = (n_lat - 2) * n_lon;
  for (int j = 0; j < n_lon; ++j) {
    const int next = (j + 1) % n_lon;
    mesh.faces.push_back({north, index(j), index(next)});
    for (int i = 0; i + 2 < n_lat; ++i) {
      const int row = i * n_lon;
      add_square(mesh, index(row + j), index(row + n_lon + j), index(row + n_lon + next), index(row + next));
    }
    mesh.faces.push_back({south, index(last + next), index(last + j)});
  }
  return mesh;
}

IndexedMesh torus(int nu, int nv, double major_radius, double minor_radius) {
  return torus_with(nu, nv, major_radius, [&] { return minor_radius; });
}

IndexedMesh noisy_torus(int nu, int nv, double major_radius, double minor_radius, double amplitude,
                        std::uint64_t seed) {
  Random random(seed);
  return torus_with(nu, nv, major_radius, [&] { return minor_radius + random.uniform(-amplitude, amplitude); });
}

IndexedMesh noisy_sphere(int levels, double amplitude, std::uint64_t seed) {
  Random random(seed);
  IndexedMesh mesh = sphere(levels);
  for (Vec3& p : mesh.positions) p *= 1.0 + random.uniform(-amplitude, amplitude);
  return mesh;
}

IndexedMesh blob(int levels, std::uint64_t seed) {
  struct Bump {
    Vec3 direction;
    double height;
    double sharpness;
  };
  Random random(seed);
  std::vector<Bump> bumps;
  // Heights alternate in sign, so the sum stays near 1 for any seed. The clamp below limits rare outliers.
  for (int i = 0; i < 14; ++i) {
    const double height = (i % 2 == 0 ? 1.0 : -0.6) * random.uniform(0.1, 0.35);
    const Vec3 direction = random_direction(random);
    bumps.push_back({direction, height, random.uniform(3.0, 18.0)});
  }
  IndexedMesh mesh = sphere(levels);
  for (Vec3& p : mesh.positions) {
    double radius = 1.0;
    for (const Bump& bump : bumps) radius += bump.height * std::exp(bump.sharpness * (bump.direction.dot(p) - 1.0));
    p *= 1.1 + 0.5 * std::tanh((radius - 1.1) / 0.5);
  }
  return mesh;
}

IndexedMesh knot(int n_along, int n_around) {
  require(n_along >= 24 && n_around >= 3, "a knot needs 24 vertices along and three around");
  IndexedMesh mesh;
  for (int i = 0; i < n_along; ++i) {
    const double t = 2 * pi * i / n_along;
    // The curve winds three times around the tube of the torus of radii 2 and 1, and twice around the torus axis.
    const Vec3 outward(std::cos(3 * t) * std::cos(2 * t), std::cos(3 * t) * std::sin(2 * t), std::sin(3 * t));
    const Vec3 centre = 2 * Vec3(std::cos(2 * t), std::sin(2 * t), 0) + outward;
    const double ring = 2 + std::cos(3 * t);
    const Vec3 along =
        ring * 2 * Vec3(-std::sin(2 * t), std::cos(2 * t), 0) +
        3 * Vec3(-std::sin(3 * t) * std::cos(2 * t), -std::sin(3 * t) * std::sin(2 * t), std::cos(3 * t));
    const Vec3 sideways = outward.cross(along.normalized());
    for (int j = 0; j < n_around; ++j) {
      const double s = 2 * pi * j / n_around;
      const double radius = 0.42 * (1 + 0.08 * std::cos(6 * s + 24 * t));
      mesh.positions.push_back(centre + radius * (std::cos(s) * outward + std::sin(s) * sideways));
    }
  }
  add_wrapped_squares(mesh, n_along, n_around);
  return mesh;
}

IndexedMesh grid(int nx, int ny) {
  require(nx >= 1 && ny >= 1, "a grid has at least one square each way");
  IndexedMesh mesh;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) mesh.positions.emplace_back(i, j, 0);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i;
      add_square(mesh, index(a), index(a + 1), index(a + nx + 2), index(a + nx + 1));
    }
  return mesh;
}

IndexedMesh noisy_grid(int nx, int ny, double amplitude, std::uint64_t seed) {
  Random random(seed);
  IndexedMesh mesh = grid(nx, ny);
  for (Vec3& p : mesh.positions) p.z() = random.uniform(-amplitude, amplitude);
  return mesh;
}

IndexedMesh terrain(int n, std::uint64_t seed) {
  struct Wave {
    double kx, ky, phase, height;
  };
  Random random(seed);
  std::vector<Wave> waves;
  for (int octave = 0; octave < 6; ++octave)
    for (int i = 0; i < 4; ++i) {
      const double frequency = std::ldexp(3.0, octave);
      const double angle = random.uniform(0, 2 * pi);
      waves.push_back({frequency * std::cos(angle), frequency * std::sin(angle), random.uniform(0, 2 * pi),
                       std::ldexp(0.05, -octave)});
    }
  IndexedMesh mesh = grid(n, n);
  for (Vec3& p : mesh.positions) {
    p /= n;
    for (const Wave& wave : waves) p.z() += wave.height * std::sin(wave.kx * p.x() + wave.ky * p.y() + wave.phase);
  }
  return mesh;
}

IndexedMesh open_cylinder(int n_around, int n_along) {
  require(n_around >= 3 && n_along >= 1, "a cylinder needs three vertices around");
  IndexedMesh mesh;
  for (int j = 0; j <= n_along; ++j)
    for (int i = 0; i < n_around; ++i) {
      const double angle = 2 * pi * i / n_around;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 2.0 * j / n_along);
    }
  for (int j = 0; j < n_along; ++j)
    for (int i = 0; i < n_around; ++i) {
      const int row = j * n_around;
      const int next = (i + 1) % n_around;
      add_square(mesh, index(row + i), index(row + next), index(row + n_around + next), index(row + n_around + i));
    }
  return mesh;
}

IndexedMesh moebius(int n_along, int n_across) {
  require(n_along >= 5 && n_across >= 1, "a Möbius strip needs five squares along and one across");
  IndexedMesh mesh;
  const int columns = n_across + 1;
  for (int i = 0; i < n_along; ++i)
    for (int j = 0; j < columns; ++j) {
      const double u = 2 * pi * i / n_along;
      const double v = 2.0 * j / n_across - 1.0;
      const double ring = 1.0 + 0.4 * v * std::cos(u / 2);
      mesh.positions.emplace_back(ring * std::cos(u), ring * std::sin(u), 0.4 * v * std::sin(u / 2));
    }
  // The last column of squares is joined to the first one upside down.
  auto vertex = [&](int i, int j) { return i < n_along ? index(i * columns + j) : index(n_across - j); };
  for (int i = 0; i < n_along; ++i)
    for (int j = 0; j < n_across; ++j)
      add_square(mesh, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  return mesh;
}

IndexedMesh single_triangle() {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

IndexedMesh two_triangles() {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

}  // namespace whittle::test
