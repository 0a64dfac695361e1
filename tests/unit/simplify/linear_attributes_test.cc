// Attributes that are linear in the position stay so.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/wedges.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

double linear(const Vec3& p, double x, double y, double z, double constant) {
  return x * p.x() + y * p.y() + z * p.z() + constant;
}

/// A grid of unit size, flat on one side and wavy on the other, with linear texture coordinates, colours, a number, a
/// step, and weights of two joints. With a seam, texture coordinates have an offset on one side of a line.
IndexedMesh linear_sheet(double height, double offset, bool has_seam) {
  constexpr int n = 30;
  IndexedMesh mesh = grid(n, n);
  for (Vec3& p : mesh.positions) {
    p /= n;
    p.z() = height * std::max(0.0, p.x() - 0.4) * (std::sin(9 * p.x() + 5 * p.y()) + 0.4 * std::sin(31 * p.y()));
  }
  Attribute texcoord{"texcoord", AttributeKind::texcoord, 2, {}};
  Attribute number{"number", AttributeKind::scalar, 1, {}};
  Attribute step{"step", AttributeKind::scalar, 1, {}};
  Attribute joints{"joints", AttributeKind::joint_weights, 4, {}};
  const auto add = [&](const Vec3& p, bool is_beyond) {
    const double shift = is_beyond ? 3 : 0;
    texcoord.values.push_back(linear(p, 1, 0.2, 0.1, shift));
    texcoord.values.push_back(linear(p, -0.3, 1, 0, shift));
    number.values.push_back(linear(p, 20, -30, 7, 100));
    step.values.push_back(p.x() + 0.3 * p.y() < 0.5 ? 0 : 1);
    const double weight = linear(p, 0.4, 0.3, 0, 0.1);
    joints.values.insert(joints.values.end(), {0, 1, weight, 1 - weight});
    mesh.colors.push_back(
        {static_cast<float>(linear(p, 0.5, 0, 0, 0.2)), static_cast<float>(linear(p, 0, 0.5, 0, 0.2)), 0.25F, 1});
  };
  if (has_seam) {
    for (const Triangle& face : mesh.faces) {
      const double middle =
          (mesh.positions[face[0]].y() + mesh.positions[face[1]].y() + mesh.positions[face[2]].y()) / 3;
      for (const Index v : face) {
        mesh.wedges.push_back(static_cast<Index>(mesh.wedges.size()));
        add(mesh.positions[v], middle > 0.5);
      }
    }
  } else {
    for (const Vec3& p : mesh.positions) add(p, false);
  }
  mesh.attributes = {texcoord, number, step, joints};
  join_equal_wedges(mesh);
  for (Vec3& p : mesh.positions) p.x() += offset;
  return mesh;
}

/// \param where text for failures
void expect_linear(const IndexedMesh& mesh, double offset, const std::string& where) {
  // Each attribute, over its range.
  enum { u, v, number, color, joint, n_parts };
  constexpr std::array names{"u", "v", "number", "color", "joint"};
  std::array<double, n_parts> worst{};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index w = mesh.wedge(f, k);
      const Vec3 p = mesh.positions[mesh.faces[f][k]] - Vec3(offset, 0, 0);
      const auto apart = [&](std::size_t part, double value, double expected) {
        worst[part] = std::max(worst[part], std::abs(value - expected));
      };
      const auto texcoord = mesh.attributes[0].value(w);
      const double shift = texcoord[0] > 2 ? 3 : 0;
      apart(u, texcoord[0], linear(p, 1, 0.2, 0.1, shift));
      apart(v, texcoord[1], linear(p, -0.3, 1, 0, shift));
      apart(number, mesh.attributes[1].value(w)[0] / 30, linear(p, 20, -30, 7, 100) / 30);
      apart(color, mesh.colors[w][0], linear(p, 0.5, 0, 0, 0.2));
      apart(color, mesh.colors[w][1], linear(p, 0, 0.5, 0, 0.2));
      const auto joints = mesh.attributes[3].value(w);
      apart(joint, joints[joints[0] == 0 ? 2 : 3], linear(p, 0.4, 0.3, 0, 0.1));
      const double step = mesh.attributes[2].value(w)[0];
      EXPECT_TRUE(step >= 0 && step <= 1) << where << ": a step from 0 to 1 has become " << step;
    }
  }
  for (std::size_t part = 0; part < n_parts; ++part) EXPECT_LT(worst[part], 1e-5) << names[part] << ", " << where;
}

