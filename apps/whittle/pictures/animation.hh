#pragma once

#include <string>
#include <vector>

#include "pictures/draw_meshes.hh"

namespace whittle::app {

/// A moving picture in the format WebP, which begins again at its end.
class Animation {
 public:
  /// \param picture all have the same size \throw std::runtime_error if it can't be stored
  void add(const RgbPicture& picture);
  /// The bytes of the file. The last picture stays longer than the others.
  /// \throw std::runtime_error if that can't be made
  std::string finished() const;

 private:
  std::vector<std::string> pictures_;  ///< WebP files
};

/// \throw std::runtime_error if this program was built without libwebp
void require_animations();

}  // namespace whittle::app
