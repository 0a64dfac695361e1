#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "files/output.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/read.hh"

namespace whittle::app {

/// A glTF file as one mesh, and back. Each of its meshes is a part of that mesh, or several; no two have a vertex in
/// common. So one run simplifies all of them, and each gets the faces that its shape needs.
///
/// A part is as large as in the scene, up to a power of two, which changes no digits; where a mesh is used several
/// times, as large as at most. It lies where the mesh has it, not where the scene puts it.
class GltfFile {
 public:
  /// \throw io::ReadError
  explicit GltfFile(const std::filesystem::path& path);

  /// Reads all meshes that have triangles. There may be none: then the whole has no faces, `why_no_faces` says why, and
  /// `write` writes the file as it was.
  io::ReadResult read(const io::ReadOptions& options);

  const gltf::Asset& asset() const { return asset_; }

  /// Those with triangles. \pre `read`
  std::size_t n_meshes() const { return parts_.size(); }
  /// \param mesh below `n_meshes`
  std::string mesh_name(std::size_t mesh) const { return asset_.mesh_name(parts_[mesh].mesh); }

  /// For each face of the whole, or of what has become of it, the mesh that it belongs to, below `n_meshes`.
  std::vector<Index> meshes_of_faces(const IndexedMesh& mesh) const;

  /// For each group of faces of what was read: the number of its mesh in the file, and of its primitive. \pre `read`
  struct Group {
    std::size_t mesh, primitive;
    double scale;  ///< from the mesh's coordinates to those of the whole
  };
  std::vector<Group> groups() const;

  /// Writes the file with its meshes replaced, and the files that lie beside it (`gltf::Asset::files`).
  /// \param mesh what `read` gave, simplified \param compress as `gltf::WriteOptions` has it
  /// \return a line for each thing that isn't as it was
  std::vector<std::string> write(OutputFiles& files, const std::string& path, const IndexedMesh& mesh, bool compress);

 private:
  /// A mesh of the file that has triangles.
  struct Part {
    std::size_t mesh;   ///< its number in the file
    double scale;       ///< from its coordinates to those of the whole
    Index first_group;  ///< in the whole
    Index n_groups;
    bool has_normals, has_colors;
    std::vector<Attribute> attributes;  ///< without values
  };

  double scale_of(std::size_t mesh) const;
  void append(std::size_t number, IndexedMesh mesh, IndexedMesh& all);
  std::vector<IndexedMesh> split(const IndexedMesh& mesh) const;

  std::filesystem::path path_;
  gltf::Asset asset_;
  std::vector<Part> parts_;
};

/// Why nothing is left of what was read from a glTF file: "there are no triangles in it". \pre it has no faces
std::string why_no_faces(const io::ReadResult& read);

/// Writes an asset, and the files that lie beside it (`gltf::Asset::files`).
void write_asset(OutputFiles& files, const std::string& path, const gltf::Asset& asset, bool compress);

/// Turns textures upside down: in glTF the second texture coordinate grows downwards, in all other formats upwards.
void flip_texcoords(IndexedMesh& mesh);

/// Whether a file name ends in .gltf or .glb.
bool is_gltf(const std::string& path);

}  // namespace whittle::app
