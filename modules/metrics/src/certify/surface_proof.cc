#include "whittle/metrics/detail/surface_proof.hh"

#include <algorithm>
#include <array>
#include <utility>

#include "whittle/core/geometry/bounds.hh"

namespace whittle::metrics {
namespace {

/// Pieces of a face that are looked at before a change is refused.
constexpr int most_pieces = 256;

/// Whether points of both may be within a distance. The boxes are made a little larger than they are.
bool may_be_near(const Box& a, const Box& b, double distance) {
  constexpr double room = 1e-9;
  const Vec3 reach = Vec3::Constant(distance + room);
  return ((a.min() - reach).array() <= b.max().array()).all() && ((b.min() - reach).array() <= a.max().array()).all();
}

bool is_near(const Corners& face, const Vec3& point, double distance) {
  return distance_to(face, point) <= distance - distance_slack;
}

/// Whether all of a triangle is near: the distance from a face is convex, so it is greatest at a corner.
bool is_near(const Corners& face, const Corners& triangle, double distance) {
  return std::all_of(triangle.begin(), triangle.end(),
                     [&](const Vec3& corner) { return is_near(face, corner, distance); });
}

/// The first face that a proof names.
Index first_face(const std::vector<ProofStep>& steps) {
  const auto is_face = [](const ProofStep& step) { return step.kind != ProofStep::Kind::halves; };
  const auto step = std::find_if(steps.begin(), steps.end(), is_face);
  return step == steps.end() ? invalid_index : step->number;
}

/// The faces of a surface that may be within a distance of a triangle, and are connected with faces of a proof.
std::vector<Index> connected_near(const LinkedFaces& surface, const std::vector<ProofStep>& steps,
                                  const Corners& triangle, double distance) {
  const Box box = box_of(triangle);
  std::vector<Index> near;
  NumberSet known;
  const auto add = [&](Index face) {
    if (face == invalid_index || !may_be_near(box_of(surface.corners(face)), box, distance)) return;
    if (known.insert(face)) near.push_back(face);
  };
  for (const ProofStep& step : steps) {
    if (step.kind != ProofStep::Kind::halves) add(step.number);
  }
  for (std::size_t i = 0; i < near.size(); ++i) {
    const FacesBeyond beyond = surface.beyond[near[i]];
    std::for_each(beyond.begin(), beyond.end(), add);
  }
  return near;
}

}  // namespace

SurfaceProof::SurfaceProof(const IndexedMesh& original, double limit)
    : frame_(Frame::of_points(original.positions)),
      limit_(limit * frame_.scale),
      original_(original, frame_),
      prover_(original_, most_pieces) {}

// Start ---------------------------------------------------------------------------------------------------------------

void SurfaceProof::start(std::span<const Vec3> positions, std::span<const Face> faces) {
  positions_.clear();
  positions_.reserve(positions.size());
  faces_.clear();
  for (const Vec3& position : positions) positions_.push_back(frame_.to_frame(position));
  originals_.assign(original_.faces().faces.size(), {});
  nearby_.assign(original_.faces().positions.size(), {});
  n_looks_ = 0;
  n_unproven_ = 0;
  const Change nothing;
  look_at(nothing);
  start_surface(faces);
  start_original(faces);
  change_ = nullptr;
}

SurfaceProof::SurfaceFace& SurfaceProof::face(Index number) {
  if (number >= faces_.size()) faces_.resize(number + std::size_t{1});
  return faces_[number];
}

/// If there are as many faces as in the original, the first hint of face i is face i: mostly it is the same face.
void SurfaceProof::start_surface(std::span<const Face> faces) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    SurfaceFace& face = this->face(faces[i].number);
    face.vertices = faces[i].vertices;
    face.hint = faces.size() == originals_.size() ? static_cast<Index>(i) : invalid_index;
    const std::optional<Index> near = hint_if_near(faces[i]);
    face.hint = near.value_or(face.hint);
    set_unproven(face.is_unproven, !near);
  }
}

void SurfaceProof::start_original(std::span<const Face> faces) {
  IndexedMesh mesh;
  mesh.positions = positions_;
  mesh.faces.reserve(faces.size());
  for (const Face& face : faces) mesh.faces.push_back(face.vertices);
  if (mesh.faces.empty()) {
    for (Index f = 0; f < originals_.size(); ++f) set_rest(f, {}, true);
    return;
  }
  const TargetSurface surface(mesh, Frame{});
  Prover prover(surface);
  for (Index f = 0; f < originals_.size(); ++f) {
    FarthestPoint farthest;
    const Corners corners = corners_of_original(f);
    const Index hint = faces.size() == originals_.size() ? f : invalid_index;
    const Verdict verdict = prover.prove(corners, limit_, hint, farthest);
    if (verdict == Verdict::proven) {
      rest_at_start(f, connected_near(surface.faces(), prover.steps(), corners, limit_), faces);
    } else {
      set_rest(f, {faces[surface.nearest(corners[0], hint).face].number}, true);
    }
  }
}