TEST(SlowLinearAttributes, StayLinearAtEveryEffortCostAndPlacement) {
  for (const double height : {0.0, 0.3}) {
    for (const bool has_seam : {false, true}) {
      for (const double offset : {0.0, 1000.0}) {
        const IndexedMesh mesh = linear_sheet(height, offset, has_seam);
        const std::string where = "height " + std::to_string(height) + ", seam " + std::to_string(int{has_seam}) +
                                  ", offset " + std::to_string(offset);
        for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
          const auto to_tenth = [&](const SimplifyOptions& options) {
            return simplify(mesh, DecimateTarget::faces(mesh.faces.size() / 10), effort, options).mesh;
          };
          const std::string at = where + ", effort " + std::to_string(static_cast<int>(effort));
          expect_linear(to_tenth({}), offset, at);
          for (const CostTraits& traits : all_cost_traits) {
            const Cost cost = traits.cost;
            SimplifyOptions options;
            options.decimate.cost = cost;
            expect_linear(to_tenth(options), offset, at + ", cost " + std::to_string(static_cast<int>(cost)));
          }
          SimplifyOptions endpoint;
          endpoint.decimate.quadric.placement = Placement::endpoint;
          expect_linear(to_tenth(endpoint), offset, at + ", endpoint");
        }
      }
    }
  }
}

/// A random linear function of positions in the unit cube, with values in [0.1, 0.9].
struct RandomFunction {
  Vec3 slope;
  double constant;

  explicit RandomFunction(Random& random) : slope(random.uniform_vector(-1, 1)) {
    slope *= 0.8 / slope.cwiseAbs().sum();
    constant = 0.1 - slope.cwiseMin(0).sum();
  }
  double operator()(const Vec3& p) const { return slope.dot(p) + constant; }
};

/// The functions of a chart: a tile of a texture that repeats, a colour, a number, the weight of one of two joints.
struct RandomChart {
  std::array<double, 2> tile;
  RandomFunction color, number, weight;

  explicit RandomChart(Random& random)
      : tile{std::floor(random.uniform(-2, 2)), std::floor(random.uniform(-2, 2))},
        color(random),
        number(random),
        weight(random) {}
};

/// A mesh with random linear attributes: one chart, or four that share an image, two by two in x and y.
class RandomSheet {
 public:
  RandomSheet(IndexedMesh shape, bool has_seams, Random& random)
      : mesh_(std::move(shape)), texcoord_{RandomFunction(random), RandomFunction(random)} {
    Vec3 low = mesh_.positions.front();
    Vec3 high = low;
    for (const Vec3& p : mesh_.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
    for (Vec3& p : mesh_.positions) p = (p - low) / (high - low).maxCoeff();
    const std::size_t n_charts = has_seams ? 4 : 1;
    for (std::size_t i = 0; i < n_charts; ++i) charts_.emplace_back(random);
    const double shear = random.uniform(-0.5, 0.5);
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const auto& [a, b, c] = mesh_.faces[f];
      const Vec3 center = (mesh_.positions[a] + mesh_.positions[b] + mesh_.positions[c]) / 3;
      const bool is_right = center.x() + shear * center.y() > 0.5 * (1 + shear);
      chart_of_.push_back(has_seams ? 2 * std::size_t{is_right} + std::size_t{center.y() > 0.5} : 0);
    }
    add_attributes();
  }

  const IndexedMesh& mesh() const { return mesh_; }

