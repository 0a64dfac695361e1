#pragma once

#include <span>

#include "whittle/engine/run_steps.hh"

namespace whittle {

/// The vertices of a surface that lie elsewhere after polish, to the bit.
/// \param vertices of the surface → of the input
std::vector<PassEnd::MovedVertex> moved_vertices(std::span<const Vec3> before, std::span<const Vec3> after,
                                                 std::span<const Index> vertices);

/// The faces of a surface that have other corners after polish.
/// \param vertices, face_origins of the surface → of the input
std::vector<PassEnd::TurnedFace> turned_faces(std::span<const Triangle> before, std::span<const Triangle> after,
                                              std::span<const Index> vertices, std::span<const Index> face_origins);

}  // namespace whittle
