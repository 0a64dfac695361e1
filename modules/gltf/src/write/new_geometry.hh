#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "document/json.hh"
#include "encode/encode.hh"
#include "model/model.hh"
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
  std::optional<std::size_t> skin{};  ///< of no primitive, but of this skin: these are its inverse bind matrices
  bool has_bytes = true;              ///< false if all are zero, and the replaced accessor had no bytes
};

/// Removes the triangles of replaced meshes from a document: accessors of primitives, their compression, and extensions
/// with data about single vertices. Primitives without triangles left stay, without geometry.
void strip_geometry(Json& document, const Model& model, const Replacements& replacements);

/// The new accessors of primitives. \param packing of a mesh, by its number
std::vector<NewAccessor> new_accessors(const Model& model, const Replacements& replacements,
                                       const std::function<Packing(std::size_t)>& packing);

/// Where a document names a new accessor.
Json& place_in(Json& document, const NewAccessor& accessor);

/// Drops the primitives that have lost all triangles. Numbers of the others change.
void drop_lost_primitives(Json& document, const Model& model, const Replacements& replacements);

}  // namespace whittle::gltf
