#include "whittle/bake/unwrap.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "support/shapes/shapes.hh"
#include "whittle/core/geometry/image_triangle.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::bake {
namespace {

using detail::Vec2;

/// A strip that winds round an axis and climbs, so that its turns lie over each other along the axis.
IndexedMesh helix(int n_turns) {
  constexpr int n_around = 24;
  IndexedMesh mesh;
  for (int i = 0; i <= n_turns * n_around; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n_around;
    const double height = 0.5 * i / n_around;
    for (const double radius : {1.0, 2.0}) {
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  for (Index v = 0; v + 3 < mesh.positions.size(); v += 2) {
    mesh.faces.push_back({v, v + 1, v + 3});
    mesh.faces.push_back({v, v + 3, v + 2});
  }
  return mesh;
}

std::map<std::string, IndexedMesh> test_meshes() {
  IndexedMesh far_away = test::sphere(3);
  for (Vec3& p : far_away.positions) p = 1e-3 * p + Vec3(5e5, -3e6, 40);
  IndexedMesh with_slivers = test::grid(5, 5);
  with_slivers.faces.push_back({0, 1, 2});  // on a line
  with_slivers.faces.push_back({3, 3, 9});
  return {{"cube", test::cube()},
          {"sphere", test::sphere(4)},
          {"noisy torus", test::noisy_torus(40, 20, 1, 0.35, 0.08, 7)},
          {"knot", test::knot(120, 12)},
          {"terrain", test::terrain(30, 3)},
          {"moebius", test::moebius(40, 3)},
          {"triangle", test::single_triangle()},
          {"helix", helix(4)},
          {"far away", far_away},
          {"slivers", with_slivers}};
}

std::array<Vec2, 3> on_image(const Unwrapping& layout, std::size_t face) {
  return {layout.texcoords[3 * face], layout.texcoords[3 * face + 1], layout.texcoords[3 * face + 2]};
}

/// How many faces have each of n × n points of the image well inside.
std::vector<int> coverage(const Unwrapping& layout, int n) {
  std::vector<int> counts(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  for (std::size_t f = 0; f < layout.charts.size(); ++f) {
    const auto [a, b, c] = on_image(layout, f);
    const double area = detail::area_on_image(a, b, c);
    if (std::abs(area) < 1e-12) continue;
    const Vec2 low = n * a.cwiseMin(b).cwiseMin(c);
    const Vec2 high = n * a.cwiseMax(b).cwiseMax(c);
    for (int y = static_cast<int>(low.y()); y < high.y(); ++y) {
      for (int x = static_cast<int>(low.x()); x < high.x(); ++x) {
        const Vec2 p((x + 0.5) / n, (y + 0.5) / n);
        const double least = std::min({detail::area_on_image(p, b, c) / area, detail::area_on_image(a, p, c) / area,
                                       detail::area_on_image(a, b, p) / area});
        if (least > 1e-6) ++counts[static_cast<std::size_t>(y * n + x)];
      }
    }
  }
  return counts;
}

TEST(Unwrap, LaysNoFaceOverAnother) {
  for (const auto& [name, mesh] : test_meshes()) {
    const Unwrapping layout = unwrap(mesh, 512);
    const std::vector<int> counts = coverage(layout, 96);
    EXPECT_LE(*std::max_element(counts.begin(), counts.end()), 1) << name;
    double covered = 0;
    for (const int count : counts) covered += count;
    EXPECT_NEAR(covered / static_cast<double>(counts.size()), layout.fill, 0.05) << name;
    EXPECT_GT(layout.fill, 0.15) << name;
  }
}

/// A row of the image between two charts belongs to none of them.
TEST(Unwrap, KeepsChartsApart) {
  for (const auto& [name, mesh] : test_meshes()) {
    constexpr double size = 512;
    const Unwrapping layout = unwrap(mesh, 512);
    std::vector<Eigen::AlignedBox2d> boxes(layout.right.size());
    for (std::size_t f = 0; f < layout.charts.size(); ++f) {
      for (const Vec2& p : on_image(layout, f)) boxes[layout.charts[f]].extend(p * size);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_GE(boxes[i].min().minCoeff(), 2 - 1e-9) << name;
      EXPECT_LE(boxes[i].max().maxCoeff(), size - 2 + 1e-9) << name;
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_TRUE(boxes[i].exteriorDistance(boxes[j]) >= 2 - 1e-9) << name << ' ' << i << ' ' << j;
      }
    }
  }
}

TEST(Unwrap, GivesEachFaceAtLeastHalfOfTheLargestShare) {
  for (const auto& [name, mesh] : test_meshes()) {
    const Unwrapping layout = unwrap(mesh, 512);
    double least = 1e300;
    double most = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const double area = area_of(mesh.positions, mesh.faces[f]);
      if (area < 1e-15) continue;
      const auto [a, b, c] = on_image(layout, f);
      const double share = -detail::area_on_image(a, b, c) / 2 / area;  // rows go down: the front turns clockwise
      EXPECT_GT(share, 0) << name << ' ' << f;
      least = std::min(least, share);
      most = std::max(most, share);
    }
    EXPECT_GE(least, 0.499 * most) << name;
  }
}

TEST(Unwrap, GivesTheCornersOfAChartOnePlaceAVertex) {
  for (const auto& [name, mesh] : test_meshes()) {
    const Unwrapping layout = unwrap(mesh, 256);
    std::map<std::pair<Index, Index>, Vec2> places;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2& own = layout.texcoords[3 * f + k];
        const auto [place, is_new] = places.try_emplace({layout.charts[f], mesh.faces[f][k]}, own);
        EXPECT_EQ(place->second, own) << name;
      }
    }
  }
}

TEST(Unwrap, RefusesWhatHasNoPlace) {
  IndexedMesh line;
  line.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  line.faces = {{0, 1, 2}};
  EXPECT_THROW(unwrap(line, 64), std::invalid_argument);
  IndexedMesh soup;  // 900 faces that share nothing
  for (int i = 0; i < 900; ++i) {
    const auto v = static_cast<Index>(soup.positions.size());
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) soup.positions.push_back(p + Vec3(0, 0, i));
    soup.faces.push_back({v, v + 1, v + 2});
  }
  EXPECT_THROW(unwrap(soup, 32), std::invalid_argument);
  EXPECT_EQ(unwrap(soup, 512).right.size(), 900U);
}

}  // namespace
}  // namespace whittle::bake
