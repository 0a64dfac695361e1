#include "whittle/engine/two_sided_sheets.hh"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "attributes/face_attributes.hh"
#include "complex/triangle_complex.hh"
#include "sides/wedges_of_sides.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/two_sided.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// The corner of a face that is a vertex. \pre there is one
std::size_t corner_at(const Triangle& face, Index vertex) {
  return static_cast<std::size_t>(std::find(face.begin(), face.end(), vertex) - face.begin());
}

/// Numbers the groups of both sides of faces. \param fronts, backs of faces → faces of the mesh
void set_groups_of_sides(const IndexedMesh& mesh, std::span<const Index> fronts, std::span<const Index> back_of,
                         IndexedMesh& without_backs) {
  const auto group_of = [&](Index f) {
    if (f == invalid_index) return invalid_index;
    return mesh.face_groups.empty() ? Index{0} : mesh.face_groups[f];
  };
  std::vector<std::pair<Index, Index>> of_faces;
  for (const Index f : fronts) of_faces.emplace_back(group_of(f), group_of(back_of[f]));
  std::vector<std::pair<Index, Index>> all = of_faces;
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (const auto& groups : of_faces) {
    without_backs.face_groups.push_back(
        static_cast<Index>(std::lower_bound(all.begin(), all.end(), groups) - all.begin()));
  }
  for (std::size_t i = 0; i < all.size(); ++i) without_backs.group_names.push_back(std::to_string(i));
}

SurfaceCounts with_nonmanifold_of(const IndexedMesh& mesh, const Frame& frame, unsigned threads, SurfaceCounts counts) {
  TriangleComplex complex(mesh.positions, mesh.faces, frame, threads);
  complex.connect({}, threads);
  const NonmanifoldCounts nonmanifold = complex.count_nonmanifold();
  counts.nonmanifold_edges = nonmanifold.edges;
  counts.nonmanifold_vertices = nonmanifold.vertices;
  return counts;
}

}  // namespace

TwoSidedSheets::TwoSidedSheets(const IndexedMesh& mesh, unsigned threads)
    : mesh_(mesh), fronts_of_backs_(fronts_of_backs(mesh, threads)) {
  if (!any()) return;
  check_attributes(mesh, "decimate");
  back_of_.assign(mesh.faces.size(), invalid_index);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (fronts_of_backs_[f] == invalid_index) {
      kept_.push_back(f);
    } else {
      back_of_[fronts_of_backs_[f]] = f;
    }
  }
  without_backs_.positions = mesh.positions;
  without_backs_.origins = mesh.origins;
  without_backs_.normals = mesh.normals;
  without_backs_.colors = mesh.colors;
  without_backs_.attributes = mesh.attributes;
  std::vector<Index> other_sides;  // of the faces that are kept: the backs, or they themselves
  std::vector<Index> back_wedges;
  for (const Index f : kept_) {
    const Triangle& face = mesh.faces[f];
    const Index other = back_of_[f] == invalid_index ? f : back_of_[f];
    without_backs_.faces.push_back(face);
    other_sides.push_back(other);
    for (std::size_t k = 0; k < 3 && !mesh.wedges.empty(); ++k) {
      without_backs_.wedges.push_back(mesh.wedge(f, k));
      back_wedges.push_back(mesh.wedge(other, corner_at(mesh.faces[other], face[k])));
    }
  }
  has_own_wedges_ = join_sides_of_wedges(back_wedges, without_backs_);
  IndexedMesh backs;
  carry_face_attributes(mesh, other_sides, backs);
  carry_face_attributes(mesh, kept_, without_backs_);
  std::move(backs.face_attributes.begin(), backs.face_attributes.end(),
            std::back_inserter(without_backs_.face_attributes));
  without_backs_.face_groups.clear();
  without_backs_.group_names.clear();
  set_groups_of_sides(mesh, kept_, back_of_, without_backs_);
}

std::uint64_t TwoSidedSheets::n_faces_with_backs(std::span<const Index> faces) const {
  const auto n_backs = std::count_if(faces.begin(), faces.end(), [this](Index face) { return has_back(face); });
  return faces.size() + static_cast<std::uint64_t>(n_backs);
}

DecimateOptions TwoSidedSheets::options_without_backs(DecimateOptions options) const {
  if (!options.progress) return options;
  const double factor = static_cast<double>(mesh_.faces.size()) / static_cast<double>(kept_.size());
  options.progress = [factor, callback = options.progress](Progress progress) {
    progress.n_faces = static_cast<std::uint64_t>(factor * static_cast<double>(progress.n_faces));
    return callback(progress);
  };
  return options;
}

