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

// A page of HTML with meshes to look at, in one file that loads nothing else.

namespace whittle::report {

/// New numbers of a mesh's vertices and faces.
struct PageOrder {
  std::vector<Index> of_vertex;
  std::vector<Index> of_face;
};

/// Numbers vertices and faces so that the page becomes small, and lets each face begin at its lowest vertex. Wedges are
/// numbered so that vertex v has wedge v; others of the same vertex come after all of these. Kept are positions, faces,
/// what wedges have, and groups of faces.
PageOrder put_in_page_order(IndexedMesh& mesh);

/// Pairs that a run may not contract, for one reason.
struct PageRefusals {
  std::string reason;
  std::vector<VertexPair> pairs;  ///< of the surface's mesh
};

/// Fewer faces over the vertices and wedges of a mesh.
struct CoarseFaces {
  std::vector<Triangle> faces;
  std::vector<Index> wedges;       ///< as `IndexedMesh::wedges`; empty if the mesh has none
  std::vector<Index> face_groups;  ///< likewise
};

/// A mesh of the page. Shown are positions, faces, and, by wedge, normals, colours and texture coordinates.
struct PageSurface {
  std::string name;
  IndexedMesh mesh;  ///< in page order
  /// What is drawn while the view moves, where all faces take too long. Or empty.
  CoarseFaces coarse;
  std::string note;                    ///< what else is to be known of it, such as that it is a coarser level; or empty
  std::vector<PageRefusals> refusals;  ///< what stands in the way of fewer faces
  std::optional<DistanceMap> distances;        ///< to the original; of the original itself, to the first of the others
  std::vector<AttributeMap> attribute_maps{};  ///< likewise; in page order
  /// By face group; a group without one is plain. Images that aren't PNG, JPEG or WebP are not shown; those with equal
  /// bytes are in the page once.
  std::vector<Material> materials{};
  ColorEncoding colors = ColorEncoding::srgb;  ///< of `mesh.colors`
};

/// For `PageSurface::coarse`: about 10,000; none for a mesh of few faces. \param threads 0 = all cores
CoarseFaces coarse_faces(const IndexedMesh& mesh, unsigned threads = 0);

/// A level of a recording whose error is known.
struct PageLevel {
  std::uint64_t n_faces;
  double mean_error, max_error;  ///< model units
};

/// A run that the page can play. Its first level is the original.
struct PageRecording {
  progressive::Replay replay;
  PageOrder order;                ///< that of the original
  std::vector<PageLevel> levels;  ///< of descending numbers of faces
};

/// A drawing.
struct PageChart {
  std::string title;
  std::string svg;  ///< goes into the page as it is
};

/// A table of names and values.
struct PageTable {
  std::string title;
  std::vector<std::pair<std::string, std::string>> rows;
};

struct Page {
  std::string title;
  std::string advice;  ///< why there are not fewer faces, and what helps; or empty
  PageSurface original;
  std::vector<PageSurface> results;
  std::optional<PageRecording> recording;
  std::vector<PageChart> charts;
  std::vector<PageTable> tables;
};

/// Positions are rounded to 65,536 steps along the longest side of the box around all meshes, distances to as many
/// steps of the greatest one; texture coordinates to a 65,536th of the texture. Texts are shown as they are: they can't
/// add markup. \param out its state says whether all could be written \throw std::invalid_argument if a mesh has no
/// faces
void write_page(std::ostream& out, const Page& page);

}  // namespace whittle::report
