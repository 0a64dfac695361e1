#pragma once

#include <cstddef>
#include <string>

#include "document/json.hh"
#include "model/model.hh"

namespace whittle::gltf {

/// The first buffer of an output, and the one that stands for its compressed parts, which has no bytes.
struct PackedBuffers {
  std::string bytes;
  std::size_t n_fallback_bytes = 0;
};

inline constexpr std::size_t first_buffer = 0;
inline constexpr std::size_t fallback_buffer = 1;

/// Gathers all used bytes of a document in one buffer, and updates the references. Distances within a view stay, and so
/// do offsets modulo 8. The document still lists its old buffers.
PackedBuffers pack_buffers(Json& document, const Model& model);

/// Lists the buffers in a document. \param with_fallback whether views are compressed
void list_buffers(Json& document, const Model& model, const PackedBuffers& packed);

}  // namespace whittle::gltf
