// Shapes with flat sides and sharp edges: patches of squares, joined where they meet.
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

/// Collects patches of squares; points closer than about 1e-9 become one vertex.
class PatchBuilder {
 public:
  /// Squares over (i, j) in [0, n_i] × [0, n_j]; their normal is ∂i × ∂j of `point`.
  void add(int n_i, int n_j, const std::function<Vec3(int, int)>& point) {
    for (int j = 0; j < n_j; ++j)
      for (int i = 0; i < n_i; ++i) {
        const Index a = vertex(point(i, j));
        const Index b = vertex(point(i + 1, j));
        const Index c = vertex(point(i + 1, j + 1));
        const Index d = vertex(point(i, j + 1));
        mesh_.faces.push_back({a, b, c});
        mesh_.faces.push_back({a, c, d});
      }
  }

  IndexedMesh take() { return std::move(mesh_); }

 private:
  Index vertex(const Vec3& p) {
    const std::array<std::int64_t, 3> key = {std::llround(p.x() * 1e9), std::llround(p.y() * 1e9),
                                             std::llround(p.z() * 1e9)};
    auto [it, is_new] = vertices_.try_emplace(key, static_cast<Index>(mesh_.positions.size()));
    if (is_new) mesh_.positions.push_back(p);
    return it->second;
  }

  IndexedMesh mesh_;
  std::map<std::array<std::int64_t, 3>, Index> vertices_;
};

/// Point i of 0…n on the way from a to b; the ends are exact.
double between(double a, double b, int i, int n) { return i == n ? b : a + (b - a) * i / n; }

// The bracket: the plate [-1, 1]² × [0, thickness] and the wall [-1 - thickness, -1] × [-1, 1] × [0, height].
constexpr double thickness = 0.25;
constexpr double height = 2.0;
constexpr double hole_radius = 0.5;

/// Point j of 0…4n on the outline of the plate, counter-clockwise from the corner (1, -1).
Eigen::Vector2d outline(int j, int n) {
  const int side = (j / n) % 4;
  const double t = between(-1, 1, j % n, n);
  if (side == 0) return {1, t};
  if (side == 1) return {-t, 1};
  if (side == 2) return {-1, -t};
  return {t, -1};
}

/// Point j on the edge of the hole, in the same direction from the centre as point j of the outline.
Eigen::Vector2d hole(int j, int n) { return hole_radius * outline(j, n).normalized(); }

void add_plate(PatchBuilder& builder, int n) {
  const auto at = [](const Eigen::Vector2d& p, double z) { return Vec3(p.x(), p.y(), z); };
  const auto ring = [n](int j, int r) -> Eigen::Vector2d {
    if (r == n) return outline(j, n);
    return hole(j, n) + (outline(j, n) - hole(j, n)) * r / n;
  };
  builder.add(n, 4 * n, [&](int r, int j) { return at(ring(j, r), thickness); });
  builder.add(4 * n, n, [&](int j, int r) { return at(ring(j, r), 0); });
  builder.add(1, 4 * n, [&](int s, int j) { return at(hole(j, n), between(0, thickness, s, 1)); });
  // Three sides of the outline. The wall begins at the fourth, x = -1.
  builder.add(2 * n, 1, [&](int j, int s) { return at(outline(j, n), between(0, thickness, s, 1)); });
  builder.add(n, 1, [&](int j, int s) { return at(outline(3 * n + j, n), between(0, thickness, s, 1)); });
}

