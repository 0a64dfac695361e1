#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "document/json.hh"
#include "model/model.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/gltf/write_options.hh"

namespace whittle::gltf {

/// The meshes whose triangles are replaced.
using Replacements = std::map<std::size_t, IndexedMesh>;

/// A document, and the bytes of its first buffer. That buffer's URI isn't set. There is none if it has no bytes.
struct Output {
  Json document;
  std::string buffer;
  std::size_t n_kept_bytes = 0;  ///< at the beginning of the buffer, which don't belong to replaced geometry
};

/// \pre the replacements were checked, and this build can compress if that is asked for
Output make_output(const Model& model, const Json& document, const Replacements& replacements,
                   const WriteOptions& options);

}  // namespace whittle::gltf
