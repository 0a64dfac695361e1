#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>
#include <whittle/core/indexed_mesh.hh>

/// Meshes made by code, each with its counts: V vertices, F faces, genus g. Closed ones are oriented outwards. Unless
/// stated otherwise, a mesh is manifold, connected and without duplicate, degenerate or isolated elements.
/// Impossible arguments (fewer than three vertices around and so on) throw std::invalid_argument.
namespace whittle::test {

// Closed polyhedra ----------------------------------------------------------------------------------------------------

/// The regular tetrahedron inside the cube (±1)³. V 4, F 4, g 0.
IndexedMesh tetrahedron();
/// V 6 on the axes at distance 1, F 8, g 0; every valence 4.
IndexedMesh octahedron();
/// V 12 on the unit sphere, F 20, g 0; every valence 5.
IndexedMesh icosahedron();
/// The cube (±1)³. V 8, F 12, g 0.
IndexedMesh cube();
/// The cube (±1)³, each side n × n squares cut in two. V 6n² + 2, F 12n², g 0. n is at least 1.
IndexedMesh tessellated_cube(int n);
/// The torus of Császár: every two vertices share an edge, so no edge may be contracted. V 7, F 14, g 1.
IndexedMesh csaszar_torus();

// Closed, round -------------------------------------------------------------------------------------------------------

/// The icosahedron with each face cut in four `levels` times, on the unit sphere. V 10·4ⁿ + 2, F 20·4ⁿ, g 0.
IndexedMesh sphere(int levels);
/// The unit sphere by latitude and longitude; both poles (0, 0, ±1) have valence n_lon.
/// V (n_lat − 1)·n_lon + 2, F 2·n_lon·(n_lat − 1), g 0. n_lat at least 2, n_lon at least 3.
IndexedMesh uv_sphere(int n_lat, int n_lon);
/// V nu·nv, F 2·nu·nv, g 1; nu vertices around the z axis, nv around the tube. Every valence 6.
IndexedMesh torus(int nu, int nv, double major_radius = 1.0, double minor_radius = 0.35);
/// `torus` with each vertex moved along the normal by at most `amplitude`, at random.
IndexedMesh noisy_torus(int nu, int nv, double major_radius, double minor_radius, double amplitude, std::uint64_t seed);
/// `sphere` with each vertex moved along its radius by at most `amplitude`, at random.
IndexedMesh noisy_sphere(int levels, double amplitude, std::uint64_t seed);
/// A smooth star-shaped lump: `sphere` with some soft bumps and dents, radius about 0.6 to 1.6. Counts as `sphere`.
IndexedMesh blob(int levels, std::uint64_t seed);
/// A rope tied into a trefoil knot, with six ridges twisted around it, about 6 × 6 × 3 in size.
/// V n_along·n_around, F 2·n_along·n_around, g 1. Every valence 6.
IndexedMesh knot(int n_along, int n_around);

// Open ----------------------------------------------------------------------------------------------------------------

/// The flat rectangle [0, nx] × [0, ny] at z = 0, normals up. V (nx + 1)(ny + 1), F 2·nx·ny, one border.
IndexedMesh grid(int nx, int ny);
/// `grid` with a random height in ±amplitude for every vertex.
IndexedMesh noisy_grid(int nx, int ny, double amplitude, std::uint64_t seed);
/// A hilly height field over the unit square, rough at every scale. V (n + 1)², F 2n², one border.
IndexedMesh terrain(int n, std::uint64_t seed);
/// A tube of radius 1 about the z axis, z from 0 to 2. V n_around·(n_along + 1), F 2·n_around·n_along, two borders.
IndexedMesh open_cylinder(int n_around, int n_along);
/// A Möbius strip: half a twist, not orientable. V n_along·(n_across + 1), F 2·n_along·n_across, one border; Euler
/// number 0.
/// n_along at least 5.
IndexedMesh moebius(int n_along, int n_across = 1);
/// V 3, F 1.
IndexedMesh single_triangle();
/// Two faces with a common edge, not in one plane. V 4, F 2.
IndexedMesh two_triangles();

// With sharp edges ----------------------------------------------------------------------------------------------------

/// A cone, base radius 1 and apex at z = height; the apex and the middle of the base have valence n. V n + 2, F 2n, g
/// 0.
IndexedMesh cone(int n_around, double height = 2.0);
/// A truncated cone: radii 1 and 0.5, each side one long thin pair of faces. V 2n + 2, F 4n, g 0.
IndexedMesh frustum(int n_around, double height = 20.0);
/// How the flat ends of a shape are divided: into triangles from one vertex, into a strip from one side to the other,
/// or into triangles around the middle.
enum class Caps { fan, strip, center };
/// A cylinder of radius and height 1, a long thin pair of faces a side. V 2n, F 4n - 4; around the middle V 2n + 2, F
/// 4n.
IndexedMesh capped_cylinder(int n_around, Caps caps);
/// A ring of radii 0.5 and 1 and height 0.2, a pair of faces a side all around. V 4n, F 8n, g 1.
IndexedMesh washer(int n_around);
/// A square plate of side 2 and height 0.1 with a round hole of radius 0.6. Long thin faces go from the hole to the
/// sides: all around (strip), or from the four corners (fan). V 4n and F 8n, or V 2n + 8 and F 4n + 16; g 1.
IndexedMesh drilled_plate(int n_around, Caps caps);
/// An angle bracket: a plate with a round hole through it and a wall standing on its edge; flat sides, sharp edges.
/// With n = `n_side` (at least 2) squares along a side: V 10n² + 12n + 2, F 20n² + 24n + 4, g 1.
IndexedMesh bracket(int n_side);

// With seams ----------------------------------------------------------------------------------------------------------

/// `tessellated_cube` with a chart and a group a side, and normals that break at its edges. Each corner of a face has a
/// wedge of its own: `join_equal_wedges` leaves one a vertex and side. The texture coordinates are `chart_position`.
IndexedMesh charted_cube(int n);
/// Texture coordinates on a side of the charted cube, a linear function of the position.
std::array<double, 2> chart_position(std::size_t side, const Vec3& position);
/// `torus` with texture coordinates in [0, 1]: the turn around the axis, and that around the tube. It is one chart, cut
/// along a circle of each kind.
IndexedMesh textured_torus(int nu, int nv);
/// A torus cut into charts of `tile` × `tile` squares. Chart (i, j) has texture coordinates from (10 i, 10 j) to
/// (10 i + 1, 10 j + 1). \pre `tile` divides both numbers
IndexedMesh tiled_torus(int nu, int nv, int tile);
/// `grid(n, n)` with a disc of one material, group 1, in a square of another.
IndexedMesh disc_in_square(int n);
double area_of_disc(const IndexedMesh& disc_in_square);

// Several parts -------------------------------------------------------------------------------------------------------

/// Both meshes as parts of one; attributes are dropped.
IndexedMesh joined(const IndexedMesh& a, const IndexedMesh& b);
/// `count` unit spheres in a row along x with `gap` between them; each as `sphere(levels)`.
IndexedMesh spheres(int count, int levels, double gap = 0.5);
/// nx × ny cubes of edge 2 in a square pattern with `gap` between neighbours. V 8·nx·ny, F 12·nx·ny.
IndexedMesh boxes(int nx, int ny, double gap = 0.2);

// Not manifold, or otherwise odd --------------------------------------------------------------------------------------

/// Two tetrahedra with one common vertex, which has two fans. V 7, F 8.
IndexedMesh bow_tie();
/// Three faces with a common edge. V 5, F 3.
IndexedMesh three_faces_on_an_edge();
/// Square grids of 2 × n_along squares with a common side, like pages of a book.
/// V (n_along + 1)(2 n_pages + 1), F 4 n_pages n_along.
IndexedMesh book(int n_pages, int n_along);
/// Two cubes with one common edge. Each of the edge's n segments has four faces; sides of n × n squares.
/// V 12n² − n + 3, F 24n².
IndexedMesh two_cubes_on_an_edge(int n = 1);
/// A wavy sheet of n by n squares with a front and a back, which have the vertices around in common, and no others.
/// V 2 (n − 1)² + 4n, F 4n², closed.
IndexedMesh two_sided_leaf(Index n);
/// The same with a wall of 0.05 between front and back, so thin that coarse results of it cross.
IndexedMesh thin_wall(Index n);
/// Two faces on the same three vertices, back to back: closed, without volume. V 3, F 2, Euler number 2.
IndexedMesh pillow();
/// Every face with three vertices of its own (as in STL). V 3F.
IndexedMesh soup(const IndexedMesh& mesh);
/// Vertices at exactly the same position become one, the first of them, even if the surface becomes non-manifold.
/// Attributes are dropped.
IndexedMesh glued(const IndexedMesh& mesh);
/// Adds copies of the first `count` faces at the end, each starting at another corner than the original.
IndexedMesh with_duplicate_faces(const IndexedMesh& mesh, int count);
/// Adds `count` vertices that no face uses, spread among the others; attributes are dropped.
IndexedMesh with_isolated_vertices(const IndexedMesh& mesh, int count, std::uint64_t seed);
/// Every face turned over.
IndexedMesh inside_out(const IndexedMesh& mesh);

}  // namespace whittle::test
