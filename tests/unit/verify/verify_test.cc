// Proofs by hand, right and wrong ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "certificate.hh"

namespace whittle::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using verify::Verification;

const Vec3 up(0, 0, 1);

IndexedMesh mesh_of(std::vector<Vec3> positions, std::vector<Triangle> faces) {
  IndexedMesh mesh;
  mesh.positions = std::move(positions);
  mesh.faces = std::move(faces);
  return mesh;
}

IndexedMesh moved(IndexedMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

IndexedMesh triangle() { return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}); }

/// The triangle, halved from the middle of its longest edge.
IndexedMesh halves() { return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 3}, {0, 3, 2}}); }

/// A square around the triangle. Its four faces meet over the triangle.
IndexedMesh square() {
  return mesh_of({{-1, -1, 0}, {2, -1, 0}, {2, 2, 0}, {-1, 2, 0}, {0.3, 0.3, 0}},
                 {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

/// \return why the first section's proof fails; empty if another one's does, or none
std::string why_not_near(const IndexedMesh& in, const IndexedMesh& out, double max_error, const Steps& steps) {
  const Verification result = verified(in, out, Certificate{.max_error = max_error}.prove(0, steps).prove(1, Steps()));
  EXPECT_FALSE(result.holds);
  return result.why_not.starts_with("IN, face 0: ") ? result.why_not.substr(12) : "";
}

const IndexedMesh low = triangle();
const IndexedMesh high = moved(triangle(), 0.1 * up);

Certificate one_face_each(double max_error) {
  return Certificate{.max_error = max_error}.prove(0, Steps().face(0)).prove(1, Steps().face(0));
}

TEST(Verify, FollowsAProofByOneFace) {
  const Verification result = verified(low, high, one_face_each(0.1 + 1e-12));
  EXPECT_TRUE(result.holds) << result.why_not;
  EXPECT_EQ(result.why_not, "");
  EXPECT_EQ(result.max_error, 0.1 + 1e-12);
  EXPECT_EQ(result.max_error_borders, infinity);
  EXPECT_EQ(result.tolerances.size(), 0U);
}

TEST(Verify, RefusesALimitThatIsALittleTooSmall) {
  for (const double less : {1e-12, 1e-6, 0.05}) {
    const Verification result = verified(low, high, one_face_each(0.1 - less));
    EXPECT_FALSE(result.holds);
    EXPECT_FALSE(result.is_malformed);
    EXPECT_EQ(result.why_not, "IN, face 0: a corner is not within the distance of face 0");
    EXPECT_EQ(result.max_error, 0);
  }
  // Only OUT's vertex 1 is too far.
  IndexedMesh out = low;
  out.positions[1].x() = 1.2;
  const Verification result = verified(low, out, one_face_each(0.15));
  EXPECT_THAT(result.why_not, StartsWith("OUT, face 0: a corner"));
}

TEST(Verify, MeasuresTheDistanceToInsideSidesAndCorners) {
  const IndexedMesh face = mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  const auto expect_distance = [&](const Vec3& p, double distance) {
    const IndexedMesh point = mesh_of({p}, {{0, 0, 0}});
    EXPECT_EQ(why_not_near(point, face, distance + 1e-12, Steps().face(0)), "") << p.transpose();
    EXPECT_NE(why_not_near(point, face, distance - 1e-12, Steps().face(0)), "") << p.transpose();
  };
  expect_distance({1, 1, 0.5}, 0.5);
  expect_distance({1, -0.5, 0}, 0.5);
  expect_distance({-3, 1, 4}, 5);
  expect_distance({3, 3, 0}, std::sqrt(2.0));
  expect_distance({-3, -4, 0}, 5);
  expect_distance({7, -4, 0}, 5);
  expect_distance({-4, 7, 0}, 5);
}

/// A thin face's nearest point is found as exactly as that of any face, wherever its corners are in the list.
TEST(Verify, MeasuresTheDistanceToThinFaces) {
  for (const double width : {1e-3, 1e-7, 1e-9, 1e-12, 1e-15, 0.0}) {
    for (const double across : {0.0, 0.3, 1.0}) {
      std::vector<Vec3> corners{{0, 0, 0}, {across, 1, 0}, {0.5 + 0.5 * across, 0.5, width}};
      if (across == 0.3) corners[2] = {0.001, 0, width};
      for (int turn = 0; turn < 3; ++turn) {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        const IndexedMesh face = mesh_of(corners, {{0, 1, 2}});
        const Vec3 over = 0.3 * corners[0] + 0.4 * corners[1] + 0.3 * corners[2];
        const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        for (const double distance : {0.0, 1e-6, 0.1, 1.0}) {
          const Vec3 way = width > 0 ? normal.normalized() : Vec3(corners[1] - corners[0]).unitOrthogonal();
          const IndexedMesh point = mesh_of({over + distance * way}, {{0, 0, 0}});
          EXPECT_EQ(why_not_near(point, face, distance + 5e-14, Steps().face(0)), "")
              << width << ' ' << across << ' ' << turn << ' ' << distance;
        }
      }
    }
  }
}

TEST(Verify, FollowsHalvings) {
  const auto certificate = [](const Steps& steps) {
    return Certificate{.max_error = 0.01}.prove(0, steps).prove(1, Steps().face(0).face(0));
  };
  EXPECT_FALSE(verified(low, halves(), certificate(Steps().face(0))).holds);
  const Verification result = verified(low, halves(), certificate(Steps().halve(1).face(0).face(1)));
  EXPECT_TRUE(result.holds) << result.why_not;
  EXPECT_FALSE(verified(low, halves(), certificate(Steps().halve(1).face(1).face(0))).holds);
  EXPECT_FALSE(verified(low, halves(), certificate(Steps().halve(0).face(0).face(1))).holds);
  EXPECT_TRUE(verified(low, halves(),
                       certificate(Steps().halve(1).halve(2).face(0).face(0).halve(0).halve(2).face(1).face(1).face(1)))
                  .holds);
}

TEST(Verify, HalvesEachEdge) {
  for (Index first = 0; first < 3; ++first) {
    const IndexedMesh in = mesh_of(low.positions, {{first, (first + 1) % 3, (first + 2) % 3}});
    const unsigned edge = (4 - first) % 3;  // from corner 1 of the mesh to corner 2
    const Certificate certificate = Certificate{.max_error = 0.01}
                                        .prove(0, Steps().halve(edge).halve(edge).face(0).face(0).face(1))
                                        .prove(1, Steps().face(0).face(0));
    // The half of (from, m, opposite) comes first: at corner 1, as face 0 is.
    EXPECT_FALSE(verified(in, halves(), one_face_each(0.01).prove(1, Steps())).holds);
    EXPECT_TRUE(verified(in, halves(), certificate).holds) << verified(in, halves(), certificate).why_not;
  }
}

TEST(Verify, FollowsPatches) {
  for (const Index first : {0U, 1U, 2U, 3U}) {
    EXPECT_EQ(why_not_near(low, moved(square(), 0.1 * up), 0.1 + 1e-12, Steps().patch(first)), "");
    EXPECT_EQ(why_not_near(low, moved(square(), -0.1 * up), 0.1 + 1e-12, Steps().patch(first)), "");
    EXPECT_EQ(why_not_near(low, moved(square(), 0.1 * up), 0.1 - 1e-12, Steps().patch(first)),
              "a face of its patch is not within the distance; the patch starts from face " + std::to_string(first));
  }
}

TEST(Verify, SeesPatchesFromAnySide) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (const double scale : {1.0, 1e-3, 1e3, 1e-200, 1e140}) {
    for (const double shift : {0.0, 1e2}) {
      IndexedMesh in = low;
      IndexedMesh out = moved(square(), 0.1 * up);
      for (IndexedMesh* mesh : {&in, &out}) {
        for (Vec3& p : mesh->positions) p = scale * (turn * p + shift * Vec3(1, -2, 3));
      }
      EXPECT_EQ(why_not_near(in, out, scale * (0.1 + 1e-11), Steps().patch(2)), "") << scale << ' ' << shift;
      EXPECT_NE(why_not_near(in, out, scale * (0.1 - 1e-11), Steps().patch(2)), "") << scale << ' ' << shift;
    }
  }
}

/// Only the part over the triangle counts.
TEST(Verify, ClipsTheFacesOfAPatch) {
  IndexedMesh out = square();
  for (std::size_t v = 0; v < 4; ++v) out.positions[v].z() = out.positions[v].x() + 2 * out.positions[v].y();
  out.positions[4].z() = 0.9;
  // Over the triangle's corner (0, 1), the plane z = x + 2 y is at 2.
  EXPECT_EQ(why_not_near(low, out, 2 + 1e-12, Steps().patch(0)), "");
  EXPECT_THAT(why_not_near(low, out, 2 - 1e-12, Steps().patch(0)), StartsWith("a face of its patch"));
}

constexpr char open_edge[] = "its patch has an edge over it without just two faces; the patch starts from face 0";
constexpr char uncovered[] = "its patch does not cover it; the patch starts from face 0";

TEST(Verify, RefusesAPatchWithAHole) {
  IndexedMesh out = square();
  for (std::size_t hole = 1; hole < 4; ++hole) {
    out = square();
    out.faces.erase(out.faces.begin() + static_cast<std::ptrdiff_t>(hole));
    EXPECT_EQ(why_not_near(low, out, 0.1, Steps().patch(0)), open_edge);
  }
  out = square();  // a hole that no vertex of the triangle sees
  out.positions.insert(out.positions.end(), {{0.3, 0.31, 0}, {0.31, 0.3, 0}});
  out.faces = {{0, 1, 6}, {0, 6, 4}, {1, 2, 5}, {1, 5, 6}, {2, 3, 5}, {3, 0, 4}, {3, 4, 5}};
  EXPECT_EQ(why_not_near(low, out, 0.1, Steps().patch(0)), open_edge);
  out.faces.push_back({4, 6, 5});
  EXPECT_EQ(why_not_near(low, out, 0.1, Steps().patch(0)), "");
}

TEST(Verify, RefusesAPatchThatEndsOverTheTriangle) {
  EXPECT_EQ(why_not_near(low, halves(), 0.1, Steps().patch(0)), "");
  IndexedMesh out = halves();
  out.positions[0] = {1e-9, 1e-9, 0};
  EXPECT_EQ(why_not_near(low, out, 0.1, Steps().patch(0)), open_edge);
}

TEST(Verify, RefusesAPatchAtAnEdgeOfThreeFaces) {
  IndexedMesh out = square();
  out.positions.push_back({0.3, 0.3, 0.05});
  for (const Triangle& fin : {Triangle{1, 4, 5}, Triangle{4, 1, 5}, Triangle{1, 0, 4}}) {
    out.faces.resize(4);
    out.faces.push_back(fin);
    EXPECT_EQ(why_not_near(low, out, 0.1, Steps().patch(0)), open_edge);
  }
  out.faces.back() = {4, 4, 1};  // without area: it has no edges
  EXPECT_EQ(why_not_near(low, out, 0.1, Steps().patch(0)), "");
  EXPECT_NE(why_not_near(low, out, 0.1, Steps().patch(4)), "");
}

/// Two layers that are joined outside of the triangle: each point has two faces over it, or none.
TEST(Verify, RefusesAPatchThatFolds) {
  const IndexedMesh tent = mesh_of({{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}}, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_EQ(why_not_near(low, tent, 0.1, Steps().patch(0)), "");  // its edges are apart
  // The fold is over the triangle.
  IndexedMesh out = mesh_of({{-1, -1, 0}, {3, -1, 0}, {0.3, 0.5, 0}, {0.3, -9, 0.01}, {-9, -1, 0}, {9, -1, 0}},
                            {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 5}});
  EXPECT_NE(why_not_near(low, out, 20, Steps().patch(0)), "");
  // A roof whose both sides go down at the same side of the ridge.
  out = mesh_of({{-9, 0.2, 0}, {9, 0.2, 0}, {0, -99, 0}, {0.1, -99, 0.01}}, {{0, 1, 2}, {1, 0, 3}});
  EXPECT_EQ(why_not_near(low, out, 0.1, Steps().patch(0)), uncovered);
  out.positions[3].y() = 99;
  EXPECT_EQ(why_not_near(low, out, 0.1, Steps().patch(0)), "");
}

TEST(Verify, RefusesAPatchElsewhere) {
  EXPECT_EQ(why_not_near(low, moved(square(), {5, 0, 0}), 0.1, Steps().patch(0)), uncovered);
}

/// A needle that is far from a closed surface. Inexact sides must not let it pass.
TEST(Verify, RefusesPatchesForThinTriangles) {
  const IndexedMesh out = mesh_of({{0.6, -0.3, 0.3}, {0.6, 0.3, 0.3}, {0.6, 0, 0.6}, {0.1, 0, 0.4}},
                                  {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  for (double width = 1e-2; width > 1e-20; width /= 3) {
    std::vector<Vec3> corners{{0, 0, 0}, {0.5, 0, 0}, {0.5, width, 0}};
    for (int turn = 0; turn < 3; ++turn) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      for (const Index first : {0U, 1U, 2U, 3U}) {
        EXPECT_NE(why_not_near(mesh_of(corners, {{0, 1, 2}}), out, 0.01, Steps().patch(first)), "") << width;
        EXPECT_NE(why_not_near(mesh_of(corners, {{0, 2, 1}}), out, 0.01, Steps().patch(first)), "") << width;
      }
    }
  }
  EXPECT_NE(why_not_near(mesh_of({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}), square(), 1, Steps().patch(0)), "");
}

TEST(Verify, RefusesTooManyHalvings) {
  const auto halved = [](int n) {
    Steps steps;
    for (int i = 0; i < n; ++i) steps.halve(0);
    for (int i = 0; i <= n; ++i) steps.face(0);
    return one_face_each(0.2).prove(0, steps);
  };
  for (const int n : {1, 96}) {
    Certificate certificate = halved(n);
    certificate.sections[0].erase(certificate.sections[0].begin());
    EXPECT_TRUE(verified(low, high, certificate).holds) << verified(low, high, certificate).why_not;
  }
  for (const int n : {97, 1000000}) {
    Certificate certificate = halved(n);
    certificate.sections[0].erase(certificate.sections[0].begin());
    EXPECT_EQ(verified(low, high, certificate).why_not, "IN, face 0: it is halved too often");
  }
}

/// The border of a square, as its four faces have it.
Steps along_border(Index first) {
  Steps steps;
  for (Index edge = 0; edge < 4; ++edge) steps.face((edge + first) % 4);
  return steps;
}

Certificate square_certificate(double max_error_borders) {
  return Certificate{.max_error = 1, .max_error_borders = max_error_borders}
      .prove(0, Steps().face(0).face(1).face(2).face(3))
      .prove(1, Steps().face(0).face(1).face(2).face(3));
}

TEST(Verify, FollowsProofsOfBorders) {
  const IndexedMesh out = moved(square(), 0.1 * up);
  Certificate certificate = square_certificate(0.1 + 1e-12);
  certificate.prove(2, along_border(0)).prove(3, along_border(0));
  const Verification result = verified(square(), out, certificate);
  EXPECT_TRUE(result.holds) << result.why_not;
  EXPECT_EQ(result.max_error_borders, 0.1 + 1e-12);

  certificate.max_error_borders = 0.1 - 1e-12;
  EXPECT_EQ(verified(square(), out, certificate).why_not,
            "IN, border edge 0: a corner is not within the distance of face 0");
  certificate = square_certificate(0.2);
  certificate.prove(2, along_border(0)).prove(3, along_border(1));
  EXPECT_THAT(verified(square(), out, certificate).why_not, StartsWith("OUT, border edge 0: "));
  certificate.sections[3] = {Steps().patch(0).face(1).face(2).face(3).bytes()};
  EXPECT_THAT(verified(square(), out, certificate).why_not, StartsWith("OUT, border edge 0: "));
}

TEST(Verify, TakesEdgesThatOccurOnceForTheBorder) {
  const IndexedMesh in = square();
  IndexedMesh out = square();
  out.faces.push_back({0, 0, 1});  // has no edges
  out.faces.push_back({2, 3, 4});  // closes what it doubles, and opens nothing but has edges of three faces
  Certificate certificate{.max_error = 1, .max_error_borders = 0.1};
  certificate.prove(0, Steps().face(0).face(1).face(2).face(3));
  certificate.prove(1, Steps().face(0).face(1).face(2).face(3).face(0).face(2));
  // OUT's border edges are 0-1, 1-2 and 3-0, with the numbers 0, 1 and 2.
  certificate.prove(2, Steps().face(0).face(1).face(1).face(2));
  certificate.prove(3, Steps().face(0).face(1).face(3));
  EXPECT_THAT(verified(in, out, certificate).why_not, StartsWith("IN, border edge 2: "));
  certificate.max_error_borders = 3.1;
  EXPECT_TRUE(verified(in, out, certificate).holds) << verified(in, out, certificate).why_not;
}

TEST(Verify, RefusesABorderWhereTheOtherMeshHasNone) {
  IndexedMesh closed = square();
  closed.faces.insert(closed.faces.end(), {{0, 2, 1}, {0, 3, 2}});
  Certificate certificate{.max_error = 9, .max_error_borders = 9};
  certificate.prove(0, Steps().face(0).face(1).face(2).face(3));
  certificate.prove(1, Steps().face(0).face(1).face(2).face(3).face(0).face(0));
  EXPECT_FALSE(verified(square(), closed, certificate).holds);
  certificate.prove(2, along_border(0));
  EXPECT_EQ(verified(square(), closed, certificate).why_not, "IN, border edge 0: a step names no face");
  certificate.max_error_borders = infinity;
  certificate.sections[2].clear();
  EXPECT_TRUE(verified(square(), closed, certificate).holds);
}

TEST(Verify, KeepsToTolerances) {
  Certificate certificate = one_face_each(1);
  certificate.tolerances = {0.3, 0.1 + 1e-12, infinity};
  const Verification result = verified(low, high, certificate);
  EXPECT_TRUE(result.holds) << result.why_not;
  EXPECT_EQ(result.tolerances.size(), 3U);
  certificate.tolerances[1] = 0.1 - 1e-12;
  EXPECT_THAT(verified(low, high, certificate).why_not, StartsWith("IN, face 0: "));
  certificate.tolerances[1] = 0.3;
  certificate.max_error = 0.1 - 1e-12;
  EXPECT_FALSE(verified(low, high, certificate).holds);
}

/// Points of OUT are within the tolerance of the face of IN that is named.
TEST(Verify, KeepsToTheTolerancesOfNamedFaces) {
  IndexedMesh in = triangle();
  in.positions.insert(in.positions.end(), low.positions.begin(), low.positions.end());
  in.faces.push_back({3, 4, 5});
  IndexedMesh out = in;
  for (std::size_t v = 0; v < 6; ++v) out.positions[v].z() = v < 3 ? 0.1 : 0.15;
  Certificate certificate{.max_error = 1, .tolerances = {0.2, 0.2, 0.2, 0.12, 0.2, 0.2}};
  certificate.prove(0, Steps().face(0).face(0)).prove(1, Steps().face(1).face(0));
  EXPECT_TRUE(verified(in, out, certificate).holds) << verified(in, out, certificate).why_not;
  certificate.sections[1] = {Steps().face(1).face(1).bytes()};
  EXPECT_EQ(verified(in, out, certificate).why_not, "OUT, face 1: a corner is not within the distance of face 1");
}

TEST(Verify, KeepsToTheToleranceOfEachFaceOfAPatch) {
  const IndexedMesh in = square();
  const IndexedMesh higher = moved(square(), 0.15 * up);
  IndexedMesh out = moved(square(), 0.1 * up);
  out.positions.insert(out.positions.end(), higher.positions.begin(), higher.positions.end());
  out.faces = {{0, 1, 2}, {0, 2, 3}, {5, 6, 7}};
  Certificate certificate{.max_error = 1, .tolerances = {0.2, 0.2, 0.2, 0.12, 0.2}};
  certificate.prove(0, Steps().patch(0).patch(0).patch(1).patch(1)).prove(1, Steps().patch(0).patch(2).patch(1));
  EXPECT_TRUE(verified(in, out, certificate).holds) << verified(in, out, certificate).why_not;
  out.faces.push_back({5, 7, 8});  // over faces 2 and 3, whose tolerance is less
  certificate.sections[1] = {Steps().patch(0).patch(2).patch(1).patch(2).bytes()};
  EXPECT_EQ(verified(in, out, certificate).why_not,
            "OUT, face 3: a face of its patch is not within the distance; the patch starts from face 2");
}

/// Chunks have 1,024 triangles. The result is the same for any number of threads: the first reason in the file.
TEST(Verify, ReportsTheFirstReasonForAnyNumberOfThreads) {
  constexpr std::size_t n_faces = 1024 * 9 + 7;
  const IndexedMesh in = mesh_of(low.positions, std::vector<Triangle>(n_faces, {0, 1, 2}));
  const auto certificate = [&](const std::vector<std::size_t>& wrong) {
    Certificate result{.max_error = 0.2};
    for (std::size_t begin = 0; begin < n_faces; begin += 1024) {
      Steps steps;
      for (std::size_t f = begin; f < std::min(begin + 1024, n_faces); ++f) {
        if (std::count(wrong.begin(), wrong.end(), f) != 0) {
          steps.patch(0);
        } else {
          steps.face(0);
        }
      }
      result.prove(0, steps);
    }
    return result.prove(1, Steps().face(static_cast<Index>(n_faces - 1)));
  };
  const IndexedMesh far = mesh_of({{0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 0.1}}, {{0, 1, 2}});
  IndexedMesh other = far;
  other.positions.push_back({9, 9, 9});
  for (const unsigned threads : {1U, 2U, 3U, 16U, 0U}) {
    EXPECT_TRUE(verified(in, far, certificate({}), threads).holds);
    // A patch of one face covers the triangle; moved a little, it doesn't.
    IndexedMesh shifted = far;
    shifted.positions[0] += Vec3(1e-6, 1e-6, 0);
    for (int repeat = 0; repeat < 5; ++repeat) {
      EXPECT_THAT(verified(in, shifted, certificate({9000, 3000, 3001, 5000, 1023 + 2048}), threads).why_not,
                  StartsWith("IN, face 3000: its patch has an edge"));
    }
  }
}

TEST(Verify, TakesMeshesWithoutFaces) {
  const IndexedMesh none;
  const IndexedMesh unused = mesh_of({{infinity, 0, 0}}, {});
  EXPECT_TRUE(verified(none, none, Certificate{.max_error = 1}).holds);
  EXPECT_TRUE(verified(unused, none, Certificate{.max_error = 1}).holds);
  EXPECT_FALSE(verified(low, none, Certificate{.max_error = 1}).holds);
  EXPECT_EQ(verified(low, none, Certificate{.max_error = 1}.prove(0, Steps().face(0))).why_not,
            "IN, face 0: a step names no face");
}

TEST(Verify, RefusesMeshesThatAreNone) {
  const verify::Triangles good = triangles_of(low);
  const std::string bytes = one_face_each(0.1).bytes(low, low);
  const std::vector<double> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<std::uint32_t> corners{0, 1, 2};
  const auto why_not = [&](const std::vector<double>& p, const std::vector<std::uint32_t>& c) {
    EXPECT_EQ(verify::verify(good, {p, c}, bytes).why_not.substr(0, 3), "OUT");
    return verify::verify({p, c}, good, bytes).why_not;
  };
  EXPECT_TRUE(verify::verify({positions, corners}, good, bytes).holds);
  EXPECT_THAT(why_not(positions, {0, 1, 3}), HasSubstr("IN has a face with a corner that is not there"));
  EXPECT_THAT(why_not(positions, {0, 1, 0xffffffff}), HasSubstr("not there"));
  EXPECT_THAT(why_not(positions, {0, 1}), HasSubstr("not divisible by 3"));
  EXPECT_THAT(why_not({0, 0, 0, 1, 0, 0, 0, 1}, corners), HasSubstr("not divisible by 3"));
  for (const double bad : {infinity, -infinity, std::nan(""), 1e300}) {
    std::vector<double> p = positions;
    p[4] = bad;
    EXPECT_THAT(why_not(p, corners), HasSubstr("the position of vertex 1 is not finite, or above 3e150"));
  }
}

}  // namespace
}  // namespace whittle::test
