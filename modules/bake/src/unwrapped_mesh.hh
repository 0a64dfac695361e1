#pragma once

#include "whittle/bake/unwrap.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::bake {

/// The mesh with the texture coordinates of its charts, TEXCOORD_0, in place of its attributes. Normals stay; where
/// there are none, they are those of vertices. \param has_tangents whether to add TANGENT, along the image's rows
IndexedMesh unwrapped_mesh(IndexedMesh mesh, const Unwrapping& layout, bool has_tangents);

}  // namespace whittle::bake
