#include "cost/attributes/attribute_quadrics.hh"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "cost/attributes/input_attributes.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/decimate.hh"

namespace whittle {
namespace {

/// n by n squares of two triangles each, wavy, with random texture coordinates.
IndexedMesh wavy_sheet(Index n, std::mt19937& random) {
  std::uniform_real_distribution<double> noise(-0.2, 0.2);
  IndexedMesh mesh;
  Attribute uv{"uv", AttributeKind::texcoord, 2};
  for (Index y = 0; y <= n; ++y) {
    for (Index x = 0; x <= n; ++x) {
      // In braces, so that every compiler draws the numbers in the same order.
      mesh.positions.push_back(Vec3{x + noise(random), y + noise(random), noise(random)});
      uv.values.push_back(0.1 * x + 0.1 * noise(random));
      uv.values.push_back(0.1 * y + 0.1 * noise(random));
    }
  }
  for (Index y = 0; y < n; ++y) {
    for (Index x = 0; x < n; ++x) {
      const Index v = y * (n + 1) + x;
      mesh.faces.push_back({v, v + 1, v + n + 2});
      mesh.faces.push_back({v, v + n + 2, v + n + 1});
    }
  }
  mesh.attributes.push_back(std::move(uv));
  return mesh;
}

std::vector<Index> iota(std::size_t n) {
  std::vector<Index> numbers(n);
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return numbers;
}

/// The value at x of the linear function through a face's corners, constant along its normal.
double value_at(const std::array<Vec3, 3>& corner, const std::array<double, 3>& value, const Vec3& x) {
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  Eigen::Matrix3d rows;
  rows << (corner[1] - corner[0]).transpose(), (corner[2] - corner[0]).transpose(), normal.transpose();
  const Vec3 gradient = rows.fullPivLu().solve(Vec3(value[1] - value[0], value[2] - value[0], 0));
  return value[0] + gradient.dot(x - corner[0]);
}

/// By the definition: the weighted variance of the faces' functions at x. \param corners (face, component) pairs' faces
double brute_error(const IndexedMesh& mesh, const Frame& frame, const ScaledAttributes& attributes,
                   const std::vector<std::size_t>& faces, const Vec3& x) {
  double error = 0;
  for (std::size_t j = 0; j < attributes.n_components; ++j) {
    std::vector<double> values;
    std::vector<double> areas;
    for (const std::size_t f : faces) {
      std::array<Vec3, 3> corner;
      std::array<double, 3> value{};
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = frame.to_frame(mesh.positions[mesh.faces[f][k]]);
        value[k] = attributes.values[mesh.wedge(f, k) * attributes.stride() + j];
      }
      values.push_back(value_at(corner, value, x));
      areas.push_back(0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm());
    }
    const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
    const double mean = std::inner_product(values.begin(), values.end(), areas.begin(), 0.0) / total;
    for (std::size_t i = 0; i < values.size(); ++i) error += areas[i] * (values[i] - mean) * (values[i] - mean);
  }
  return error;
}

std::vector<std::size_t> faces_at(const IndexedMesh& mesh, Index v) {
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (std::count(mesh.faces[f].begin(), mesh.faces[f].end(), v) > 0) faces.push_back(f);
  }
  return faces;
}

/// A mesh and its quadrics.
struct QuadricsOf {
  explicit QuadricsOf(const IndexedMesh& mesh, double farthest = 1e6)
      : frame(Frame::of_points(mesh.positions)), attributes(scaled_attributes(mesh, frame, {}, 1)) {
    attributes.farthest = farthest;
    for (const Vec3& p : mesh.positions) positions.push_back(frame.to_frame(p));
    quadrics = {InputAttributes(mesh, frame, attributes).all(1), positions.size()};
  }

