#pragma once

#include <string>
#include <vector>

#include "files/input.hh"
#include "whittle/core/material/material.hh"
#include "whittle/report/page.hh"

namespace whittle::app {

/// How a mesh file looks: the materials of its groups of faces (`read_materials`). It holds no mesh.
class PageLook {
 public:
  PageLook() = default;
  /// \param input that was read \param warnings gets a line for each image that can't be read
  PageLook(const Scene& input, std::vector<std::string>& warnings);

  /// Gives a surface its materials. \pre its groups are those of the input
  void dress(report::PageSurface& surface) const;

 private:
  std::vector<Material> materials_;  ///< by group
  ColorEncoding colors_ = ColorEncoding::srgb;
};

}  // namespace whittle::app
