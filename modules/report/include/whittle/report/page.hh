#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/material.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/progressive/replay.hh"
#include "whittle/report/attribute_map.hh"
#include "whittle/report/distance_map.hh"

// An HTML page that shows meshes, in one file without external resources.

namespace whittle::report {

/// New numbers of a mesh's vertices and faces.
struct PageOrder {
  std::vector<Index> of_vertex;
  std::vector<Index> of_face;
};

/// Renumbers vertices and faces so that the page becomes small; each face begins at its lowest vertex. Vertex v has
/// wedge v; further wedges come after these. Keeps positions, faces, attributes of wedges, and face groups.
PageOrder put_in_page_order(IndexedMesh& mesh);

/// Pairs that a run refused for one reason.
struct PageRefusals {
  std::string reason;
  std::vector<VertexPair> pairs;  ///< of the surface's mesh
};

/// Fewer faces over the vertices and wedges of a mesh.
struct CoarseFaces {
  std::vector<Triangle> faces;
  std::vector<Index> wedges;       ///< as `IndexedMesh::wedges`; empty if the mesh has none
  std::vector<Index> face_groups;  ///< as `IndexedMesh::face_groups`
};

/// The sampled distance between a mesh and the original, both ways, model units.
struct PageError {
  double mean, max;
};

/// A mesh of the page, shown with normals, colours and texture coordinates.
struct PageSurface {
  std::string name;
  IndexedMesh mesh;  ///< in page order
  /// Drawn while the view moves, if all faces take too long; or empty.
  CoarseFaces coarse;
  std::string note;                            ///< further information, such as that it is a coarser level; or empty
  std::vector<PageRefusals> refusals;          ///< refused contractions
  std::optional<DistanceMap> distances;        ///< to the original; for the original, to the first result
  std::vector<AttributeMap> attribute_maps{};  ///< to the same surface; in page order
  /// Per face group; a group without a material is plain. Images other than PNG, JPEG or WebP are not shown; equal
  /// images are stored once.
  std::vector<Material> materials{};
  ColorEncoding colors = ColorEncoding::srgb;  ///< of `mesh.colors`
  bool marks_irregular_edges = true;  ///< whether borders and non-manifold edges are drawn: a rough level has others
  std::optional<PageError> error{};   ///< of a result
  std::size_t n_faces_of_file = 0;    ///< if `mesh` is a coarser level of it; else 0
};

/// Faces for `PageSurface::coarse`: about 10,000; none for a mesh of few faces. \param threads 0 = all cores
CoarseFaces coarse_faces(const IndexedMesh& mesh, unsigned threads = 0);

/// A level of a recording, with its error.
struct PageLevel {
  std::uint64_t n_faces;
  double mean_error, max_error;  ///< model units
};

/// A run that the page plays. Its first level is the original.
struct PageRecording {
  progressive::Replay replay;
  PageOrder order;                ///< of the original
  std::vector<PageLevel> levels;  ///< by descending number of faces
};

/// A drawing.
struct PageChart {
  std::string title;
  std::string svg;  ///< copied into the page verbatim
};

/// A quantity of a table.
struct PageRow {
  std::string name;
  std::string unit;                 ///< or empty
  std::vector<std::string> values;  ///< one a column; empty text: has none
  std::optional<std::size_t> best;  ///< the column with the best value, if one is better than the others
};

struct PageTable {
  std::string title;
  std::vector<std::string> columns;  ///< names; none if there is one value a row
  std::vector<PageRow> rows;
};

/// What a page says of a run that goes on. The browser reads the file again and again, until there is a page without
/// it.
struct PageLive {
  std::string stage;          ///< "decimating"
  double fraction = 0;        ///< of the stage, [0, 1]
  std::uint64_t n_faces = 0;  ///< that are left
  std::string target;         ///< "5120 faces"
  double seconds = 0;         ///< since the run began
  std::string problem;        ///< why the run has ended without a result; or empty. Such a page isn't read again
};

struct Page {
  std::string title;
  std::string advice;  ///< reason for not reaching fewer faces, and a remedy; or empty
  PageSurface original;
  std::vector<PageSurface> results;
  std::optional<PageRecording> recording;
  std::vector<PageChart> charts;
  std::vector<PageTable> tables;
  std::optional<PageLive> live{};
  std::string json = {};  ///< all figures, as JSON to be read by people; or empty
};

/// What the viewer reads of a page.
struct PageData {
  std::string json;                  ///< where the arrays are in `bytes`, and what they are
  std::vector<unsigned char> bytes;  ///< arrays, one after the other
};

/// Positions are rounded to 65,536 steps along the longest side of the box around all meshes, distances to 65,536 steps
/// up to the largest one, texture coordinates to a 65,536th of the texture.
/// \throw std::invalid_argument if a mesh has no faces
PageData page_data(const Page& page);

/// Writes the page with its data (`page_data`). Texts are escaped. \param out its state shows write errors \throw
/// std::invalid_argument if a mesh has no faces
void write_page(std::ostream& out, const Page& page);

}  // namespace whittle::report
