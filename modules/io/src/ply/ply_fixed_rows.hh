#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "format/mesh_builder.hh"
#include "ply/ply_header.hh"
#include "ply/ply_plan.hh"

// Vertices and faces of binary files whose rows all have their numbers at the same places. They are read property by
// property, not row by row.

namespace whittle::io {

/// Rows one after the other.
struct PlyRows {
  const char* first;
  std::size_t size;  ///< bytes of a row
  std::endian order;

  PlyRows from(std::size_t row) const { return {first + row * size, size, order}; }
};

/// Where the numbers of a property are stored: every `stride` numbers, from `values` on. Null: nowhere.
struct PlyTarget {
  double* values = nullptr;
  std::size_t stride = 1;
  double unit = 1;

  void set(std::size_t i, double number) const { values[i * stride] = number / unit; }
};

/// Of each property. \param attributes those planned, with values
std::vector<PlyTarget> targets_of(const PlyAttributes& planned, std::vector<Attribute>& attributes);

/// Reads vertices begin … end. \param rows of all \param builder with places for them \pre no property is a list
/// \return whether all coordinates are finite
bool read_vertex_rows(const PlyRows& rows, const PlyElement& element, const PlyVertexPlan& plan,
                      const std::vector<PlyTarget>& targets, std::size_t begin, std::size_t end, MeshBuilder& builder);

struct PlyTriangles {
  std::vector<Triangle> faces;
  std::vector<double> texcoords;  ///< 6 per face, or none
};

/// Reads faces begin … end. \param rows of all \param targets of the first face \param read with places for them
/// \return false if one isn't a triangle, lacks texture coordinates, or has a corner that is no vertex
bool read_triangle_rows(const PlyRows& rows, const PlyElement& element, const PlyFacePlan& plan,
                        const std::vector<PlyTarget>& targets, std::uint64_t n_vertices, std::size_t begin,
                        std::size_t end, PlyTriangles& read);

}  // namespace whittle::io
