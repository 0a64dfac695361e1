#include "whittle/bake/bake.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "support/shapes/shapes.hh"
#include "unit/render/render_scenes.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/render/srgb.hh"

namespace whittle::bake {
namespace {

using render::Rgb;
using Light = std::function<Vec3(const Vec3& position)>;

/// A mesh whose vertices have linear colours.
IndexedMesh colored(IndexedMesh mesh, const Light& light) {
  for (const Vec3& p : mesh.positions) {
    const Vec3 c = light(p);
    mesh.colors.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]), 1});
  }
  return mesh;
}

/// The value of a picture at texture coordinates, between the centres of its pixels.
Vec3 bilinear(const render::Picture& picture, double u, double v) {
  const double x = u * static_cast<double>(picture.width) - 0.5;
  const double y = v * static_cast<double>(picture.height) - 0.5;
  const auto left = static_cast<std::size_t>(x);
  const auto top = static_cast<std::size_t>(y);
  const auto at = [&](std::size_t column, std::size_t row) {
    const Rgb& rgb = picture.pixels[row * picture.width + column];
    return Vec3(rgb[0], rgb[1], rgb[2]);
  };
  const double s = x - static_cast<double>(left);
  const double t = y - static_cast<double>(top);
  return (1 - t) * ((1 - s) * at(left, top) + s * at(left + 1, top)) +
         t * ((1 - s) * at(left, top + 1) + s * at(left + 1, top + 1));
}

/// Calls `use(face, weights of its corners)` for places all over a mesh, corners and sides among them.
void for_each_place(const IndexedMesh& mesh,
                    const std::function<void(std::size_t, const std::array<double, 3>&)>& use) {
  constexpr int n = 6;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (int i = 0; i <= n; ++i) {
      for (int k = 0; i + k <= n; ++k) use(f, {double(i) / n, double(k) / n, double(n - i - k) / n});
    }
  }
}

Vec3 position_at(const IndexedMesh& mesh, std::size_t face, const std::array<double, 3>& weights) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * mesh.positions[mesh.faces[face][k]];
  return sum;
}

/// A number of an attribute, as a renderer has it at a place.
Eigen::Vector4d value_at(const IndexedMesh& mesh, std::size_t attribute, std::size_t face,
                         const std::array<double, 3>& weights) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = mesh.attributes[attribute].value(mesh.wedge(face, k));
    for (std::size_t i = 0; i < value.size(); ++i) sum[static_cast<Eigen::Index>(i)] += weights[k] * value[i];
  }
  return sum;
}

Vec3 shown_light(const Baked& baked, std::size_t face, const std::array<double, 3>& weights) {
  const Eigen::Vector4d uv = value_at(baked.mesh, 0, face, weights);
  return bilinear(baked.base_color, uv[0], uv[1]).unaryExpr([](double v) { return render::linear_of_srgb(v); });
}

Vec3 smooth_light(const Vec3& p) {
  return {0.5 + 0.4 * std::sin(2 * p.x()), 0.5 + 0.4 * std::cos(3 * p.y()), 0.5 + 0.3 * std::sin(p.z() + p.x())};
}

TEST(Bake, ShowsTheColorsOfTheNearestPlace) {
  const IndexedMesh detailed = colored(test::sphere(6), smooth_light);
  const IndexedMesh coarse = test::sphere(2);
  const Baked baked = bake(render::scene_of(detailed), coarse, {.texture_size = 1024});
  EXPECT_EQ(baked.n_missed, 0U);
  EXPECT_EQ(baked.mesh.positions, coarse.positions);
  EXPECT_EQ(baked.mesh.faces, coarse.faces);
  double worst = 0;
  for_each_place(coarse, [&](std::size_t f, const std::array<double, 3>& weights) {
    const Vec3 expected = smooth_light(position_at(coarse, f, weights).normalized());
    worst = std::max(worst, (shown_light(baked, f, weights) - expected).cwiseAbs().maxCoeff());
  });
  EXPECT_LT(worst, 0.03);  // a texel is 0.007 long, half a step of 8 bits is 0.004
}

TEST(Bake, TakesTextureFactorAndVertexColorTogether) {
  IndexedMesh high = render::square();
  high.colors.assign(high.positions.size(), {0.5F, 1, 1, 1});
  Material material = render::textured(render::colorful_image());
  material.base_color = {1, 0.5, 1, 1};
  const Baked baked = bake(render::scene_of(high, material), render::square(), {.texture_size = 512});
  const Baked plain = bake(render::scene_of(render::square(), render::textured(render::colorful_image())),
                           render::square(), {.texture_size = 512});
  for_each_place(baked.mesh, [&](std::size_t f, const std::array<double, 3>& weights) {
    const Vec3 expected = shown_light(plain, f, weights).cwiseProduct(Vec3(0.5, 0.5, 1));
    EXPECT_LT((shown_light(baked, f, weights) - expected).cwiseAbs().maxCoeff(), 0.012);
  });
}

