#pragma once

#include "bytes/byte_sink.hh"
#include "ply/ply_header.hh"
#include "whittle/io/read.hh"

// Content of a PLY header beside the mesh. Comments hold data that PLY has no place for:
//   comment mtllib LIBRARY            the material libraries of an OBJ file
//   comment name PROPERTY VALUE NAME  the name of a value of a face property, values from 0

namespace whittle::io {

/// The face property with the groups of a mesh. Its values have names.
inline constexpr const char* group_property = "group";

/// Takes notes of the header. The face property `group` becomes the groups of the mesh if its values have names.
void take_ply_notes(const PlyHeader& header, ReadResult& result);

/// Writes the comments.
void write_ply_notes(ByteSink& sink, const IndexedMesh& mesh, const FileNotes& notes);

}  // namespace whittle::io
