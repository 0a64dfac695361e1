#include "whittle/progressive/geomorph.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/wedges.hh"

namespace whittle::progressive {
namespace {

using Normal = std::array<float, 3>;

/// A level with normals, and the input's number of each of its vertices.
struct MorphEnd {
  Decimation level;
  std::vector<Index> vertices;
};

MorphEnd end_at(Replay& replay, std::size_t level) {
  replay.go_to(level);
  MorphEnd end{replay.decimation(), {}};
  IndexedMesh& mesh = end.level.mesh;
  // A vertex that moves has one normal: creases are smoothed.
  if (mesh.normals.empty() || !mesh.wedges.empty()) {
    drop_seams(mesh);
    mesh.normals = vertex_normals(mesh, Frame::of_points(replay.input().positions));
  }
  end.vertices.resize(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) end.vertices[mesh.faces[i][c]] = replay.corners(end.level.face_origins[i])[c];
  }
  return end;
}

/// The finer level's corners of the coarser level's faces that were hidden there. They coincide with faces that are
/// there.
std::vector<Triangle> faces_that_come_back(Replay& replay, const MorphEnd& fine, const MorphEnd& coarse) {
  const std::vector<Index>& there = fine.level.face_origins;
  std::vector<Triangle> faces;
  for (const Index f : coarse.level.face_origins) {
    if (std::binary_search(there.begin(), there.end(), f)) continue;
    Triangle corners = replay.corners(f);
    for (Index& v : corners) v = fine.level.vertex_map[v];
    faces.push_back(corners);
  }
  return faces;
}

/// Whether a face of the finer level differs from its corners' survivors at the coarser level.
/// \pre the replay is at the coarser level \param survivors there
bool is_turned(const Replay& replay, const MorphEnd& fine, const std::vector<Index>& survivors) {
  const IndexedMesh& mesh = fine.level.mesh;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Index face = fine.level.face_origins[i];
    Triangle corners = mesh.faces[i];
    for (Index& v : corners) v = survivors[fine.vertices[v]];
    Triangle at_coarse = replay.corners(face);  // of a face that is hidden, as it was when a pass ended
    for (Index& v : at_coarse) v = survivors[v];
    if ((has_three_corners(corners) || replay.has_face(face)) && corners != at_coarse) return true;
  }
  return false;
}

Normal blend_linearly(const Normal& a, const Normal& b, double share) {
  Vec3 sum(std::lerp(double{a[0]}, double{b[0]}, share), std::lerp(double{a[1]}, double{b[1]}, share),
           std::lerp(double{a[2]}, double{b[2]}, share));
  const double length = sum.norm();
  constexpr double no_direction = 1e-6;
  if (!(length > no_direction)) return a;
  sum /= length;
  return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

/// Any unit vector at a right angle to `v`.
Vec3 perpendicular_to(const Vec3& v) {
  int least = 0;
  v.cwiseAbs().minCoeff(&least);
  return v.cross(Vec3::Unit(least)).normalized();
}

/// \cite shoemake_1985_rotation
Normal blend_spherically(const Normal& a, const Normal& b, double share) {
  const Vec3 from(a[0], a[1], a[2]);
  const Vec3 to(b[0], b[1], b[2]);
  const Vec3 axis = from.cross(to);
  const double angle_deg = detail::angle_of(axis.norm(), from.dot(to)) * (180 / std::numbers::pi);
  constexpr double nearly_equal = 1e-4;
  if (from.isZero() || to.isZero() || angle_deg < nearly_equal) return blend_linearly(a, b, share);
  const bool is_opposite = angle_deg > 180 - nearly_equal;
  const Vec3 across = is_opposite ? perpendicular_to(from) : Vec3((to - from * from.dot(to)).normalized());
  const double turned_deg = share * angle_deg;
  const Vec3 sum = from * detail::cosine_of_deg(turned_deg) + across * detail::cosine_of_deg(std::abs(90 - turned_deg));
  return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

}  // namespace

Geomorph::Geomorph(Replay& replay, std::size_t fine_level, std::size_t coarse_level) {
  if (coarse_level < fine_level) throw std::invalid_argument("geomorph: the second level is finer than the first one");
  if (coarse_level > replay.n_steps()) throw std::out_of_range("geomorph: there is no such level");
  MorphEnd coarse = end_at(replay, coarse_level);
  MorphEnd fine = end_at(replay, fine_level);
  const std::vector<Triangle> more_faces = faces_that_come_back(replay, fine, coarse);
  replay.go_to(coarse_level);
  const std::vector<Index> survivors = replay.survivors();
  if (is_turned(replay, fine, survivors)) {
    throw std::invalid_argument(
        "geomorph: polish flips edges between the two levels, so that vertices can't move from "
        "one to the other");
  }

  fine_ = std::move(fine.level.mesh);
  fine_.faces.insert(fine_.faces.end(), more_faces.begin(), more_faces.end());
  coarse_ = fine_;
  n_coarse_faces_ = coarse.level.mesh.faces.size();
  for (Index v = 0; v < fine_.positions.size(); ++v) {
    const Index input_vertex = fine.vertices[v];
    coarse_.positions[v] = replay.position(survivors[input_vertex]);
    const Index ancestor = coarse.level.vertex_map[input_vertex];
    if (ancestor == invalid_index) continue;  // its part is gone
    coarse_.normals[v] = coarse.level.mesh.normals[ancestor];
    if (!fine_.colors.empty()) coarse_.colors[v] = coarse.level.mesh.colors[ancestor];
  }
}

IndexedMesh Geomorph::at(double share, NormalBlend blend) const {
  if (!(share > 0)) return fine_;
  if (share >= 1) return coarse_;
  IndexedMesh mesh = fine_;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (int i = 0; i < 3; ++i) {
      mesh.positions[v][i] = std::lerp(fine_.positions[v][i], coarse_.positions[v][i], share);
    }
    const auto& blended = blend == NormalBlend::spherical ? blend_spherically : blend_linearly;
    mesh.normals[v] = blended(fine_.normals[v], coarse_.normals[v], share);
  }
  for (std::size_t v = 0; v < mesh.colors.size(); ++v) {
    for (std::size_t i = 0; i < mesh.colors[v].size(); ++i) {
      mesh.colors[v][i] = std::lerp(fine_.colors[v][i], coarse_.colors[v][i], static_cast<float>(share));
    }
  }
  return mesh;
}

}  // namespace whittle::progressive