  /// The largest error of an attribute of a result, all of which range over about 1.
  double worst_of(const Simplification& result) const {
    double worst = 0;
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
      const RandomChart& chart = charts_[chart_of_[result.face_origins[f]]];
      for (std::size_t k = 0; k < 3; ++k) {
        const Index w = result.mesh.wedge(f, k);
        const Vec3& p = result.mesh.positions[result.mesh.faces[f][k]];
        const auto apart = [&](double value, double expected) { worst = std::max(worst, std::abs(value - expected)); };
        for (std::size_t i = 0; i < 2; ++i) apart(result.mesh.attributes[0].value(w)[i], texcoord(chart, i, p));
        apart(result.mesh.colors[w][0], std::clamp(chart.color(p), 0.0, 1.0));
        apart(result.mesh.attributes[1].value(w)[0], chart.number(p));
        const auto joints = result.mesh.attributes[2].value(w);
        apart(joints[joints[0] == 3 ? 2 : 3], std::clamp(chart.weight(p), 0.0, 1.0));
        apart(joints[2] + joints[3], 1);
      }
    }
    return worst;
  }

 private:
  double texcoord(const RandomChart& chart, std::size_t i, const Vec3& p) const {
    return 4 * texcoord_[i](p) - chart.tile[i];
  }
  void add_attributes() {
    mesh_.attributes = {{"texcoord", AttributeKind::texcoord, 2},
                        {"number", AttributeKind::scalar, 1},
                        {"joints", AttributeKind::joint_weights, 4}};
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const RandomChart& chart = charts_[chart_of_[f]];
      for (const Index v : mesh_.faces[f]) {
        const Vec3& p = mesh_.positions[v];
        mesh_.wedges.push_back(static_cast<Index>(mesh_.wedges.size()));
        for (std::size_t i = 0; i < 2; ++i) mesh_.attributes[0].values.push_back(texcoord(chart, i, p));
        mesh_.attributes[1].values.push_back(chart.number(p));
        const double weight = chart.weight(p);
        mesh_.attributes[2].values.insert(mesh_.attributes[2].values.end(), {3, 5, weight, 1 - weight});
        mesh_.colors.push_back({static_cast<float>(chart.color(p)), 0.5F, 0.5F, 1});
      }
    }
    join_equal_wedges(mesh_);
  }

  IndexedMesh mesh_;
  std::array<RandomFunction, 2> texcoord_;
  std::vector<RandomChart> charts_;
  std::vector<std::size_t> chart_of_;  ///< of each face
};

/// Also where charts lie over one another on the image, and a seam's straight sides cut off its bays.
TEST(LinearAttributes, StayLinearForRandomFunctionsAndCharts) {
  Random random(48);
  for (const bool has_seams : {false, true}) {
    const std::vector<IndexedMesh> shapes{grid(40, 40), terrain(40, 1), blob(4, 7), torus(40, 24)};
    for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
      const IndexedMesh& mesh = shapes[shape];
      const RandomSheet sheet(mesh, has_seams, random);
      for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
        const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 10);
        EXPECT_LT(sheet.worst_of(simplify(sheet.mesh(), target, effort, {})), 1e-5)
            << "shape " << shape << ", seams " << has_seams << ", effort " << static_cast<int>(effort);
      }
    }
  }
}

/// A file rounds to few digits: the error must be that of rounding, wherever vertices go.
TEST(LinearAttributes, AreNoFartherThanTheRoundingOfTheirDigits) {
  IndexedMesh mesh = linear_sheet(0.3, 0, false);
  mesh.attributes.resize(1);
  mesh.colors.clear();
  const std::vector<double> exact = mesh.attributes[0].values;
  for (const double digits : {1e3, 1e4}) {
    for (std::size_t i = 0; i < exact.size(); ++i) {
      mesh.attributes[0].values[i] = std::round(exact[i] * digits) / digits;
    }
    for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
      const IndexedMesh result = simplify(mesh, DecimateTarget::faces(mesh.faces.size() / 10), effort, {}).mesh;
      for (Index v = 0; v < result.positions.size(); ++v) {
        const double expected = linear(result.positions[v], 1, 0.2, 0.1, 0);
        EXPECT_NEAR(result.attributes[0].value(v)[0], expected, 0.51 / digits) << digits << " " << int(effort);
      }
    }
  }
}

}  // namespace
}  // namespace whittle::test
