#pragma once

#include <string>
#include <vector>

namespace whittle::app {

/// A moving picture in the format WebP, which begins again at its end.
class Animation {
 public:
  /// \param picture a WebP file; all have the same size
  void add(std::string picture) { pictures_.push_back(std::move(picture)); }
  /// The bytes of the file. The last picture stays longer than the others.
  /// \throw std::runtime_error if a picture can't be used, or if this program was built without libwebp
  std::string finished() const;

 private:
  std::vector<std::string> pictures_;
};

/// Whether this program was built with libwebp.
bool has_animations();

}  // namespace whittle::app
