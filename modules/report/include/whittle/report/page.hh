#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
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

/// Whether bytes begin as those of a PNG, JPEG or WebP file, which are the images that a page shows.
bool is_page_image(std::string_view bytes);

/// What a texture shows outside of [0, 1].
enum class PageWrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };

/// What the opacity of a colour does: nothing; the surface ends where it is below the cutoff; what is behind shines
/// through.
enum class PageAlpha : std::uint8_t { opaque, mask, blend };

/// How a surface looks: base colour · image · vertex colour, in linear light, as in glTF.
struct PageMaterial {
  std::string name;
  std::array<double, 4> base_color = {1, 1, 1, 1};  ///< linear red, green, blue, and opacity; each in [0, 1]
  /// The bytes of an image (`is_page_image`), or null. Others aren't shown. Images with equal bytes are in the page
  /// once.
  std::shared_ptr<const std::string> image;
  std::string texcoord = "TEXCOORD_0";  ///< the attribute with the image's coordinates; without it there is no image
  /// To coordinates that are (0, 0) at the outer corner of the first pixel. For OBJ: (u, v) to (u, 1 − v).
  Eigen::Affine2d texcoord_transform = Eigen::Affine2d::Identity();
  std::array<PageWrap, 2> wrap{};
  PageAlpha alpha = PageAlpha::opaque;
  double alpha_cutoff = 0.5;
};

/// How numbers are related to light.
enum class PageColors : std::uint8_t { srgb, linear };

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
  std::vector<PageMaterial> materials{};       ///< by face group; a group without one is plain
  PageColors colors = PageColors::srgb;        ///< what `mesh.colors` are
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
