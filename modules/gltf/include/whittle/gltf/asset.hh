#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/material.hh"

// glTF 2.0 (https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html), as text (.gltf) and binary (.glb). An asset is
// read, the triangles of some meshes are replaced, and it is written. All else is written as it was read.

namespace whittle::gltf {

class Poser;

/// Coarser levels of detail of a mesh.
struct MeshLevels {
  std::size_t mesh = 0;                ///< its number
  std::vector<IndexedMesh> coarser{};  ///< as for `Asset::set_triangles`, the finer ones first
  /// The least share of the screen's area, [0, 1], that each level is shown at: that of the mesh itself first, then
  /// one a coarser level. Descending.
  std::vector<double> screen_coverage{};
};

struct WriteOptions {
  /// Whether replaced geometry is compressed by EXT_meshopt_compression and KHR_mesh_quantization, which readers of the
  /// file then need. Positions get a step of at most 1/65536 of the mesh's longest side; normals 8 bits; weights, and
  /// texture coordinates in [0, 1], 16 bits.
  bool compress = false;
};

/// A file of text, and the file with its buffer that lies beside it.
struct GltfText {
  std::string json;
  std::string buffer;      ///< empty if there is none, or if the text contains it
  std::string buffer_uri;  ///< what the text calls it
};

/// A file to be written.
struct AssetFile {
  std::filesystem::path path;
  std::string bytes;
};

/// A glTF asset: its document, its buffers, and the triangles that replace those of its meshes.
///
/// Errors in a file are `io::ReadError`s of one line. `read` finds all that are in the document, `triangles` those in
/// the numbers of a mesh. Meshes are numbered as in the document.
class Asset {
 public:
  /// Reads a file and the buffers that it names. \throw io::ReadError
  static Asset read(const std::filesystem::path& path);
  /// Likewise from memory. \param name of the file, for messages. \param folder where files lie that the asset names;
  /// if empty, an asset that needs such a file is refused
  static Asset read(std::string bytes, const std::string& name, const std::filesystem::path& folder = {});

  Asset(Asset&& other) noexcept;
  Asset& operator=(Asset&& other) noexcept;
  ~Asset();

  std::size_t n_meshes() const;
  /// The name, or "mesh N" if there is none. One line of printable characters.
  std::string mesh_name(std::size_t mesh) const;
  /// Of all primitives that are triangles, strips or fans, as `triangles` would give them.
  std::size_t n_triangles(std::size_t mesh) const;
  /// How often the scene shows the mesh. With EXT_mesh_gpu_instancing a node does so once an instance. The scene is
  /// the document's `scene`, else its first one, else all nodes. Levels of detail (MSFT_lod) and nodes that
  /// KHR_node_visibility hides aren't shown.
  std::size_t n_instances(std::size_t mesh) const;
  /// Whether the mesh is there for levels of detail alone: such nodes have it, and none that is shown.
  bool is_level(std::size_t mesh) const;
  /// The matrix from the mesh's coordinates into the scene's, for each instance shown. Where a skin moves the mesh,
  /// that of its first joint, which is that of all joints as long as nothing is bent; skins don't count if one is
  /// wrong.
  std::vector<Eigen::Matrix4d> world_transforms(std::size_t mesh) const;

  /// All triangles of a mesh, from all its primitives that are triangles, strips or fans and have positions.
  ///
  /// Each vertex of a primitive that a triangle uses is a vertex; none are joined, and there is no table of wedges.
  /// `face_groups` has the number of the primitive, `group_names` the material's name or number for each primitive.
  /// NORMAL, COLOR_0 and POSITION are in their own arrays. `attributes` has the others by their names in the file:
  /// "TEXCOORD_0", "_TEMPERATURE"; and
  /// - "JOINTS_0+WEIGHTS_0": all sets of joints and weights together: 4 joints a set, then the weights;
  /// - "target 0 POSITION": of the first morph target; NORMAL and so on likewise.
  /// Where a primitive has no such attribute, it is zero. Numbers that aren't finite are read as zero, except in
  /// positions. A mesh that was replaced is as it was given.
  /// \throw io::ReadError if an index is above the vertices, a position isn't finite, or compressed data are damaged
  IndexedMesh triangles(std::size_t mesh) const;