  PairAttributes of(Index a, Index b) const { return quadrics.of({0, a, b}, true, positions[b] - positions[a]); }
  double error(Index a, Index b, const Vec3& x) const { return of(a, b).quadric(x - positions[a]); }
  void merge(Index a, Index b, const Vec3& x) {
    Change change{};
    change.pair = {0, a, b};
    change.survivor = a;
    change.removed = b;
    change.before = {positions[a], positions[b]};
    change.position = x;
    quadrics.merge(change, true);
    positions[a] = x;
  }

  Frame frame;
  ScaledAttributes attributes;
  std::vector<Vec3> positions;  ///< in the frame
  AttributeQuadrics quadrics;
};

TEST(AttributeQuadrics, EqualTheVarianceOfTheFacesFunctionsWhileVerticesMerge) {
  std::mt19937 random(1);
  const IndexedMesh mesh = wavy_sheet(6, random);
  QuadricsOf setup(mesh);
  ASSERT_EQ(setup.attributes.n_components, 2U);
  std::vector<std::vector<std::size_t>> faces(mesh.positions.size());
  for (Index v = 0; v < faces.size(); ++v) faces[v] = faces_at(mesh, v);
  std::vector<Index> live = iota(mesh.positions.size());
  while (live.size() > 2) {
    std::shuffle(live.begin(), live.end(), random);
    const Index a = live[0];
    const Index b = live[1];
    const Vec3 x = setup.frame.to_frame(mesh.positions[a] + Vec3(0.3, -0.2, 0.1));
    std::vector<std::size_t> both = faces[a];
    both.insert(both.end(), faces[b].begin(), faces[b].end());
    const double expected = brute_error(mesh, setup.frame, setup.attributes, both, x);
    ASSERT_NEAR(setup.error(a, b, x), expected, 1e-6 * expected + 1e-15);
    setup.merge(a, b, x);
    faces[a] = both;
    live.erase(live.begin() + 1);
  }
}

TEST(AttributeQuadrics, CostNothingWhereATextureIsLinearOnAPlane) {
  std::mt19937 random(2);
  IndexedMesh mesh = wavy_sheet(4, random);
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v].z() = 0;
    mesh.attributes[0].value(v)[0] = 0.3 * mesh.positions[v].x() + 7;
    mesh.attributes[0].value(v)[1] = 0.3 * mesh.positions[v].y() - 7;
  }
  QuadricsOf setup(mesh);
  for (const Index v : {6U, 7U, 12U}) {
    EXPECT_NEAR(setup.error(v, v + 1, Vec3(0.1, 0.2, 0)), 0, 1e-15);
  }
}

/// Two sheets with a common line, each a chart far from the other in the texture.
IndexedMesh two_charts(std::mt19937& random) {
  IndexedMesh mesh = wavy_sheet(4, random);
  make_wedge_table(mesh);
  std::vector<Index> kept = iota(n_wedges(mesh));
  std::vector<Index> copy_of(kept.size(), invalid_index);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const bool is_right = f % 8 >= 4;
    for (std::size_t k = 0; k < 3 && is_right; ++k) {
      const Index v = mesh.faces[f][k];
      if (v % 5 != 2) continue;
      if (copy_of[v] == invalid_index) {
        copy_of[v] = static_cast<Index>(kept.size());
        kept.push_back(v);
      }
      mesh.wedges[3 * f + k] = copy_of[v];
    }
  }
  gather_wedges(mesh, kept);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3 && f % 8 >= 4; ++k) {
      double& u = mesh.attributes[0].value(mesh.wedge(f, k))[0];
      if (u < 5) u += 10;
    }
  }
  return mesh;
}

