#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace whittle::app {

/// In pixels.
struct PictureSize {
  std::uint64_t width = 1280;
  std::uint64_t height = 720;
};

/// Names and values of controls of the page of `report`: {"colour", "error"}.
using PageSettings = std::map<std::string, std::string>;

/// How pictures of meshes are set up: as the page is that has these settings.
struct PictureView {
  std::string layout = "beside";  ///< beside, over, original, result, split
  double split = 0.5;             ///< where the original ends and the result begins: a share of the width, [0, 1]
  int result = -1;                ///< its number; below 0: as the page opens
  std::string colour;             ///< empty: what the meshes look like
  std::string top = "usual";      ///< where the scale of errors ends
  std::string ghost = "transparent";
  std::string shading;  ///< flat, smooth, file; empty: by the normals of the file, or flat if it has none
  std::string up = "y";
  bool faces = true;
  bool edges = false;
  bool borders = true;
  bool nonmanifold = true;
  bool is_plain = false;  ///< without names of meshes
  bool has_level = false;
  double level = 1;  ///< of the recording, [0, 1]
  bool is_by_faces = false;
  bool is_continuous = false;
  double turn_deg = 0;
  double tilt_deg = 0;
  double zoom = 1;
};

/// \param settings that are among those of the page, with such values
PictureView picture_view(const PageSettings& settings);

}  // namespace whittle::app
