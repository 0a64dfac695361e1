#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/attribute_samples.hh"
#include "whittle/core/indexed_mesh.hh"

// Folds in a texture: faces whose orientation on the image differs from the original's there. A mirrored chart is no
// fold, as its original is mirrored, too.

namespace whittle::polishing {

/// A surface that is cut open at its seams, and the texture coordinates of its vertices: the first two of
/// `n_components` numbers each.
struct TexturedFaces {
  std::span<const Triangle> faces;
  std::span<const double> texcoords;
  std::size_t n_components;
};

/// Orientation that each face of a mesh should have on the image: 1, -1, or 0 = unknown. The original's faces vote,
/// each for the face with the closest point of its centroid.
/// \param samples per face of the original
/// \param n_faces number of faces of the mesh
std::vector<std::int8_t> turns_on_image(const TexturedFaces& original,
                                        std::span<const AttributeSamples::Sample> samples, std::size_t n_faces);

/// Moves texture coordinates, each by the least amount, so that faces get the orientations `turns`.
/// \param turns per face, from `turns_on_image`
/// \param held per wedge, 1 = keeps its coordinates; or empty
/// \return number of folded faces left
std::size_t unfold(std::span<const Triangle> faces, std::span<const std::int8_t> turns, std::span<double> texcoords,
                   std::size_t n_components, std::span<const std::uint8_t> held = {});

}  // namespace whittle::polishing