void add_wall(PatchBuilder& builder, int n) {
  const double back = -1 - thickness;
  const auto y = [n](int i) { return between(-1, 1, i, n); };
  // Levels: the floor, the top of the plate, then n steps up.
  const auto z = [n](int k) { return k == 0 ? 0.0 : between(thickness, height, k - 1, n); };
  const auto x = [back](int i) { return between(back, -1, i, 1); };
  builder.add(n + 1, n, [&](int k, int i) { return Vec3(back, y(i), z(k)); });
  builder.add(n, n, [&](int i, int k) { return Vec3(-1, y(i), z(k + 1)); });
  builder.add(1, n, [&](int a, int i) { return Vec3(x(a), y(i), height); });
  builder.add(n, 1, [&](int i, int a) { return Vec3(x(a), y(i), 0); });
  builder.add(1, n + 1, [&](int a, int k) { return Vec3(x(a), -1, z(k)); });
  builder.add(n + 1, 1, [&](int k, int a) { return Vec3(x(a), 1, z(k)); });
}

void require_shape(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(what);
}

}  // namespace

IndexedMesh cube() {
  IndexedMesh mesh;
  mesh.positions = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  mesh.faces = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  return mesh;
}

IndexedMesh tessellated_cube(int n) {
  require_shape(n >= 1, "test shape: a cube has at least one square a side");
  PatchBuilder builder;
  const auto t = [n](int i) { return between(-1, 1, i, n); };
  for (int axis = 0; axis < 3; ++axis) {
    // (axis, axis + 1, axis + 2) is a right-handed frame, so the normal of ∂i × ∂j is +axis.
    const auto point = [&](double side, int i, int j) {
      Vec3 p;
      p[axis] = side;
      p[(axis + 1) % 3] = t(i);
      p[(axis + 2) % 3] = t(j);
      return p;
    };
    builder.add(n, n, [&](int i, int j) { return point(1, i, j); });
    builder.add(n, n, [&](int j, int i) { return point(-1, i, j); });
  }
  return builder.take();
}

IndexedMesh cone(int n_around, double height_of_apex) {
  require_shape(n_around >= 3, "test shape: a cone needs three vertices around");
  IndexedMesh mesh;
  for (int i = 0; i < n_around; ++i) {
    const double angle = 2 * std::numbers::pi * i / n_around;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  const auto n = static_cast<Index>(n_around);
  mesh.positions.emplace_back(0, 0, height_of_apex);
  mesh.positions.emplace_back(0, 0, 0);
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    mesh.faces.push_back({i, next, n});
    mesh.faces.push_back({next, i, n + 1});
  }
  return mesh;
}

IndexedMesh frustum(int n_around, double height_of_top) {
  require_shape(n_around >= 3, "test shape: a frustum needs three vertices around");
  IndexedMesh mesh;
  for (const double radius : {1.0, 0.5})
    for (int i = 0; i < n_around; ++i) {
      const double angle = 2 * std::numbers::pi * i / n_around;
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                  radius == 1.0 ? 0.0 : height_of_top);
    }
  const auto n = static_cast<Index>(n_around);
  mesh.positions.emplace_back(0, 0, 0);
  mesh.positions.emplace_back(0, 0, height_of_top);
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    mesh.faces.push_back({i, next, n + next});
    mesh.faces.push_back({i, n + next, n + i});
    mesh.faces.push_back({next, i, 2 * n});
    mesh.faces.push_back({n + i, n + next, 2 * n + 1});
  }
  return mesh;
}

namespace {

void add_circle(IndexedMesh& mesh, int n, double radius, double z) {
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

/// Faces between two circles of n vertices, the numbers of their first ones.
void add_band(IndexedMesh& mesh, Index n, Index from, Index to) {
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    mesh.faces.push_back({from + i, from + next, to + next});
    mesh.faces.push_back({from + i, to + next, to + i});
  }
}

/// Counter-clockwise inside of a circle of n vertices.
std::vector<Triangle> faces_of_cap(Index n, Caps caps, Index middle) {
  std::vector<Triangle> faces;
  if (caps == Caps::fan) {
    for (Index i = 1; i + 1 < n; ++i) faces.push_back({0, i, i + 1});
  } else if (caps == Caps::center) {
    for (Index i = 0; i < n; ++i) faces.push_back({middle, i, (i + 1) % n});
  } else {
    for (Index low = 0, high = n - 1; high - low > 1;) {
      faces.push_back({low, low + 1, high});
      if (++low; high - low > 1) faces.push_back({low, high - 1, high});
      --high;
    }
  }
  return faces;
}

}  // namespace