/// Front and back of a thin sheet have colours of their own.
TEST(Bake, TakesColorsFromTheSideThatFacesTheSameWay) {
  IndexedMesh sheet = test::grid(8, 8);
  const std::size_t n = sheet.positions.size();
  IndexedMesh high = colored(sheet, [](const Vec3&) { return Vec3(1, 0, 0); });
  for (std::size_t v = 0; v < n; ++v) {
    high.positions.push_back(high.positions[v] - Vec3(0, 0, 1e-3));
    high.colors.push_back({0, 0, 1, 1});
  }
  for (const Triangle& face : sheet.faces) {
    const auto down = [n](Index v) { return static_cast<Index>(v + n); };
    high.faces.push_back({down(face[0]), down(face[2]), down(face[1])});
  }
  IndexedMesh front = test::grid(2, 2);
  for (Vec3& p : front.positions) p = Vec3(4 * p.x(), 4 * p.y(), -8e-4);  // nearer to the back
  IndexedMesh back = front;
  for (Triangle& face : back.faces) std::swap(face[1], face[2]);
  for (const bool is_front : {true, false}) {
    const Baked baked = bake(render::scene_of(high), is_front ? front : back, {.texture_size = 64});
    EXPECT_EQ(baked.n_missed, 0U);
    for (const Rgb& pixel : baked.base_color.pixels) EXPECT_EQ(pixel, is_front ? Rgb({1, 0, 0}) : Rgb({0, 0, 1}));
  }
}

TEST(Bake, CountsPlacesWithoutASurfaceNearBy) {
  const IndexedMesh high = colored(test::grid(4, 4), smooth_light);
  IndexedMesh low = test::grid(4, 4);
  for (Vec3& p : low.positions) p.z() += 1;
  const Baked baked = bake(render::scene_of(high), low, {.texture_size = 64});
  EXPECT_GT(baked.n_samples, 500U);
  EXPECT_EQ(baked.n_missed, baked.n_samples);
  EXPECT_EQ(bake(render::scene_of(high), low, {.texture_size = 64, .reach_rel = 0.5}).n_missed, 0U);
}

/// glTF 2.0, sections 3.7.2 and 3.9.3: the normal that a renderer gets from the map is that of the detailed mesh.
TEST(Bake, MapsNormalsInTangentSpace) {
  IndexedMesh detailed = colored(test::sphere(6), smooth_light);
  const auto bent = [](const Vec3& p) { return (p + 0.3 * Vec3(std::sin(3 * p.y()), 0.5, p.x())).normalized(); };
  for (const Vec3& p : detailed.positions) {
    const Vec3 n = bent(p);
    detailed.normals.push_back({static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z())});
  }
  const Baked baked = bake(render::scene_of(detailed), test::sphere(2), {.texture_size = 1024});
  ASSERT_TRUE(baked.normal_map);
  double worst_deg = 0;
  for_each_place(baked.mesh, [&](std::size_t f, const std::array<double, 3>& weights) {
    const Eigen::Vector4d uv = value_at(baked.mesh, 0, f, weights);
    const Vec3 mapped = 2 * bilinear(*baked.normal_map, uv[0], uv[1]) - Vec3::Ones();
    Vec3 normal = Vec3::Zero();
    Vec3 bitangent = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Index wedge = baked.mesh.wedge(f, k);
      const auto& n = baked.mesh.normals[wedge];
      const auto t = baked.mesh.attributes[1].value(wedge);
      normal += weights[k] * Vec3(n[0], n[1], n[2]);
      bitangent += weights[k] * t[3] * Vec3(n[0], n[1], n[2]).cross(Vec3(t[0], t[1], t[2]));
    }
    const Vec3 tangent = value_at(baked.mesh, 1, f, weights).head<3>().normalized();
    const Vec3 shown =
        (mapped.x() * tangent + mapped.y() * bitangent.normalized() + mapped.z() * normal.normalized()).normalized();
    const Vec3 expected = bent(position_at(baked.mesh, f, weights).normalized());
    worst_deg = std::max(worst_deg, std::acos(std::min(1.0, shown.dot(expected))) * 180 / 3.14159265358979);
  });
  EXPECT_LT(worst_deg, 2.5);
}

TEST(Bake, HasOneResultForAnyNumberOfThreads) {
  const IndexedMesh detailed = colored(test::noisy_sphere(5, 0.05, 3), smooth_light);
  const IndexedMesh coarse = test::sphere(2);
  const Baked one = bake(render::scene_of(detailed), coarse, {.threads = 1});
  const Baked four = bake(render::scene_of(detailed), coarse, {.threads = 4});
  EXPECT_EQ(one.base_color.pixels, four.base_color.pixels);
  EXPECT_EQ(one.normal_map->pixels, four.normal_map->pixels);
  EXPECT_EQ(one.n_missed, four.n_missed);
}

TEST(Bake, ChoosesTheSizeByTheTexelsOfTheDetailedMesh) {
  const auto size_for = [](std::size_t width) {
    const auto image = render::make_image(width, std::vector<std::uint32_t>(width * width, 0x336699ff));
    return bake(render::scene_of(render::square(), render::textured(image)), render::square()).base_color.width;
  };
  EXPECT_EQ(size_for(128), 128U);
  EXPECT_EQ(size_for(256), 256U);
  EXPECT_THROW(bake(render::scene_of(render::square()), render::square(), {.texture_size = 100}),
               std::invalid_argument);
  EXPECT_THROW(bake(render::scene_of(render::square()), render::square(), {.texture_size = 8}), std::invalid_argument);
}

TEST(Bake, CanBeCancelled) {
  const IndexedMesh detailed = colored(test::sphere(4), smooth_light);
  BakeOptions options{.texture_size = 256};
  double last = 0;
  options.progress = [&last](const TaskProgress& progress) {
    EXPECT_GE(progress.fraction, last);
    last = progress.fraction;
    return true;
  };
  EXPECT_NO_THROW(bake(render::scene_of(detailed), test::sphere(1), options));
  EXPECT_EQ(last, 1);
  options.progress = [](const TaskProgress& progress) { return progress.fraction < 0.1; };
  EXPECT_THROW(bake(render::scene_of(detailed), test::sphere(1), options), Cancelled);
}

}  // namespace
}  // namespace whittle::bake
