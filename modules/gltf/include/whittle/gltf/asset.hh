#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/material.hh"
#include "whittle/gltf/write_options.hh"

// glTF 2.0 (https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html), as text (.gltf) and binary (.glb). An asset is
// read, the triangles of some meshes are replaced, and it is written. All else is written as it was read.

namespace whittle::gltf {

class Poser;

/// Coarser levels of detail of a mesh.
struct MeshLevels {
  std::size_t mesh = 0;                ///< its number in the document
  std::vector<IndexedMesh> coarser{};  ///< as for `Asset::set_triangles`, finest first
  /// The least share of the screen's area, [0, 1], at which each level is shown: first of the mesh itself, then of each
  /// coarser level. Descending.
  std::vector<double> screen_coverage{};
};

/// A .gltf file, and the file with its buffer.
struct GltfText {
  std::string json;
  std::string buffer;      ///< empty if there is none, or if the text contains it
  std::string buffer_uri;  ///< the buffer's name in the text
  std::string shared;      ///< the buffer of `WriteOptions::shared_buffer`; empty if there is none
};

/// A file to write.
struct AssetFile {
  std::filesystem::path path;
  std::string bytes;
};

/// A glTF asset: document, buffers, and replaced triangles of its meshes.
///
/// Errors in a file are `io::ReadError`s of one line. `read` finds errors in the document, `triangles` errors in the
/// numbers of a mesh. Meshes are numbered as in the document.
class Asset {
 public:
  /// Reads a file and the buffers that it names. \throw io::ReadError
  static Asset read(const std::filesystem::path& path);
  /// The same from memory.
  /// \param name of the file, for messages
  /// \param folder with the files that the asset names; if empty, an asset that needs files is refused
  static Asset read(std::string bytes, const std::string& name, const std::filesystem::path& folder = {});

  Asset(Asset&& other) noexcept;
  Asset& operator=(Asset&& other) noexcept;
  ~Asset();

  std::size_t n_meshes() const;
  /// The name, or "mesh N". One line of printable characters.
  std::string mesh_name(std::size_t mesh) const;
  /// Number of faces of `triangles(mesh)`.
  std::size_t n_triangles(std::size_t mesh) const;
  /// Number of times that the scene shows the mesh. With EXT_mesh_gpu_instancing a node shows it once per instance. The
  /// scene is the document's `scene`, else its first one, else all nodes. Levels of detail (MSFT_lod) and nodes hidden
  /// by KHR_node_visibility aren't shown.
  std::size_t n_instances(std::size_t mesh) const;
  /// Whether only levels of detail use the mesh, and no shown node.
  bool is_level(std::size_t mesh) const;
  /// Per shown instance, the matrix from the mesh's coordinates into the scene's. If a skin moves the mesh, the matrix
  /// of its first joint, which all joints share in the bind pose; skins don't count if one is invalid.
  std::vector<Eigen::Matrix4d> world_transforms(std::size_t mesh) const;

  /// All triangles of a mesh, from all its primitives that are triangles, strips or fans and have positions.
  ///
  /// Each used vertex of a primitive is a vertex; vertices aren't joined, and there is no table of wedges.
  /// `face_groups` has the number of the primitive, `group_names` the material's name or number for each primitive.
  /// NORMAL, COLOR_0 and POSITION are in their own arrays. `attributes` has the other attributes by their names in the
  /// file: "TEXCOORD_0", "_TEMPERATURE"; and
  /// - "JOINTS_0+WEIGHTS_0": all sets of joints and weights together: 4 joints a set, then the weights;
  /// - "target 0 POSITION": of the first morph target; the same for NORMAL and so on.
  /// An attribute that a primitive lacks is zero there. Numbers that aren't finite are read as zero, except in
  /// positions. Of a replaced mesh the new triangles are returned.
  /// \throw io::ReadError if an index is above the vertices, a position isn't finite, or compressed data are damaged
  IndexedMesh triangles(std::size_t mesh) const;