  /// Whether the material of a primitive says how it looks. What `make_asset` says of a surface that it knows nothing
  /// of doesn't count: white, without metal.
  bool has_look(std::size_t mesh, std::size_t primitive) const;
  /// How each primitive looks, by mesh and primitive: one without a material has the default one. Meshes without
  /// triangles have none. Images are read, each once; one that isn't there says so (`Image::problem`).
  /// \throw io::ReadError if a material isn't there, or is wrong
  std::vector<std::vector<Material>> materials() const;

  /// Replaces the triangles of a mesh. Lines and points stay.
  ///
  /// `face_groups` says which primitive a face belongs to; it may be empty where only one has triangles. A primitive
  /// that has lost all its triangles is dropped. Each wedge, or vertex, that a primitive's faces have becomes a vertex
  /// of it. A primitive gets those attributes that it had, as far as the mesh has them.
  /// \param triangles with the groups and attribute names that `triangles` gave; the table of wedges is allowed
  /// \throw std::invalid_argument if the mesh would have nothing left, which glTF can't say, or if a group, an index or
  ///        the size of an attribute is wrong
  void set_triangles(std::size_t mesh, IndexedMesh triangles);

  /// Whether nodes that use a mesh have levels of detail (MSFT_lod), or are levels themselves.
  bool has_levels(std::size_t mesh) const;
  /// Gives the nodes of meshes coarser levels of detail, as the extension MSFT_lod has them: a mesh a level, and for
  /// each of the nodes one a level, which looks as it does in all else, and is moved by the same animations. Readers
  /// that don't know the extension show the mesh itself. Numbers of meshes and nodes stay; new ones come after them.
  /// \throw std::invalid_argument as `set_triangles`; if a mesh `has_levels` or stands there twice, or if there aren't
  ///        as many shares as levels with the mesh itself
  void add_levels(std::vector<MeshLevels> levels);

  /// What it has beside nodes, materials and triangles, in words: some of "lines", "points", "animations", "skins",
  /// "cameras" and "lights".
  std::vector<std::string> other_content() const;

  /// What isn't kept as it was, a line each: extensions of meshes that say something of single vertices.
  std::vector<std::string> warnings() const;

  /// Image files that the asset names, each once, relative to its folder.
  std::vector<std::filesystem::path> image_files() const;
  /// Likewise files with its numbers.
  std::vector<std::filesystem::path> buffer_files() const;

  /// The document as it was read.
  std::string document() const;

  /// What `write` writes, the asset itself first: .gltf as text, all else as GLB. In text the buffer is part of it if
  /// the input's was; otherwise it lies beside it, with the same name and .bin. Images that lie in files are copied
  /// into the folder of the output, or below it, unless they are there.
  /// \throw io::ReadError if an image can't be read
  std::vector<AssetFile> files(const std::filesystem::path& path, const WriteOptions& options = {}) const;
  /// Writes these files, and makes the folders of images. \throw io::WriteError
  void write(const std::filesystem::path& path, const WriteOptions& options = {}) const;
  /// The bytes of a .glb. \throw std::length_error for more than 4 GiB
  std::string write_glb(const WriteOptions& options = {}) const;
  /// The text of a .gltf. \param buffer_uri names the buffer, unless the input's was part of the text
  GltfText write_gltf(const std::string& buffer_uri, const WriteOptions& options = {}) const;

 private:
  friend class Poser;
  struct Content;
  explicit Asset(std::unique_ptr<Content> content);

  std::unique_ptr<Content> content_;
};

/// Whether bytes begin as a GLB does, or a name ends as one of a glTF file does.
bool is_glb(std::string_view bytes);
bool has_gltf_extension(const std::filesystem::path& path);

}  // namespace whittle::gltf
