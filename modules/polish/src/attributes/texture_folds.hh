#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/attribute_feet.hh"
#include "whittle/core/indexed_mesh.hh"

// Folds in a texture: faces that lie on the image the other way round than the original does there. A mirrored chart is
// no fold, as its original is mirrored, too.

namespace whittle::polishing {

/// A surface that is cut open at its seams, and the texture coordinates of its vertices: the first two of
/// `n_components` numbers each.
struct TexturedFaces {
  std::span<const Triangle> faces;
  std::span<const double> texcoords;
  std::size_t n_components;
};

/// Which way round each face of a mesh should lie on the image: 1 or -1, or 0 where the original says neither. The
/// original's faces vote whose centroids have their feet there. \param feet of these \param n_faces of the mesh
std::vector<std::int8_t> turns_on_image(const TexturedFaces& original, std::span<const AttributeFeet::Sample> feet,
                                        std::size_t n_faces);

/// Moves texture coordinates so that faces lie the way round that they should, each as little as will do.
/// \param turns as above, a face \param held 1 for a wedge that keeps its coordinates; or empty
/// \return how many folded faces are left
std::size_t unfold(std::span<const Triangle> faces, std::span<const std::int8_t> turns, std::span<double> texcoords,
                   std::size_t n_components, std::span<const std::uint8_t> held = {});

}  // namespace whittle::polishing
