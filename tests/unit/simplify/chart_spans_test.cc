// On a texture, no face of a result lies over a chart that isn't its own.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "support/shapes/shapes.hh"
#include "whittle/core/wedges.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

constexpr int n_sheet_squares = 48;
constexpr double disc_middle = n_sheet_squares / 2.0;
constexpr double disc_radius = 0.6 * disc_middle;

bool is_in_disc(double x, double y) { return std::hypot(x - disc_middle, y - disc_middle) < disc_radius; }

/// Whether a face is in the chart of the disc. \param f of `disc_in_sheet`
bool is_of_disc(const IndexedMesh& mesh, std::size_t f) {
  Vec3 centroid = Vec3::Zero();
  for (const Index v : mesh.faces[f]) centroid += mesh.positions[v] / 3;
  return is_in_disc(centroid.x(), centroid.y());
}

/// A bent sheet. A disc in it is a chart of its own, which lies in the hole of the other on the image, turned by a
/// right angle. So where a side of a face cuts off an arc of the seam, the face lies over the other chart.
IndexedMesh disc_in_sheet() {
  IndexedMesh mesh = grid(n_sheet_squares, n_sheet_squares);
  make_wedge_table(mesh);
  Attribute texcoord{"texcoord", AttributeKind::texcoord, 2, {}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const bool is_turned = is_of_disc(mesh, f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[mesh.faces[f][k]];
      mesh.wedges[3 * f + k] = static_cast<Index>(3 * f + k);
      texcoord.values.push_back(is_turned ? disc_middle - (p.y() - disc_middle) : p.x());
      texcoord.values.push_back(is_turned ? p.x() : p.y());
    }
  }
  mesh.attributes.push_back(texcoord);
  for (Vec3& p : mesh.positions) p.z() = 3 * std::sin(0.13 * p.x()) * std::cos(0.11 * p.y());
  join_equal_wedges(mesh);
  return mesh;
}

/// The points of a face that lie over the other chart, more than a hundredth of its size from its sides.
int n_over_other(const IndexedMesh& mesh, std::size_t f, bool is_of_disc) {
  std::array<Eigen::Vector2d, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = Eigen::Vector2d(&mesh.attributes[0].values[2 * mesh.wedge(f, k)]);
  }
  constexpr double seam = 1.5;  // its steps, half a square and more
  int n = 0;
  for (int i = 1; i < 40; ++i) {
    for (int k = 1; i + k < 40; ++k) {
      const Eigen::Vector2d p = (i * corners[0] + k * corners[1] + (40 - i - k) * corners[2]) / 40;
      const double beyond = std::hypot(p.x() - disc_middle, p.y() - disc_middle) - disc_radius;
      n += (is_of_disc ? beyond : -beyond) > seam ? 1 : 0;
    }
  }
  return n;
}

int n_over_others(const IndexedMesh& input, const Decimation& result) {
  int n = 0;
  for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
    n += n_over_other(result.mesh, f, is_of_disc(input, result.face_origins[f]));
  }
  return n;
}

class ChartSpans : public testing::TestWithParam<Effort> {};

TEST_P(ChartSpans, AreNone) {
  const IndexedMesh mesh = disc_in_sheet();
  for (const std::size_t n_faces : {400U, 120U, 40U}) {
    for (const Seams seams : {Seams::weighted, Seams::keep}) {
      if (GetParam() == Effort::fast && seams == Seams::keep) continue;  // such few vertices are left to move
      SimplifyOptions options;
      options.decimate.seams = seams;
      const Simplification result = simplify(mesh, DecimateTarget::faces(n_faces), GetParam(), options);
      EXPECT_EQ(n_over_others(mesh, result), 0) << n_faces << " faces, seams " << int(seams == Seams::keep);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Efforts, ChartSpans, testing::Values(Effort::fast, Effort::normal, Effort::best));

}  // namespace
}  // namespace whittle::test
