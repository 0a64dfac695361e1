#pragma once

#include <filesystem>

namespace whittle::gltf {

/// How `Asset` is written. The first three options are about replaced geometry, and round it.
struct WriteOptions {
  /// Whether to compress it by EXT_meshopt_compression and KHR_mesh_quantization, which readers of the file then
  /// require. Positions get a step of at most 1/65536 of the mesh's longest side; normals 8 bits; weights, and texture
  /// coordinates in [0, 1], 16 bits.
  bool compress = false;
  /// Whether to write small integers instead of real numbers (KHR_mesh_quantization, which readers then require), also
  /// in compressed geometry. Positions and their morph targets get 16 bits, with a step of at most 1/32767 of the
  /// longest side of the mesh, or of all meshes with its skin, or of a morph target; normals, tangents, colours and
  /// weights 8 bits; joints 8 if they fit; texture coordinates in [-1, 1] 16 bits. A mesh gets a node of its own for
  /// the scale, or its skin has it. `Asset::warnings` names meshes where that isn't possible.
  bool quantize = false;

  /// Whether primitives with the same material and the same attributes become one: those of a mesh, and those of meshes
  /// in different nodes that nothing moves, where no picture changes by it. The first mesh gets the triangles of the
  /// others. Emptied meshes are dropped; nodes stay. Not merged are blended materials, primitives with extras or
  /// extensions; and in different nodes meshes with several nodes, skins, morph targets, extras, or a thickness of the
  /// material, and nodes with extensions, extras, animations, or below such.
  bool merge = false;

  /// A file for what outputs with other geometry of the same meshes have, too: in a .gltf, all bytes but those of
  /// replaced geometry, and images that are part of the text, in the input or here. It is in the folder of the output,
  /// which then embeds no buffer. Empty: each output has all bytes.
  std::filesystem::path shared_buffer{};

  bool rounds() const { return compress || quantize || merge; }
};

}  // namespace whittle::gltf
