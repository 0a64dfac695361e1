#pragma once

#include <string>

#include "write/output.hh"

namespace whittle::gltf {

/// Moves what outputs with other geometry of the same meshes have, too, out of an output: the bytes that don't belong
/// to replaced geometry, and images that are part of the text. They become the document's last buffer. \param uri of
/// that buffer \return its bytes; empty if there is nothing to share, and then nothing changes
std::string take_shared_buffer(Output& output, const std::string& uri);

}  // namespace whittle::gltf
