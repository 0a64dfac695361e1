#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/write.hh"

namespace whittle::io {

/// A scalar property that is written: where its numbers lie, and how they are stored.
struct PlyColumn {
  std::string name;
  ScalarType type = ScalarType::float32;
  const double* doubles = nullptr;  ///< one of both
  const float* floats = nullptr;
  std::size_t stride = 1;
  std::size_t n_components = 1;  ///< more in `runs_of`
  bool is_normalized = false;    ///< integers stand for [0, 1] or [-1, 1]
};

/// "uchar": the name of a type in headers.
std::string_view ply_name_of(ScalarType type);

/// The value as an integer of this type: rounded, and clamped to its range. NaN becomes 0.
double to_integer(double value, ScalarType type, bool is_normalized);

/// The properties of vertices, in the order of the notes. \param mesh without wedges; it has to outlive the columns
std::vector<PlyColumn> vertex_columns(const IndexedMesh& mesh, const WriteOptions& options);

/// Likewise of faces, all but lists.
std::vector<PlyColumn> columns_of(const std::vector<Attribute>& attributes);

/// Columns whose numbers lie one after the other, as one each: these are written faster.
std::vector<PlyColumn> runs_of(const std::vector<PlyColumn>& columns);

}  // namespace whittle::io
