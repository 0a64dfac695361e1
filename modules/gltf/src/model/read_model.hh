#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "document/json.hh"
#include "model/model.hh"

namespace whittle::gltf {

/// The parts of a file.
struct Source {
  std::string file;                       ///< its name, for messages
  std::optional<std::string_view> chunk;  ///< the bytes of the first buffer, in a GLB
  std::filesystem::path folder;           ///< of files that the document names; may be empty
};

/// Checks all that a document says of geometry and nodes, reads its buffers, and decompresses views. It may point into
/// the source's bytes. \throw io::ReadError
Model read_model(const Json& document, const Source& source);

/// The bytes that a URI of `part` names. \throw io::ReadError
std::string bytes_of_uri(const Part& part, const std::string& uri, const Source& source);

// Parts of `read_model`, in this order.

void read_buffers(Model& model, const Part& root, const Source& source);
void read_views(Model& model, const Part& root);
void read_accessors(Model& model, const Part& root);
void read_meshes(Model& model, const Part& root);
void read_nodes(Model& model, const Part& root);
/// Finds the nodes that are shown, and levels of detail.
void read_scene(Model& model, const Part& root);

}  // namespace whittle::gltf
