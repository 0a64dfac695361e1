#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::bench {

/// Distances between a surface and triangles.
struct Errors {
  double mean = 0;
  double rms = 0;
  double max = 0;
};

/// A smooth closed surface that is known exactly.
struct SmoothSurface {
  std::string name;
  /// A point of the surface; the point is the outer one of two where that is not unique. \param u, v in [0, 1]
  std::function<Vec3(double u, double v)> at;
  std::function<double(double u, double v)> curvature;   ///< Gaussian, there
  std::function<double(const Vec3& point)> distance;     ///< of any point near the surface from it
  std::function<IndexedMesh(std::size_t n_faces)> mesh;  ///< about so many faces of even size, vertices on the surface
};

/// A sphere, an ellipsoid of axes 3 : 2 : 1, and tori whose tubes have half and a quarter of their radius.
std::vector<SmoothSurface> smooth_surfaces();

/// N times the least errors that N triangles can have, for many triangles: of the best sizes and shapes, with vertices
/// that may leave the surface. By the integrals of a power of the Gaussian curvature: Gruber 1993 and Fejes Tóth 1953
/// for elliptic points, Pottmann et al. 2000 and Atariah, Rote & Wintraecken 2018 for hyperbolic ones.
Errors least_errors(const SmoothSurface& surface);

/// The errors of a mesh, at points of its faces, by area; the largest is also looked for at vertices.
Errors errors_of(const IndexedMesh& mesh, const SmoothSurface& surface, std::size_t n_samples);

}  // namespace whittle::bench