TEST(AttributeQuadrics, KeepTheChartsOfASeamApart) {
  std::mt19937 random(3);
  const IndexedMesh mesh = two_charts(random);
  QuadricsOf setup(mesh);
  const Index a = 7;  // on the seam, as is b
  const Index b = 12;
  const Vec3 x = setup.frame.to_frame(mesh.positions[a]);
  double expected = 0;
  for (const bool is_right : {false, true}) {
    std::vector<std::size_t> faces;
    for (const Index v : {a, b}) {
      for (const std::size_t f : faces_at(mesh, v)) {
        if ((f % 8 >= 4) == is_right) faces.push_back(f);
      }
    }
    expected += brute_error(mesh, setup.frame, setup.attributes, faces, x);
  }
  // Single precision holds values of 10 to 6e-7. They vary by 0.02, so a square is right to 6e-5 of itself.
  EXPECT_NEAR(setup.error(a, b, x), expected, 1e-4 * expected);
}

TEST(AttributeQuadrics, AreBoundedByTheAreaTheyCover) {
  std::mt19937 random(4);
  const IndexedMesh mesh = wavy_sheet(6, random);
  const QuadricsOf setup(mesh, 1e-4);
  double area = 0;
  for (const Index v : {24U, 25U}) {
    for (const std::size_t f : faces_at(mesh, v)) {
      const auto corner = [&](std::size_t k) { return setup.frame.to_frame(mesh.positions[mesh.faces[f][k]]); };
      area += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    }
  }
  EXPECT_NEAR(setup.of(24, 25).most, 1e-8 * area, 1e-7 * 1e-8 * area);
}

/// Of the vertices of a flat square whose texture bends in one half, the share that lies there once most are gone.
double share_in_half_that_bends(bool is_right) {
  std::mt19937 random(5);
  IndexedMesh mesh = wavy_sheet(24, random);
  const auto bends_at = [&](const Vec3& p) { return is_right ? p.x() > 12 : p.x() < 12; };
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    Vec3& p = mesh.positions[v];
    p.z() = 0;
    mesh.attributes[0].value(v)[0] = 0.05 * (p.x() + (bends_at(p) ? std::sin(p.x()) : 0));
    mesh.attributes[0].value(v)[1] = 0.05 * p.y();
  }
  DecimateOptions options;
  options.attribute_weights.texcoord = 1;
  const Decimation out = decimate(mesh, DecimateTarget::faces(200), options);
  const auto n = std::count_if(out.mesh.positions.begin(), out.mesh.positions.end(), bends_at);
  return static_cast<double>(n) / static_cast<double>(out.mesh.positions.size());
}

TEST(AttributeWeights, PutVerticesWhereATextureBends) {
  EXPECT_GT(share_in_half_that_bends(false), 0.6);
  EXPECT_GT(share_in_half_that_bends(true), 0.6);
}

/// What the first number of a mesh' attributes counts as, in model units.
double first_length(const IndexedMesh& mesh) {
  const Frame frame = Frame::of_points(mesh.positions);
  return scaled_attributes(mesh, frame, {}, 1).values.at(0) / frame.scale;
}

TEST(AttributeWeights, DontDependOnPartsThatLieFarOff) {
  std::mt19937 random(7);
  IndexedMesh mesh = wavy_sheet(8, random);
  mesh.attributes.clear();
  mesh.normals.assign(mesh.positions.size(), {1, 0, 0});
  const double length = first_length(mesh);
  EXPECT_GT(length, 0);
  const auto v = static_cast<Index>(mesh.positions.size());
  for (const double x : {0.0, 0.01, 0.02}) mesh.positions.emplace_back(1e5 + x, x * x, 0);
  mesh.faces.push_back({v, v + 1, v + 2});
  mesh.normals.resize(mesh.positions.size(), {1, 0, 0});
  EXPECT_NEAR(first_length(mesh), length, 1e-4 * length);
}

TEST(AttributeWeights, AreRefusedWhereNegative) {
  std::mt19937 random(6);
  DecimateOptions options;
  options.attribute_weights.normal = -1;
  EXPECT_THROW(decimate(wavy_sheet(3, random), DecimateTarget::faces(4), options), std::invalid_argument);
}

}  // namespace
}  // namespace whittle