RunSteps TwoSidedSheets::steps_without_backs(RunSteps steps) const {
  for (PassEnd& end : steps.pass_ends) {
    std::erase_if(end.turned, [this](const PassEnd::TurnedFace& turned) {
      return turned.face < mesh_.faces.size() && fronts_of_backs_[turned.face] != invalid_index;
    });
    for (PassEnd::TurnedFace& turned : end.turned) {
      const auto kept = std::lower_bound(kept_.begin(), kept_.end(), turned.face);
      if (kept == kept_.end()) throw std::invalid_argument("steps turn a face that isn't there");
      turned.face = static_cast<Index>(kept - kept_.begin());
    }
  }
  return steps;
}

/// The faces with their backs, by the order of the mesh. \param face_origins in `without_backs_`
std::vector<TwoSidedSheets::Side> TwoSidedSheets::sides_of(std::span<const Index> face_origins) const {
  std::vector<Side> sides;
  for (Index face = 0; face < face_origins.size(); ++face) {
    const Index front = kept_[face_origins[face]];
    sides.push_back({front, face, false});
    if (back_of_[front] != invalid_index) sides.push_back({back_of_[front], face, true});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.origin < b.origin; });
  return sides;
}

/// Corners of a face in the order of its back. \param corners anything that the front's corners have
Triangle TwoSidedSheets::as_side(const Triangle& corners, const Side& side) const {
  if (!side.is_back) return corners;
  const Triangle& front = mesh_.faces[fronts_of_backs_[side.origin]];
  Triangle mirrored;
  for (std::size_t k = 0; k < 3; ++k) mirrored[k] = corners[corner_at(front, mesh_.faces[side.origin][k])];
  return mirrored;
}

void TwoSidedSheets::add_backs_to(RunSteps& steps) const {
  for (PassEnd& end : steps.pass_ends) {
    std::vector<Index> faces;
    for (const PassEnd::TurnedFace& turned : end.turned) faces.push_back(turned.face);
    std::vector<PassEnd::TurnedFace> turned;
    for (const Side& side : sides_of(faces)) {
      turned.push_back({side.origin, as_side(end.turned[side.face].corners, side)});
    }
    end.turned = std::move(turned);
  }
}

void TwoSidedSheets::add_backs_to(std::span<const Side> sides, Normals normals, IndexedMesh& mesh) const {
  const bool turns_normals = normals == Normals::recompute && !mesh.normals.empty();
  const bool has_own_wedges = has_own_wedges_ || turns_normals;
  const auto n_wedges_of_fronts = has_own_wedges ? static_cast<Index>(n_wedges(mesh)) : Index{0};
  if (has_own_wedges) part_sides_of_wedges(mesh_, has_own_wedges_, turns_normals, mesh);
  std::vector<Triangle> faces;
  std::vector<Index> wedges;
  for (const Side& side : sides) {
    faces.push_back(as_side(mesh.faces[side.face], side));
    if (mesh.wedges.empty()) continue;
    const Triangle of_front{mesh.wedge(side.face, 0), mesh.wedge(side.face, 1), mesh.wedge(side.face, 2)};
    for (const Index w : as_side(of_front, side)) wedges.push_back(side.is_back ? n_wedges_of_fronts + w : w);
  }
  mesh.faces = std::move(faces);
  mesh.wedges = std::move(wedges);
  if (has_own_wedges) join_equal_wedges(mesh);
}

void TwoSidedSheets::add_backs(Normals normals, unsigned threads, Decimation& decimation) const {
  const std::vector<Side> sides = sides_of(decimation.face_origins);
  add_backs_to(sides, normals, decimation.mesh);
  decimation.face_origins.clear();
  for (const Side& side : sides) decimation.face_origins.push_back(side.origin);
  decimation.mesh.group_names.clear();
  carry_face_attributes(mesh_, decimation.face_origins, decimation.mesh);
  add_backs_to(decimation.steps);
  const Frame frame = Frame::of_points(mesh_.positions);
  DecimateResult& result = decimation.result;
  result.n_faces = decimation.mesh.faces.size();
  result.before = with_nonmanifold_of(mesh_, frame, threads, result.before);
  result.after = with_nonmanifold_of(decimation.mesh, frame, threads, result.after);
}

}  // namespace whittle
