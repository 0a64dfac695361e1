#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "document/json.hh"
#include "model/scalars.hh"

// The geometry of a document as plain structs. All references are checked: numbers are below the counts, ranges of
// bytes are inside of their buffers.

namespace whittle::gltf {

/// Largest coordinate of positions: squares of lengths must be finite (`IndexedMesh::positions`).
inline constexpr double largest_coordinate = 0x1p500;

struct Buffer {
  std::size_t size = 0;                   ///< as the document says
  std::optional<std::string_view> bytes;  ///< `size`; none in a placeholder for compressed data
  bool is_in_document = false;            ///< as a data URI
};

/// Bytes of a view once they are decompressed; none if it only stands for data that this program doesn't need.
struct BufferView {
  std::string_view bytes;
  std::optional<std::size_t> stride;
};

/// Values that replace some of an accessor's.
struct SparseValues {
  std::size_t count = 0;
  std::string_view indices;
  ScalarType index_type = ScalarType::uint32;
  std::string_view values;  ///< packed
};

struct Accessor {
  ScalarType type = ScalarType::float32;
  bool is_normalized = false;
  ElementShape shape;
  std::size_t count = 0;
  std::string_view bytes;  ///< from the first element on; empty: all are zero
  std::size_t stride = 0;
  std::optional<std::size_t> view;
  std::optional<SparseValues> sparse;
};

using NamedNumbers = std::vector<std::pair<std::string, std::size_t>>;

/// Compressed triangles of a primitive (KHR_draco_mesh_compression).
struct DracoData {
  std::size_t view = 0;
  NamedNumbers attributes;  ///< names and Draco's unique ids
};

enum class PrimitiveMode : std::uint8_t { points, lines, line_loop, line_strip, triangles, strip, fan };

struct Primitive {
  PrimitiveMode mode = PrimitiveMode::triangles;
  NamedNumbers attributes;              ///< names and accessors
  std::vector<NamedNumbers> targets;    ///< per morph target
  std::optional<std::size_t> indices;   ///< an accessor
  std::optional<std::size_t> material;  ///< not checked
  std::optional<DracoData> draco;

  std::optional<std::size_t> attribute(std::string_view name) const;
  /// Whether it has triangles that can be replaced: positions, and a mode that makes faces of them.
  bool is_surface() const;
};

struct Mesh {
  std::vector<Primitive> primitives;
};

/// A translation, a rotation (x, y, z, w) and a scale, as nodes and instances have them.
struct Transform {
  std::array<double, 3> translation{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 0, 1};
  std::array<double, 3> scale{1, 1, 1};

  Eigen::Matrix4d matrix() const;
};

struct Node {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();  ///< to the parent's coordinates
  std::optional<Transform> transform;                    ///< parts of `matrix`; none if the document has the matrix
  std::optional<std::size_t> parent;
  std::optional<std::size_t> mesh;
  bool is_shown = false;   ///< part of the scene that viewers show first, not hidden, and no level
  bool is_level = false;   ///< a level of detail of another node (MSFT_lod), or below one
  NamedNumbers instances;  ///< of EXT_mesh_gpu_instancing: names and accessors; empty: one
};

struct Model {
  std::string file;                 ///< its name, for messages
  std::size_t n_bytes = 0;          ///< of the file and all buffers
  std::deque<std::string> decoded;  ///< bytes that the others point into
  std::vector<Buffer> buffers;
  std::vector<BufferView> views;
  std::vector<Accessor> accessors;
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
};

/// \throw io::ReadError
[[noreturn]] void fail_in_primitive(const Model& model, std::size_t mesh, std::size_t primitive,
                                    const std::string& problem);

/// Number of triangles of `n_corners` corners.
std::size_t n_triangles_of(PrimitiveMode mode, std::size_t n_corners);

}  // namespace whittle::gltf
