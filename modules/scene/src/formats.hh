#pragma once

#include "whittle/scene/format.hh"

namespace whittle {

/// The row of each format that isn't one of `io`.
extern const SceneFormat gltf_format;

/// A row for a format of `io`.
SceneFormat format_with_one_mesh(io::Format format);

}  // namespace whittle
