#pragma once

#include "whittle/gltf/asset.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

/// The document of a scene that was read from glTF, for what glTF alone has: skins, morph targets, animations.
/// \throw UnsupportedMesh for another format
const gltf::Asset& gltf_asset_of(const Scene& scene);

}  // namespace whittle
