#pragma once

#include <array>
#include <string>
#include <vector>

#include "obj/obj_chunk.hh"

namespace whittle::io {

/// The materials, groups, objects and smoothing groups of all faces of an OBJ file.
class ObjTags {
 public:
  /// Adds the tags of the next part of the file. \param n_faces_before triangles in the parts before it
  void add(const ObjChunk& chunk, std::size_t n_faces_before);

  /// Materials become groups of the mesh. Groups, objects and smoothing groups become face attributes, if there is more
  /// than one. \param builder has all triangles
  void give_to(MeshBuilder& builder) const;

 private:
  std::vector<ObjSwitch> switches_;
  std::vector<std::string> libraries_;
};

/// The names of the face attributes.
inline constexpr const char* obj_group = "g";
inline constexpr const char* obj_object = "o";
inline constexpr const char* obj_smoothing = "s";

}  // namespace whittle::io
