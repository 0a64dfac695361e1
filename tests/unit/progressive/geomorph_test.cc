#include "whittle/progressive/geomorph.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::progressive {
namespace {

using test::NamedMesh;

/// A face by the places of its corners, from the lowest one on.
using PlacedFace = std::array<std::array<double, 3>, 3>;

PlacedFace placed(const IndexedMesh& mesh, const Triangle& face) {
  PlacedFace corners{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3& p = mesh.positions[face[c]];
    corners[c] = {p[0], p[1], p[2]};
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// How often each face that has an area is there; faces on their backs count against those on their fronts.
std::map<PlacedFace, int> surface_of(const IndexedMesh& mesh) {
  std::map<PlacedFace, int> counts;
  for (const Triangle& face : mesh.faces) {
    PlacedFace front = placed(mesh, face);
    if (front[0] == front[1] || front[1] == front[2] || front[2] == front[0]) continue;
    PlacedFace back = front;
    std::swap(back[1], back[2]);
    ++counts[front];
    const int n_both = std::min(counts[front], counts[back]);
    counts[front] -= n_both;
    counts[back] -= n_both;
  }
  std::erase_if(counts, [](const auto& one) { return one.second == 0; });
  return counts;
}

/// The same, each face once.
std::map<PlacedFace, int> once(std::map<PlacedFace, int> counts) {
  for (auto& [face, n] : counts) n = 1;
  return counts;
}

Decimation recorded(const IndexedMesh& mesh, DecimateOptions options, std::uint64_t n_faces) {
  options.keep_steps = true;
  return decimate(mesh, DecimateTarget::faces(n_faces), options);
}

void expect_ends(Replay& replay, std::size_t fine_level, std::size_t coarse_level, const std::string& what) {
  const Geomorph geomorph(replay, fine_level, coarse_level);
  replay.go_to(fine_level);
  const IndexedMesh fine = replay.decimation().mesh;
  replay.go_to(coarse_level);
  const IndexedMesh coarse = replay.decimation().mesh;
  EXPECT_EQ(geomorph.at(0).positions, fine.positions) << what;
  EXPECT_EQ(once(surface_of(geomorph.at(0))), once(surface_of(fine))) << what;
  EXPECT_EQ(once(surface_of(geomorph.at(1))), once(surface_of(coarse))) << what;
  EXPECT_EQ(geomorph.n_coarse_faces(), coarse.faces.size()) << what;
}

TEST(Geomorph, IsEachLevelAtItsEnd) {
  DecimateOptions options;
  for (const double threshold : {0.0, std::numeric_limits<double>::infinity()}) {
    options.pairs.threshold = threshold;
    for (const NamedMesh& shape : test::all_meshes()) {
      Replay replay(shape.mesh, recorded(shape.mesh, options, 1).steps);
      for (const auto& [fine, coarse] : {std::pair(0.0, 1.0), std::pair(0.0, 0.5), std::pair(0.3, 0.8)}) {
        const std::string what = shape.name + ", " + std::to_string(fine) + " to " + std::to_string(coarse);
        expect_ends(replay, replay.level_at(fine), replay.level_at(coarse), what);
      }
    }
  }
}

TEST(Geomorph, GoesThroughPassesOfPolish) {
  const IndexedMesh mesh = test::sphere(2);
  SimplifyOptions options;
  options.decimate.keep_steps = true;
  options.tries_plain_quadrics = false;
  const Simplification result = simplify(mesh, DecimateTarget::faces(60), Effort::normal, options);
  ASSERT_FALSE(result.steps.pass_ends.empty());
  Replay replay(mesh, result.steps);
  expect_ends(replay, 0, replay.n_steps(), "sphere");
}

/// No vertex goes farther in a short time than its share of the way, and no normal turns farther.
TEST(Geomorph, NeverJumps) {
  for (const NamedMesh& shape : test::all_meshes()) {
    Replay replay(shape.mesh, recorded(shape.mesh, {}, 1).steps);
    const Geomorph geomorph(replay, 0, replay.n_steps());
    for (const NormalBlend blend : {NormalBlend::spherical, NormalBlend::linear}) {
      constexpr int n_times = 64;
      IndexedMesh before = geomorph.at(0, blend);
      for (int i = 1; i <= n_times; ++i) {
        const IndexedMesh now = geomorph.at(double(i) / n_times, blend);
        ASSERT_EQ(now.faces, before.faces);
        for (std::size_t v = 0; v < now.positions.size(); ++v) {
          const double way = (geomorph.coarse().positions[v] - geomorph.fine().positions[v]).norm();
          EXPECT_LE((now.positions[v] - before.positions[v]).norm(), way / n_times * (1 + 1e-9) + 1e-15) << shape.name;
        }
        before = now;
      }
    }
  }
}

/// A geomorph whose one moving vertex has the normal `from` first, and `to` in the end.
std::vector<std::array<float, 3>> normals_between(const std::array<float, 3>& from, const std::array<float, 3>& to,
                                                  NormalBlend blend, std::size_t n_times) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.faces = {{0, 1, 2}, {2, 1, 3}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, to, from};
  RunSteps steps;
  steps.contractions = {{2, 3, Vec3(0, 1, 0), 0, false, false}};
  Replay replay(mesh, steps, Normals::keep);
  const Geomorph geomorph(replay, 0, 1);
  std::vector<std::array<float, 3>> normals;
  for (std::size_t i = 0; i <= n_times; ++i)
    normals.push_back(geomorph.at(double(i) / double(n_times), blend).normals[3]);
  return normals;
}

double angle_deg(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  const Vec3 u(a[0], a[1], a[2]);
  const Vec3 v(b[0], b[1], b[2]);
  return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / M_PI;
}

TEST(Geomorph, TurnsNormalsAtAConstantSpeed) {
  for (const std::array<float, 3>& to :
       std::vector<std::array<float, 3>>{{1, 0, 0}, {0, 0, -1}, {0, 0.6F, 0.8F}, {0, 0.6F, -0.8F}, {0, 0, 1}}) {
    constexpr std::size_t n_times = 16;
    const auto normals = normals_between({0, 0, 1}, to, NormalBlend::spherical, n_times);
    const double step = angle_deg(normals.front(), normals.back()) / n_times;
    for (std::size_t i = 1; i <= n_times; ++i) {
      EXPECT_NEAR(angle_deg(normals[i - 1], normals[i]), step, 2e-4);
      EXPECT_NEAR(Vec3(normals[i][0], normals[i][1], normals[i][2]).norm(), 1, 1e-6);
    }
  }
}

TEST(Geomorph, BlendsNormalsLinearlyOnRequest) {
  constexpr std::size_t n_times = 4;
  const auto normals = normals_between({0, 0, 1}, {0, 0.96F, -0.28F}, NormalBlend::linear, n_times);
  const Vec3 from(normals[0][0], normals[0][1], normals[0][2]);
  const Vec3 to(normals[n_times][0], normals[n_times][1], normals[n_times][2]);
  ASSERT_GT(angle_deg(normals[0], normals[n_times]), 40);
  for (std::size_t t = 0; t <= n_times; ++t) {
    const Vec3 expected = (double(n_times - t) * from + double(t) * to).normalized();
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(normals[t][i], expected[static_cast<Eigen::Index>(i)], 1e-6);
  }
}

TEST(Geomorph, SmoothsNormalsThatBreakAtCreases) {
  IndexedMesh mesh = test::tessellated_cube(4);
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  SimplifyOptions options;
  options.decimate.keep_steps = true;
  options.decimate.normals = Normals::recompute;
  const Simplification run = simplify(mesh, DecimateTarget::faces(40), Effort::fast, options);
  ASSERT_FALSE(run.mesh.wedges.empty());
  Replay replay(mesh, run.steps, Normals::recompute);
  const Geomorph geomorph(replay, 0, replay.n_steps());
  for (const IndexedMesh& end : {geomorph.at(0), geomorph.at(0.5), geomorph.at(1)}) {
    EXPECT_TRUE(end.wedges.empty());
    EXPECT_EQ(end.normals.size(), end.positions.size());
  }
}

TEST(Geomorph, RefusesLevelsThatNoMovementConnects) {
  const IndexedMesh mesh = test::sphere(2);
  RunSteps steps;
  PassEnd flip;
  const Triangle& face = mesh.faces[0];
  flip.turned = {{0, {face[1], face[2], mesh.faces[7][0]}}};
  steps.pass_ends = {flip};
  Replay replay(mesh, steps);
  EXPECT_THROW(Geomorph(replay, 0, 1), std::invalid_argument);
  EXPECT_THROW(Geomorph(replay, 1, 0), std::invalid_argument);
  EXPECT_THROW(Geomorph(replay, 0, 2), std::out_of_range);
  EXPECT_NO_THROW(Geomorph(replay, 1, 1));
}

std::string glb_of(const IndexedMesh& mesh) {
  Replay replay(mesh, recorded(mesh, {}, mesh.faces.size() / 2).steps);
  std::ostringstream out;
  write_glb(out, Geomorph(replay, 0, replay.n_steps()));
  return out.str();
}

std::uint32_t number_at(const std::string& file, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8 | static_cast<unsigned char>(file[at + i]);
  return number;
}

/// The numbers of an accessor, of 32 bits each.
template <class Number>
std::vector<Number> numbers_of(const std::string& file, const nlohmann::json& json, std::size_t accessor) {
  const std::size_t buffer = 20 + number_at(file, 12) + 8;
  const auto& one = json["accessors"][accessor];
  const auto& view = json["bufferViews"][one["bufferView"].get<std::size_t>()];
  std::vector<Number> numbers;
  const std::size_t begin = buffer + view["byteOffset"].get<std::size_t>();
  for (std::size_t at = begin; at < begin + view["byteLength"].get<std::size_t>(); at += 4) {
    numbers.push_back(std::bit_cast<Number>(number_at(file, at)));
  }
  const std::size_t n_components = one["type"] == "VEC3" ? 3 : 1;
  EXPECT_EQ(numbers.size(), n_components * one["count"].get<std::size_t>());
  return numbers;
}

TEST(WriteGlb, HasBothLevels) {
  IndexedMesh mesh = test::sphere(3);
  for (Vec3& p : mesh.positions) p += Vec3(1000, 0, 0);
  Replay replay(mesh, recorded(mesh, {}, 100).steps);
  const Geomorph geomorph(replay, 0, replay.n_steps());
  std::ostringstream out;
  write_glb(out, geomorph);
  const std::string file = out.str();
  const auto json = nlohmann::json::parse(file.substr(20, number_at(file, 12)));
  const auto& primitive = json["meshes"][0]["primitives"][0];
  const auto base = numbers_of<float>(file, json, primitive["attributes"]["POSITION"]);
  const auto target = numbers_of<float>(file, json, primitive["targets"][0]["POSITION"]);
  const auto indices = numbers_of<std::uint32_t>(file, json, primitive["indices"]);
  const auto center = json["nodes"][0]["translation"].get<std::vector<double>>();
  ASSERT_EQ(base.size(), 3 * geomorph.fine().positions.size());
  for (std::size_t v = 0; v < geomorph.fine().positions.size(); ++v) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      EXPECT_NEAR(base[3 * v + i] + center[i], geomorph.fine().positions[v][axis], 1e-7);
      EXPECT_NEAR(base[3 * v + i] + target[3 * v + i] + center[i], geomorph.coarse().positions[v][axis], 2e-7);
    }
  }
  ASSERT_EQ(indices.size(), 3 * mesh.faces.size());
  for (std::size_t i = 0; i < indices.size(); ++i) EXPECT_EQ(indices[i], geomorph.fine().faces[i / 3][i % 3]);
}

TEST(WriteGlb, SaysHowLongTheFileIs) {
  const std::string file = glb_of(test::sphere(2));
  ASSERT_GT(file.size(), 20);
  EXPECT_EQ(file.substr(0, 4), "glTF");
  EXPECT_EQ(number_at(file, 4), 2);
  EXPECT_EQ(number_at(file, 8), file.size());
  const std::size_t text_size = number_at(file, 12);
  EXPECT_EQ(20 + text_size + 8 + number_at(file, 20 + text_size), file.size());
}

TEST(WriteGlb, RefusesWhatGltfCannotHold) {
  IndexedMesh mesh = test::sphere(2);
  for (Vec3& p : mesh.positions) p *= 1e60;
  EXPECT_THROW(glb_of(mesh), std::range_error);
  Replay nothing({}, {});
  std::ostringstream out;
  EXPECT_THROW(write_glb(out, Geomorph(nothing, 0, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::progressive
