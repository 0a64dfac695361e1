#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "document/json.hh"
#include "model/model.hh"
#include "write/encode.hh"
#include "write/output.hh"

namespace whittle::gltf {

/// An accessor of new geometry, and where the document names it.
struct NewAccessor {
  std::size_t mesh = 0;
  std::size_t primitive = 0;
  std::string name;                   ///< of the attribute; empty: these are the indices
  std::optional<std::size_t> target;  ///< the morph target that it is of
  std::optional<std::size_t> old;     ///< the accessor that it replaces
  Encoded values;
  bool has_bytes = true;  ///< none if all are zero, and those that it replaces had none
};

/// Takes the triangles of replaced meshes out of a document: all that primitives say of accessors, their compression,
/// and what extensions say of single vertices. Primitives that lose all triangles stay, without geometry.
void strip_geometry(Json& document, const Model& model, const Replacements& replacements);

/// What primitives get instead.
std::vector<NewAccessor> new_accessors(const Model& model, const Replacements& replacements, bool compress);

/// Where a document names a new accessor.
Json& place_in(Json& document, const NewAccessor& accessor);

/// Drops the primitives that have lost all triangles. Numbers of the others change.
void drop_lost_primitives(Json& document, const Model& model, const Replacements& replacements);

}  // namespace whittle::gltf