/// \param near indices in `faces`, of which the first is likely to do alone
void SurfaceProof::rest_at_start(Index original_face, const std::vector<Index>& near, std::span<const Face> faces) {
  const Face& first = faces[near[0]];
  if (is_near(corners_after(first.vertices), corners_of_original(original_face), limit_)) {
    set_rest(original_face, {first.number}, false);
    return;
  }
  std::vector<Face> part;
  part.reserve(near.size());
  for (const Index i : near) part.push_back(faces[i]);
  make_part(part);
  const bool is_proven = is_near_part(original_face, part_);
  set_rest(original_face, near_in_part(original_face, part_), !is_proven);
}

// A change ------------------------------------------------------------------------------------------------------------

void SurfaceProof::look_at(const Change& change) {
  change_ = &change;
  position_ = frame_.to_frame(change.position);
  has_others_ = false;
  has_part_ = false;
  added_.clear();
  for (const Face& face : change.added) added_.push_back(corners_after(face.vertices));
  added_near_ = 0;
  list_affected();
}

void SurfaceProof::list_affected() {
  affected_.clear();
  ++n_looks_;
  for (const Index number : change_->removed) {
    faces_[number].removed_in = n_looks_;
    for (const Index f : faces_[number].resting) {
      if (std::exchange(originals_[f].look, n_looks_) != n_looks_) affected_.push_back(f);
    }
  }
}

/// Cheap checks come first.
bool SurfaceProof::allows(const Change& change) {
  look_at(change);
  if (!is_position_near()) return false;
  const auto can_rest = [this](Index f) { return this->can_rest(f); };
  const auto is_near = [this](const Face& face) { return hint_if_near(face).has_value(); };
  return std::all_of(affected_.begin(), affected_.end(), can_rest) &&
         std::all_of(change.added.begin(), change.added.end(), is_near);
}

void SurfaceProof::make(const Change& change) {
  look_at(change);
  std::vector<std::optional<Index>> hints;
  hints.reserve(change.added.size());
  for (const Face& face : change.added) hints.push_back(hint_if_near(face));
  std::vector<std::pair<std::vector<Index>, bool>> rests(affected_.size());
  for (std::size_t i = 0; i < affected_.size(); ++i) rests[i].first = find_rest(affected_[i], rests[i].second);
  const Index old_hint = change.removed.empty() ? invalid_index : faces_[change.removed[0]].hint;

  for (const Index number : change.removed) remove(number);
  for (const Index f : affected_) take_off(f);
  if (change.moved != invalid_index) positions_[change.moved] = position_;
  for (std::size_t i = 0; i < hints.size(); ++i) {
    SurfaceFace& face = this->face(change.added[i].number);
    face.vertices = change.added[i].vertices;
    face.hint = hints[i].value_or(old_hint);
    set_unproven(face.is_unproven, !hints[i]);
  }
  for (std::size_t i = 0; i < affected_.size(); ++i) {
    set_rest(affected_[i], std::move(rests[i].first), rests[i].second);
  }
}

bool SurfaceProof::is_position_near() const {
  if (change_->moved == invalid_index || change_->added.empty()) return true;
  return original_.nearest(position_, hint_for(change_->added[0])).distance <= limit_;
}

Index SurfaceProof::hint_for(const Face& face) const {
  if (face.number < faces_.size() && faces_[face.number].hint != invalid_index) return faces_[face.number].hint;
  return change_->removed.empty() ? invalid_index : faces_[change_->removed[0]].hint;
}

/// A face of the original that is near to a new face, if all of that is proven to be near to the original.
std::optional<Index> SurfaceProof::hint_if_near(const Face& face) {
  FarthestPoint farthest;
  const Verdict verdict = prover_.prove(corners_after(face.vertices), limit_, hint_for(face), farthest);
  if (verdict != Verdict::proven) return std::nullopt;
  return first_face(prover_.steps());
}

bool SurfaceProof::can_rest(Index original_face) {
  if (find_added_near(original_face)) return true;
  return !is_any_corner_lost(original_face) && is_near_part(original_face, part_after());
}

bool SurfaceProof::is_any_corner_lost(Index original_face) {
  const Triangle& corners = original_.faces().faces[original_face];
  return std::any_of(corners.begin(), corners.end(), [this](Index v) { return nearby(v) == Nearby::nothing; });
}

/// A new face that all of a face of the original is near to. Mostly one will do for all three corners.
std::optional<std::size_t> SurfaceProof::find_added_near(Index original_face) {
  const Triangle& vertices = original_.faces().faces[original_face];
  const Corners corners = corners_of_original(original_face);
  const std::array<Index, 3> near{nearby(vertices[0]), nearby(vertices[1]), nearby(vertices[2])};
  if (*std::max_element(near.begin(), near.end()) >= Nearby::other) return std::nullopt;
  if (near[0] == near[1] && near[1] == near[2]) return near[0];
  for (const Index i : near) {
    if (is_near(added_[i], corners, limit_)) return i;
  }
  for (std::size_t i = 0; i < added_.size(); ++i) {
    if (is_near(added_[i], corners, limit_)) return i;
  }
  return std::nullopt;
}

