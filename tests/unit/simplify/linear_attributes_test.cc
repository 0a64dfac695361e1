// Attributes that are linear in the position stay so.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

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
  // Weights of joints have local functions, which know no slope across a single face.
  for (std::size_t part = 0; part < n_parts; ++part) {
    EXPECT_LT(worst[part], part == joint ? 2e-3 : 1e-5) << names[part] << ", " << where;
  }
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

}  // namespace
}  // namespace whittle::test