IndexedMesh capped_cylinder(int n_around, Caps caps) {
  require_shape(n_around >= 3, "test shape: a cylinder needs three vertices around");
  const auto n = static_cast<Index>(n_around);
  IndexedMesh mesh;
  add_circle(mesh, n_around, 1, 0);
  add_circle(mesh, n_around, 1, 1);
  if (caps == Caps::center) mesh.positions.insert(mesh.positions.end(), {Vec3(0, 0, 0), Vec3(0, 0, 1)});
  add_band(mesh, n, 0, n);
  for (const auto& [a, b, c] : faces_of_cap(n, caps, 2 * n)) mesh.faces.push_back({a, c, b});
  for (const auto& [a, b, c] : faces_of_cap(n, caps, n + 1)) mesh.faces.push_back({a + n, b + n, c + n});
  return mesh;
}

IndexedMesh washer(int n_around) {
  require_shape(n_around >= 3, "test shape: a washer needs three vertices around");
  const auto n = static_cast<Index>(n_around);
  constexpr double washer_height = 0.2;
  IndexedMesh mesh;
  add_circle(mesh, n_around, 1, 0);
  add_circle(mesh, n_around, 1, washer_height);
  add_circle(mesh, n_around, 0.5, washer_height);
  add_circle(mesh, n_around, 0.5, 0);
  for (Index circle = 0; circle < 4; ++circle) add_band(mesh, n, circle * n, (circle + 1) % 4 * n);
  return mesh;
}

IndexedMesh drilled_plate(int n_around, Caps caps) {
  require_shape(n_around >= 8 && n_around % 4 == 0, "test shape: a hole has a multiple of four vertices around");
  require_shape(caps != Caps::center, "test shape: a plate with a hole has no middle");
  const auto n = static_cast<Index>(n_around);
  const Index n_outside = caps == Caps::strip ? n : 4;
  constexpr double plate_height = 0.1;
  IndexedMesh mesh;
  for (const double z : {0.0, plate_height}) {
    for (Index i = 0; i < n_outside; ++i) {
      const double angle = 2 * std::numbers::pi * (i + (caps == Caps::strip ? 0 : 0.5)) / n_outside;
      const double to_side = std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
      mesh.positions.emplace_back(std::cos(angle) / to_side, std::sin(angle) / to_side, z);
    }
    add_circle(mesh, n_around, 0.6, z);
  }
  const Index top = n_outside + n;
  add_band(mesh, n_outside, 0, top);
  add_band(mesh, n, top + n_outside, n_outside);
  if (caps == Caps::strip) {
    add_band(mesh, n, n, 0);
    add_band(mesh, n, top, top + n);
    return mesh;
  }
  const auto add_on_both_sides = [&](Index a, Index b, Index c) {
    mesh.faces.push_back({c, b, a});
    mesh.faces.push_back({top + a, top + b, top + c});
  };
  for (Index corner = 0; corner < 4; ++corner) {
    const Index begin = corner * n / 4;  // of the quarter of the hole that the corner sees
    for (Index i = begin; i < begin + n / 4; ++i) add_on_both_sides(corner, 4 + (i + 1) % n, 4 + i);
    add_on_both_sides(corner, (corner + 1) % 4, 4 + (begin + n / 4) % n);
  }
  return mesh;
}

IndexedMesh bracket(int n_side) {
  require_shape(n_side >= 2, "test shape: a bracket has at least two squares a side");
  PatchBuilder builder;
  add_plate(builder, n_side);
  add_wall(builder, n_side);
  return builder.take();
}

}  // namespace whittle::test
