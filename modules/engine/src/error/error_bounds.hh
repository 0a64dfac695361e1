#pragma once

#include <memory>
#include <span>
#include <vector>

#include "error/error_bound.hh"

namespace whittle {

/// What a result is proven to keep: bounds of the surface and, if the input has open borders, of these.
class ErrorBounds {
 public:
  /// \param input must outlive it \param limit, border_limit in the frame
  /// \param tolerances of the input's vertices, model units, or empty
  ErrorBounds(const IndexedMesh& input, const Frame& frame, double limit, double border_limit, unsigned threads,
              std::span<const double> tolerances);

  ErrorBound& surface() { return *surface_; }
  ErrorBound* borders() { return borders_.get(); }  ///< null if the input has none

  /// Tries to prove that a surface keeps all bounds.
  ErrorBound::Violations check(const CheckedSurface& surface);
  /// The same of the surface checked last, after some of its vertices have moved: takes less time.
  /// \param is_changed a vertex of the surface, 1 if it has moved
  ErrorBound::Violations check_again(const CheckedSurface& surface, std::span<const std::uint8_t> is_changed);
  ErrorBound::Violations check_borders(const CheckedSurface& surface);
  /// Whether that is proven: takes less time where it isn't.
  bool are_kept_by(const CheckedSurface& surface);
  /// Whether a look at some points is enough to tell that it isn't so: takes little time.
  bool have_far_point(const CheckedSurface& surface);

 private:
  IndexedMesh proper_;        ///< the input without faces of which two corners are one, if it has some
  IndexedMesh border_edges_;  ///< those of the input, as segments
  std::unique_ptr<ErrorBound> surface_;
  std::unique_ptr<ErrorBound> borders_;
};

}  // namespace whittle
