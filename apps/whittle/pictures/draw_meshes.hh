#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pictures/picture_view.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/material.hh"
#include "whittle/progressive/replay.hh"

// Pictures of an original, its results and a run, as the page of `report` shows them.

namespace whittle::app {

/// How far each point of a surface is from another one.
struct ShownDistances {
  IndexedMesh mesh;                      ///< the surface's, in smaller faces where distances aren't linear
  std::vector<double> signed_distances;  ///< of its vertices, model units
  double max = 0;
  double usual = 0;  ///< nearer is 99 % of the area
};

/// How far an attribute of a surface is from that of another one.
struct ShownDeviations {
  AttributeKind kind = AttributeKind::texcoord;
  std::vector<double> values;  ///< of wedges
  double max = 0;
  double usual = 0;
};

struct ShownSurface {
  std::string name;
  std::string note;  ///< not empty for a coarser level
  IndexedMesh mesh;
  std::vector<Material> materials;  ///< by face group
  ColorEncoding colors = ColorEncoding::srgb;
  std::optional<ShownDistances> distances;
  std::vector<ShownDeviations> deviations;
};

struct ShownMeshes {
  ShownSurface original;
  std::vector<ShownSurface> results;
  std::optional<progressive::Replay> run;  ///< between the original and a result
};

/// Red, green, blue; rows from the top.
struct RgbPicture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> bytes;
};

/// \param meshes the run goes to the level that is shown \param threads 0 = all cores
/// \param warnings gets a line for each texture that can't be drawn
/// \pre `require_pictures` \throw std::runtime_error
RgbPicture draw_meshes(ShownMeshes& meshes, const PictureView& view, const PictureSize& size, unsigned threads,
                       std::vector<std::string>& warnings);

/// The bytes of a PNG file. \pre `require_pictures`
std::string png_file(const RgbPicture& picture);

}  // namespace whittle::app
