#pragma once

#include <string>
#include <whittle/core/indexed_mesh.hh>

#include "fuzz/decode/byte_source.hh"

namespace whittle::test {

/// A small triangle set, at most some sixty faces. Any bytes give one: a list of vertices and faces, or one or two of
/// the shapes of `shapes.hh`. Then come edits that damage it, such as faces turned over or doubled and vertices made
/// one, a transformation, and attributes. Face numbers are in range; coordinates may be anything.
IndexedMesh decode_mesh(ByteSource& source);

/// The number of shapes that the first byte chooses from; the byte 0 stands for a list.
unsigned n_mesh_kinds();

/// Moves what is not finite or out of range to the origin.
void make_finite(IndexedMesh& mesh);

/// Whether coordinates along an axis, where they differ from each other or from 0, differ by at least 1e-30 of the
/// mesh's extent. Among sizes that are farther apart, products underflow: measurements of faces are not promised there.
bool has_ordinary_sizes(const IndexedMesh& mesh);

/// The mesh in OFF, with all digits: for messages.
std::string text_of(const IndexedMesh& mesh);

}  // namespace whittle::test
