#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ply/ply_header.hh"
#include "whittle/core/attribute.hh"
#include "whittle/io/read.hh"

// The use of each property of a PLY file.

namespace whittle::io {

/// The meaning of a vertex property.
enum PlyRole : std::size_t { x, y, z, nx, ny, nz, red, green, blue, alpha, tolerance, other };

/// \return `other` for a list
PlyRole role_of(const PlyProperty& property);

/// The name that a property of this role is written with; its own for others.
std::string written_name(const PlyProperty& property);

/// Gives properties of vertices the names that have a role in lower case: "X" becomes "x", "Red" "red". Names that two
/// properties would have stay.
void lower_known_names(std::vector<PlyProperty>& properties);

/// Where the numbers of a property go.
struct PlyPlace {
  std::size_t attribute = 0;
  std::size_t component = 0;
  double unit = 1;  ///< The value is the number over this.
};

/// Some properties as attributes.
struct PlyAttributes {
  std::vector<Attribute> attributes;            ///< without values
  std::vector<std::optional<PlyPlace>> places;  ///< of each property
};

struct PlyVertexPlan {
  std::vector<PlyRole> roles;                  ///< of each property
  std::array<bool, PlyRole::other + 1> has{};  ///< whether some property has the role
  bool normals = false;
  bool colors = false;
  std::array<double, 4> color_units{1, 1, 1, 1};  ///< the numbers that mean full intensity
  PlyType color_type = PlyType::uint8;            ///< to write colours in
  PlyAttributes others;
  std::string lost;  ///< names of lost properties
};

struct PlyFacePlan {
  std::optional<std::size_t> corners;    ///< the property with the numbers of vertices
  std::optional<std::size_t> texcoords;  ///< the property with texture coordinates of corners
  PlyAttributes others;
  std::string lost;
};

PlyVertexPlan plan_vertices(const PlyElement& element, AttributeScope scope);

/// \param scope `per_vertex` if only corners are to be carried
PlyFacePlan plan_faces(const PlyElement& element, AttributeScope scope);

/// The names of the components of an attribute, as properties.
/// \param n_before number of texture coordinates before it
std::vector<std::string> property_names(const Attribute& attribute, std::size_t n_before);

}  // namespace whittle::io
