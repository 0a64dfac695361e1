#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/material.hh"
#include "whittle/scene/format.hh"

namespace whittle {

/// A mesh of a document, in its own coordinates, at the places where the scene shows it.
struct PlacedMesh {
  IndexedMesh mesh;
  std::vector<Material> materials;  ///< by face group
  std::vector<Eigen::Affine3d> places;
};

/// A document (`SceneFormat::is_document`) that was read. Its `Scene` has its meshes as one mesh, the whole; this knows
/// them one by one. A format's own sources implement it.
class SceneDocument {
 public:
  SceneDocument() = default;
  SceneDocument(const SceneDocument&) = delete;
  SceneDocument& operator=(const SceneDocument&) = delete;
  virtual ~SceneDocument() = default;

  /// The scope that was read.
  virtual SceneScope scope() const = 0;

  /// Number of meshes read.
  virtual std::size_t n_meshes() const = 0;
  /// \param mesh below `n_meshes`
  virtual std::string mesh_name(std::size_t mesh) const = 0;
  /// For each face of the whole, or of a mesh made from it, its mesh, below `n_meshes`.
  virtual std::vector<Index> meshes_of_faces(const IndexedMesh& mesh) const = 0;
  /// The name of a mesh with levels of detail; empty if none has.
  virtual std::string mesh_with_levels() const = 0;

  /// By face group of the whole, with images. \throw io::ReadError for invalid materials
  virtual std::vector<Material> materials() const = 0;
  /// What the document's scene shows; all meshes at their own coordinates if it shows none. \throw as `materials`
  virtual std::vector<PlacedMesh> shown_meshes() const = 0;
  /// Content that a file with one mesh can't hold, to be read after "left out: "; empty if there is none.
  /// \param mesh the whole, or one made from it, with its groups
  virtual std::string left_out_of_one_mesh(const IndexedMesh& mesh) const = 0;

  /// The vertices that must stay, so that a surface closed in the scene stays closed: vertices on borders that meet
  /// another mesh's border, if the scene shows one of both meshes several times. A move would move all copies. Not
  /// computed for scenes of more than 2^24 triangles.
  /// \param mesh the whole, or some of its faces \return V; empty if none must stay \pre `SceneScope::meshes` was read
  virtual std::vector<std::uint8_t> held_borders(const IndexedMesh& mesh, unsigned threads) const = 0;
  /// Largest distance, after writing, between the positions of a vertex of several meshes: each is rounded in the
  /// coordinates of its mesh. \pre `SceneScope::meshes` was read
  virtual double widest_gap_as_written(const IndexedMesh& mesh) const = 0;
  /// How many times as long as in the whole a length can be in the scene: 1, or more where a mesh is at several places
  /// of different sizes. \pre `SceneScope::meshes` was read
  virtual double widest_stretch() const = 0;
};

}  // namespace whittle
