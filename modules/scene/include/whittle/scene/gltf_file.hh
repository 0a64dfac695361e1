#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "whittle/gltf/asset.hh"
#include "whittle/io/read.hh"
#include "whittle/scene/format.hh"

namespace whittle {

/// A glTF file as one mesh, in the scene's coordinates, and back. So one run simplifies all of its meshes, and each
/// gets the faces that its shape needs. Where borders of meshes coincide in the scene, they are welded: these vertices
/// belong to several meshes, and a surface that is closed in the scene stays closed.
class GltfFile {
 public:
  /// \throw io::ReadError
  explicit GltfFile(const std::filesystem::path& path);

  /// Reads all meshes that have triangles. There may be none: then the whole has no faces, `why_no_faces` says why, and
  /// `write` writes the file as it was.
  /// \throw io::ReadError also for a scene of more than 2^27 triangles
  io::ReadResult read(const io::ReadOptions& options, SceneScope scope);

  const gltf::Asset& asset() const { return asset_; }
  /// What was read. \pre `read`
  SceneScope scope() const { return scope_; }

  /// Those that were read. \pre `read`
  std::size_t n_meshes() const { return parts_.size(); }
  /// \param mesh below `n_meshes`
  std::string mesh_name(std::size_t mesh) const { return asset_.mesh_name(parts_[mesh].mesh); }

  /// For each face of the whole, or of what has become of it, the mesh that it belongs to, below `n_meshes`.
  std::vector<Index> meshes_of_faces(const IndexedMesh& mesh) const;

  /// For each group of faces of what was read: the number of its mesh in the file, and of its primitive. \pre `read`
  struct Group {
    std::size_t mesh, primitive;
  };
  std::vector<Group> groups() const;

  /// Writes the file with its meshes replaced, and the files that lie beside it (`gltf::Asset::files`). If there are
  /// coarser levels, nodes get them as levels of detail (`gltf::Asset::add_levels`).
  /// \param mesh what `read` gave, simplified; null: the meshes stay as they are \param levels of what `read` gave
  /// \param compress as `gltf::WriteOptions` has it
  /// \return a line for each thing that isn't as it was
  /// \pre `SceneScope::meshes` was read. With levels: there is no `mesh_with_levels`, and nothing was written before
  std::vector<std::string> write(io::OutputFiles& files, const std::string& path, const IndexedMesh* mesh,
                                 CoarserLevels levels, bool compress);

  /// The name of a mesh that has levels of detail already. Empty if none has. \pre `read`
  std::string mesh_with_levels() const;

  /// A mesh with the positions that it has after `write`, not compressed, and `read`. A vertex of several meshes has
  /// the place that one of them has in the file. \pre as `write`
  IndexedMesh as_written(IndexedMesh mesh) const;
  /// How far the places of a vertex of several meshes lie apart at most after `write`: each of them is rounded in the
  /// coordinates of its mesh. \pre as `write`
  double widest_gap_as_written(const IndexedMesh& mesh) const;

  /// The vertices that have to stay, so that a surface that is closed in the scene stays closed: those on borders that
  /// meet others there, where the scene shows one of both meshes several times. What moves one copy moves them all.
  /// Scenes of more than 2^24 triangles aren't looked at.
  /// \param mesh what `read` gave, or some of its faces \return V; empty if there are none \pre as `write`
  std::vector<std::uint8_t> held_borders(const IndexedMesh& mesh, unsigned threads) const;

 private:
  /// A mesh of the file that has triangles.
  struct Part {
    std::size_t mesh;       ///< its number in the file
    Eigen::Affine3d place;  ///< from its coordinates to the scene's, the first if it has several
    Index first_group;      ///< in the whole
    Index n_groups;
    bool has_normals, has_colors;
    std::vector<Attribute> attributes;  ///< without values
    std::size_t first_origin;           ///< of its vertices
    std::vector<Vec3> file_positions;   ///< of the file's vertices, in its coordinates; empty for a scene

    /// A vertex of another mesh to which one of this mesh was welded.
    struct Welded {
      Index origin;
      Index file_vertex;  ///< that of this mesh
      Vec3 position;      ///< of both, in the whole
    };
    std::vector<Welded> welded{};  ///< by origin

    /// The position that a vertex has in the file, if it still lies there; or null.
    const Vec3* unmoved(Index origin, const Vec3& position) const;
    /// A position of the whole as the file will have it, and back in the whole.
    Vec3 as_written(Index origin, const Vec3& position) const;
  };

  /// A vertex of the scene, where a mesh may be several times.
  struct CopiedVertex {
    Index vertex;  ///< in the whole
    Index copy;    ///< counts places of meshes
    bool is_of_repeated;
  };

  /// A mesh at one of its places in the whole.
  struct Copy {
    Index first_vertex;
    bool is_flat;  ///< its node flattens it
  };

  std::vector<Eigen::Affine3d> places_of(std::size_t mesh) const;
  Eigen::Affine3d place_of_one(std::span<const Eigen::Affine3d> places, const IndexedMesh& mesh);
  Part part_of(std::size_t number, const Eigen::Affine3d& place, const IndexedMesh& mesh, const IndexedMesh& all) const;
  void read_mesh(std::size_t number, std::vector<Eigen::Affine3d> places, const io::ReadOptions& options,
                 io::ReadResult& all);
  /// Whether what was asked for leaves out a mesh. \pre the scene shows another one
  bool leaves_out(std::size_t mesh) const;
  void warn_of_left_out(std::span<const std::size_t> meshes, io::ReadResult& result) const;
  double border_tolerance(const IndexedMesh& mesh) const;
  std::vector<Index> copies_of_vertices(std::size_t n_vertices) const;
  void weld_borders(const io::ReadOptions& options, io::ReadResult& all);
  void remember_welded(const std::vector<Index>& origins, const std::vector<Index>& map, const IndexedMesh& mesh);
  IndexedMesh scene_of(const IndexedMesh& mesh, std::vector<CopiedVertex>& copied) const;
  std::vector<IndexedMesh> split(const IndexedMesh& mesh) const;
  void add_levels(CoarserLevels levels, std::vector<std::string>& warnings);
  std::vector<IndexedMesh> split_for_file(const IndexedMesh& mesh, const std::string& level,
                                          std::vector<std::string>& warnings) const;

  std::filesystem::path path_;
  gltf::Asset asset_;
  SceneScope scope_ = SceneScope::meshes;
  std::vector<Part> parts_;
  Vec3 scene_origin_ = Vec3::Zero();  ///< where the whole counts positions from, in the scene
  std::vector<Copy> copies_;          ///< of meshes in the whole
  double reach_ = 0;                  ///< of the meshes' own coordinates, with the scene's size
};

/// Whether the scene of an asset shows a mesh with triangles. Where it shows none, programs show all meshes.
bool shows_meshes(const gltf::Asset& asset);

/// Writes an asset, and the files that lie beside it (`gltf::Asset::files`).
void write_asset(io::OutputFiles& files, const std::string& path, const gltf::Asset& asset, bool compress);

/// Turns textures upside down: in glTF the second texture coordinate grows downwards, in all other formats upwards.
void flip_texcoords(IndexedMesh& mesh);

}  // namespace whittle