  /// Whether a primitive has a material, other than the default of `make_asset`: white, without metal.
  bool has_look(std::size_t mesh, std::size_t primitive) const;
  /// The material of each primitive, by mesh and primitive, or the default material. Meshes without triangles have
  /// none. Images are read, each once; a missing one has a `Image::problem`.
  /// \throw io::ReadError if a material is missing or invalid
  std::vector<std::vector<Material>> materials() const;

  /// Replaces the triangles of a mesh. Lines and points stay.
  ///
  /// `face_groups` gives the primitive of a face; it may be empty if only one has triangles. A primitive without
  /// triangles left is dropped. Each wedge, or vertex, of a primitive's faces becomes a vertex of it. A primitive keeps
  /// its attributes if the mesh has them.
  /// \param triangles with groups and attribute names as from `triangles`; may have a table of wedges
  /// \throw std::invalid_argument if the mesh would be empty, which glTF can't express, or if a group, an index or the
  ///        size of an attribute is wrong
  void set_triangles(std::size_t mesh, IndexedMesh triangles);

  /// Whether nodes that use a mesh have levels of detail (MSFT_lod), or are levels themselves.
  bool has_levels(std::size_t mesh) const;
  /// Gives the nodes of meshes coarser levels of detail, by the extension MSFT_lod. Each level adds a mesh, and a node
  /// per node of the mesh, equal in all else, and moved by the same animations. Readers without the extension show the
  /// mesh itself. Numbers of meshes and nodes stay; new ones come after them.
  /// \throw std::invalid_argument as `set_triangles`; if a mesh `has_levels` or is repeated, or if the number of shares
  ///        isn't the number of levels plus 1
  void add_levels(std::vector<MeshLevels> levels);

  /// Names of content beside nodes, materials and triangles: some of "lines", "points", "animations", "skins",
  /// "cameras" and "lights".
  std::vector<std::string> other_content() const;

  /// Content that isn't kept, a line each: extensions of meshes with data about single vertices. And positions that
  /// `WriteOptions::quantize` doesn't make integers.
  std::vector<std::string> warnings(const WriteOptions& options = {}) const;

  /// Image files that the asset names, each once, relative to its folder.
  std::vector<std::filesystem::path> image_files() const;
  /// Buffer files that the asset names, each once, relative to its folder.
  std::vector<std::filesystem::path> buffer_files() const;

  /// The document as it was read.
  std::string document() const;

  /// The files that `write` writes, the asset itself first: .gltf as text, others as GLB. In text the buffer is
  /// embedded if the input's was; otherwise it is a file with the same name and .bin. The shared buffer follows. Image
  /// files are copied into the folder of the output, or below it, unless they exist there. \throw io::ReadError if an
  /// image can't be read
  std::vector<AssetFile> files(const std::filesystem::path& path, const WriteOptions& options = {}) const;
  /// Writes these files, and makes the folders of images. \throw io::WriteError
  void write(const std::filesystem::path& path, const WriteOptions& options = {}) const;
  /// The bytes of a .glb. \throw std::length_error for more than 4 GiB
  std::string write_glb(const WriteOptions& options = {}) const;
  /// The asset as it is read again from what is written with these triangles by mesh, which are as for `set_triangles`.
  /// Images beside it are missing. \throw as `set_triangles` and `write_glb`
  Asset as_written(std::map<std::size_t, IndexedMesh> triangles, const WriteOptions& options = {}) const;
  /// The text of a .gltf. \param buffer_uri names the buffer, unless the input's was part of the text and nothing is
  /// shared
  GltfText write_gltf(const std::string& buffer_uri, const WriteOptions& options = {}) const;

 private:
  friend class Poser;
  struct Content;
  explicit Asset(std::unique_ptr<Content> content);

  std::unique_ptr<Content> content_;
};

/// Whether bytes begin with GLB's signature.
bool is_glb(std::string_view bytes);

}  // namespace whittle::gltf
