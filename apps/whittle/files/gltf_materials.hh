#pragma once

#include "whittle/gltf/material.hh"

namespace whittle::app {

/// What glTF says of a texture, in the words of who shows it. \tparam Wrap has the enumerators of `gltf::Wrap`
template <class Wrap>
Wrap wrap_as(gltf::Wrap wrap) {
  switch (wrap) {
    case gltf::Wrap::mirrored_repeat:
      return Wrap::mirrored_repeat;
    case gltf::Wrap::clamp_to_edge:
      return Wrap::clamp_to_edge;
    case gltf::Wrap::repeat:
      break;
  }
  return Wrap::repeat;
}

/// \tparam Alpha has the enumerators of `gltf::AlphaMode`
template <class Alpha>
Alpha alpha_as(gltf::AlphaMode mode) {
  switch (mode) {
    case gltf::AlphaMode::mask:
      return Alpha::mask;
    case gltf::AlphaMode::blend:
      return Alpha::blend;
    case gltf::AlphaMode::opaque:
      break;
  }
  return Alpha::opaque;
}

}  // namespace whittle::app
