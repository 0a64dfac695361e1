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
#include "whittle/scene/scene_document.hh"

namespace whittle {

/// Converts a glTF file to one mesh in the scene's coordinates, and back. So one run simplifies all meshes, and each
/// gets the faces that its shape needs. Borders of meshes that coincide in the scene are welded: their vertices belong
/// to several meshes, and a surface closed in the scene stays closed.
class GltfFile final : public SceneDocument {
 public:
  /// \throw io::ReadError
  explicit GltfFile(const std::filesystem::path& path);
  /// \param path for messages
  GltfFile(std::filesystem::path path, gltf::Asset asset);

  /// Reads all meshes with triangles. Without any the result has no faces, `why_no_faces` gives the reason, and `write`
  /// writes the file unchanged.
  /// \throw io::ReadError also for a scene of more than 2^27 triangles
  io::ReadResult read(const io::ReadOptions& options, SceneScope scope);

  const gltf::Asset& asset() const { return asset_; }

  // SceneDocument
  SceneScope scope() const override { return scope_; }
  std::size_t n_meshes() const override { return parts_.size(); }
  std::string mesh_name(std::size_t mesh) const override { return asset_.mesh_name(parts_[mesh].mesh); }
  std::vector<Index> meshes_of_faces(const IndexedMesh& mesh) const override;
  std::string mesh_with_levels() const override;
  std::vector<Material> materials() const override;
  std::vector<PlacedMesh> shown_meshes() const override;
  std::string left_out_of_one_mesh(const IndexedMesh& mesh) const override;
  std::vector<std::uint8_t> held_borders(const IndexedMesh& mesh, unsigned threads) const override;
  double widest_gap_as_written(const IndexedMesh& mesh) const override;
  double widest_stretch() const override;

  /// Writes the file with its meshes replaced, and the files beside it (`gltf::Asset::files`). Nodes get coarser levels
  /// as levels of detail (`gltf::Asset::add_levels`).
  /// \param mesh the whole, simplified; null: meshes are unchanged
  /// \param levels coarser levels of the whole, or empty
  /// \return a line for each content that changed
  /// \pre `SceneScope::meshes` was read. With levels: there is no `mesh_with_levels`, and nothing was written before
  std::vector<std::string> write(io::OutputFiles& files, const SceneOutput& output, const IndexedMesh* mesh,
                                 CoarserLevels levels);

  /// The mesh after `write` without compression, and `read`. A vertex of several meshes has the position of one of them
  /// in the file. \pre as `write`
  IndexedMesh as_written(IndexedMesh mesh) const;
  /// The scene as `read` shows it of the file that `write` writes. \pre as `write`
  IndexedMesh scene_as_written(const IndexedMesh& mesh, const gltf::WriteOptions& writing,
                               const io::ReadOptions& reading) const;

 private:
  /// A mesh of the file, with triangles.
  struct Part {
    std::size_t mesh;       ///< number in the file
    Eigen::Affine3d place;  ///< from its coordinates to the scene's; of several the first
    Index first_group;      ///< in the whole
    Index n_groups;
    bool has_normals, has_colors;
    std::vector<Attribute> attributes;  ///< without values
    std::size_t first_origin;           ///< least origin of its vertices
    std::vector<Vec3> file_positions;   ///< per vertex of the file, in the mesh's coordinates; empty for a scene

    /// A vertex of another mesh to which a vertex of this mesh was welded.
    struct Welded {
      Index origin;
      Index file_vertex;  ///< vertex of this mesh
      Vec3 position;      ///< in the whole
    };
    std::vector<Welded> welded{};  ///< by origin

    /// The position of a vertex in the file, if it hasn't moved; or null.
    const Vec3* unmoved(Index origin, const Vec3& position) const;
    /// A position of the whole after a round trip through the file.
    Vec3 as_written(Index origin, const Vec3& position) const;
  };

  /// A vertex of the scene, in which meshes may be repeated.
  struct CopiedVertex {
    Index vertex;  ///< in the whole
    Index copy;    ///< number of its place among the places of all meshes
    bool is_of_repeated;
  };

  /// A mesh at one of its places in the whole.
  struct Copy {
    Index first_vertex;
    bool is_flat;  ///< whether its node flattens it
  };

  /// Per face group of the whole: the numbers of its mesh in the file, and of its primitive.
  struct Group {
    std::size_t mesh, primitive;
  };

  std::vector<Group> groups() const;
  std::vector<Eigen::Affine3d> places_of(std::size_t mesh) const;
  Eigen::Affine3d place_of_one(std::span<const Eigen::Affine3d> places, const IndexedMesh& mesh);
  Part part_of(std::size_t number, const Eigen::Affine3d& place, const IndexedMesh& mesh, const IndexedMesh& all) const;
  void read_mesh(std::size_t number, std::vector<Eigen::Affine3d> places, const io::ReadOptions& options,
                 io::ReadResult& all);
  /// Whether the scope leaves out a mesh. \pre the scene shows another one
  bool leaves_out(std::size_t mesh) const;
  void warn_of_left_out(std::span<const std::size_t> meshes, io::ReadResult& result) const;
  double border_tolerance(const IndexedMesh& mesh) const;
  std::vector<Index> copies_of_vertices(std::size_t n_vertices) const;
  void weld_borders(const io::ReadOptions& options, io::ReadResult& all);
  void remember_welded(const std::vector<Index>& origins, const std::vector<Index>& map, const IndexedMesh& mesh);
  IndexedMesh scene_of(const IndexedMesh& mesh, std::vector<CopiedVertex>& copied) const;
  std::vector<IndexedMesh> split(const IndexedMesh& mesh) const;
  void add_levels(CoarserLevels levels, const SceneOutput& output, std::vector<std::string>& warnings);
  std::vector<IndexedMesh> split_for_file(const IndexedMesh& mesh, const std::string& level,
                                          std::vector<std::string>& warnings) const;

  std::filesystem::path path_;
  gltf::Asset asset_;
  SceneScope scope_ = SceneScope::meshes;
  std::vector<Part> parts_;
  Vec3 scene_origin_ = Vec3::Zero();  ///< origin of the whole's coordinates, in the scene
  std::vector<Copy> copies_;          ///< of meshes in the whole
  double reach_ = 0;                  ///< largest distance of a vertex from its mesh's origin, in scene units
};

/// Writes an asset, and the files beside it (`gltf::Asset::files`).
void write_asset(io::OutputFiles& files, const SceneOutput& output, const gltf::Asset& asset);

}  // namespace whittle
