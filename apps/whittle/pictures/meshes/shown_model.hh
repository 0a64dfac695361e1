#pragma once

#include <optional>
#include <string>

#include "pictures/draw_meshes.hh"
#include "whittle/render/picture.hh"

namespace whittle::app {

/// A surface as a picture shows it.
struct ShownModel {
  const ShownSurface* surface = nullptr;
  render::Rgb color{};                 ///< where nothing else gives one
  const IndexedMesh* other = nullptr;  ///< what its distances go to, if that is shown whole
  bool is_level = false;               ///< of the run: it has a shape alone

  bool has_materials() const { return !surface->materials.empty(); }
  bool has_colors() const { return !surface->mesh.colors.empty(); }
  bool has_normals() const { return !surface->mesh.normals.empty(); }
  /// Whether it has more than a shape.
  bool has_look() const { return has_materials() || has_colors() || has_normals() || !surface->deviations.empty(); }
  /// Of an attribute's error: "texcoord", "colour", "normal". Null for others.
  const ShownDeviations* deviations(const std::string& colour) const;
  /// Whether there is something to see in a colouring.
  bool has(const std::string& colour) const;

  struct Range {
    double max, usual;
  };
  /// Of the errors that a colouring shows.
  std::optional<Range> range(const std::string& colour) const;
};

}  // namespace whittle::app
