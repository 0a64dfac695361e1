#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rounds/rounds.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::test {

inline DecimateOptions options_of_rounds() {
  DecimateOptions options;
  options.cost = Cost::memoryless;
  return options;
}

inline MeanFaceArea mean_area(const IndexedMesh& mesh) {
  double area = 0;
  for (const Triangle& face : mesh.faces) area += area_of(corners_of(mesh.positions, face));
  return {area, mesh.faces.size(), mesh.faces.size()};
}

/// A mesh in rounds, as its only part.
class InRounds {
 public:
  explicit InRounds(const IndexedMesh& mesh, std::vector<std::uint8_t> frozen = {},
                    std::vector<std::uint8_t> locked = {}, SurfaceAttributes attributes = {},
                    const DecimateOptions& options = options_of_rounds(), const StageLimits& limits = {})
      : mesh_(mesh),
        options_(options),
        frozen_(std::move(frozen)),
        locked_(std::move(locked)),
        log_(mesh.positions.size()) {
    WorkingSurface surface;
    surface.positions = mesh.positions;
    surface.faces = mesh.faces;
    surface.cost_state.face_area = mean_area(mesh);
    surface.cost_state.attributes = std::move(attributes);
    StageContext context{options_};
    context.frozen = frozen_;
    context.locked = locked_;
    context.limits = limits;
    context.log = &end_of_log_;
    rounds_.emplace(surface, context, pool_);
  }

  Rounds& rounds() { return *rounds_; }
  std::span<const Contraction> made() const { return {log_.data(), end_of_log_.end}; }
  /// By vertices of the mesh.
  SurfaceAttributes attributes() const {
    const std::vector<Index> merged_into = rounds_->merged_into();
    std::vector<Index> left;
    for (Index v = 0; v < merged_into.size(); ++v) {
      if (merged_into[v] == v) left.push_back(v);
    }
    SurfaceAttributes attributes = rounds_->state(left).attributes;
    for (Index& v : attributes.vertex_of) v = left[v];
    return attributes;
  }
  IndexedMesh result() const {
    const std::vector<Index> merged_into = rounds_->merged_into();
    IndexedMesh left;
    left.positions = mesh_.positions;
    for (Index v = 0; v < left.positions.size(); ++v) left.positions[v] = rounds_->position(v);
    for (const Triangle& face : mesh_.faces) {
      const Triangle now{merged_into[face[0]], merged_into[face[1]], merged_into[face[2]]};
      if (has_three_corners(now)) left.faces.push_back(now);
    }
    return left;
  }

 private:
  const IndexedMesh& mesh_;
  DecimateOptions options_;
  std::vector<std::uint8_t> frozen_, locked_;
  std::vector<Contraction> log_;
  ContractionLog end_of_log_{log_.data()};
  RoundScratchPool pool_;
  std::optional<Rounds> rounds_;
};

}  // namespace whittle::test