/// The face near a vertex of the original after the change.
Index SurfaceProof::nearby(Index original_vertex) {
  Nearby& nearby = nearby_[original_vertex];
  if (nearby.look != n_looks_) nearby = {n_looks_, find_nearby(original_.faces().positions[original_vertex])};
  return nearby.added;
}

Index SurfaceProof::find_nearby(const Vec3& point) {
  const auto is_near_point = [&](const Corners& face) { return is_near(face, point, limit_); };
  if (added_near_ < added_.size() && is_near_point(added_[added_near_])) return static_cast<Index>(added_near_);
  const auto added = std::find_if(added_.begin(), added_.end(), is_near_point);
  if (added != added_.end()) {
    added_near_ = static_cast<std::size_t>(added - added_.begin());
    return static_cast<Index>(added_near_);
  }
  list_others();
  const bool is_near_other = std::any_of(others_corners_.begin(), others_corners_.end(), is_near_point);
  return is_near_other ? Nearby::other : Nearby::nothing;
}

/// Lists the faces around, and other remaining faces on which affected faces rest.
void SurfaceProof::list_others() {
  if (std::exchange(has_others_, true)) return;
  others_.clear();
  others_corners_.clear();
  const auto add = [this](Index number) {
    SurfaceFace& face = faces_[number];
    if (face.removed_in == n_looks_ || std::exchange(face.listed_in, n_looks_) == n_looks_) return;
    others_.push_back(number);
    others_corners_.push_back(corners_after(face.vertices));
  };
  std::for_each(change_->around.begin(), change_->around.end(), add);
  for (const Index f : affected_) {
    const std::vector<Index>& rests_on = originals_[f].rests_on;
    std::for_each(rests_on.begin(), rests_on.end(), add);
  }
}

/// The new faces and the others.
SurfaceProof::Part& SurfaceProof::part_after() {
  if (std::exchange(has_part_, true)) return part_;
  list_others();
  std::vector<Face> faces = change_->added;
  for (const Index number : others_) faces.push_back({number, faces_[number].vertices});
  make_part(faces);
  return part_;
}

void SurfaceProof::make_part(std::span<const Face> faces) {
  std::vector<Index> vertices;
  for (const Face& face : faces) vertices.insert(vertices.end(), face.vertices.begin(), face.vertices.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto number_of = [&vertices](Index v) {
    return static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  };
  part_.numbers.clear();
  part_.mesh = {};
  for (const Index v : vertices) part_.mesh.positions.push_back(position_after(v));
  for (const auto& [number, corners] : faces) {
    part_.numbers.push_back(number);
    part_.mesh.faces.push_back({number_of(corners[0]), number_of(corners[1]), number_of(corners[2])});
  }
  part_.prover.reset();
  part_.surface.reset();
  if (faces.empty()) return;
  part_.surface.emplace(part_.mesh, Frame{});
  part_.prover.emplace(*part_.surface, most_pieces);
}

bool SurfaceProof::is_near_part(Index original_face, Part& part) const {
  if (!part.prover) return false;
  FarthestPoint farthest;
  return part.prover->prove(corners_of_original(original_face), limit_, 0, farthest) == Verdict::proven;
}

/// The faces that a proof with the part may have looked at near the face of the original: others are farther.
std::vector<Index> SurfaceProof::near_in_part(Index original_face, const Part& part) const {
  const Box box = box_of(corners_of_original(original_face));
  std::vector<Index> near;
  for (std::size_t i = 0; i < part.numbers.size(); ++i) {
    const auto& [a, b, c] = part.mesh.faces[i];
    const Corners corners{part.mesh.positions[a], part.mesh.positions[b], part.mesh.positions[c]};
    if (may_be_near(box_of(corners), box, limit_)) near.push_back(part.numbers[i]);
  }
  return near;
}

/// The faces on which a face rests after the change; all new faces if the proof fails.
std::vector<Index> SurfaceProof::find_rest(Index original_face, bool& is_unproven) {
  is_unproven = false;
  if (const std::optional<std::size_t> near = find_added_near(original_face)) return {change_->added[*near].number};
  if (!is_any_corner_lost(original_face) && is_near_part(original_face, part_after())) {
    return near_in_part(original_face, part_);
  }
  is_unproven = true;
  std::vector<Index> all;
  for (const Face& face : change_->added) all.push_back(face.number);
  return all;
}

void SurfaceProof::set_rest(Index original_face, std::vector<Index> faces, bool is_unproven) {
  for (const Index number : faces) face(number).resting.push_back(original_face);
  originals_[original_face].rests_on = std::move(faces);
  set_unproven(originals_[original_face].is_unproven, is_unproven);
}

void SurfaceProof::take_off(Index original_face) {
  for (const Index number : originals_[original_face].rests_on) std::erase(faces_[number].resting, original_face);
  originals_[original_face].rests_on.clear();
}

void SurfaceProof::remove(Index number) {
  set_unproven(faces_[number].is_unproven, false);
  faces_[number] = {};
}

void SurfaceProof::set_unproven(bool& is_unproven, bool value) {
  n_unproven_ += static_cast<std::size_t>(value);
  n_unproven_ -= static_cast<std::size_t>(std::exchange(is_unproven, value));
}

}  // namespace whittle::metrics
