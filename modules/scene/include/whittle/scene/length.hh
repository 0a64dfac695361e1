#pragma once

namespace whittle {

/// A length for a mesh that hasn't been read yet.
struct Length {
  double value = 0;          ///< model units, or a share of the diagonal of the mesh's bounding box
  bool is_relative = false;  ///< whether `value` is a share of the diagonal

  double in_units(double diagonal) const { return is_relative ? value * diagonal : value; }
};

/// A length that may depend on the mesh.
struct AutomaticLength {
  bool is_automatic = false;  ///< whether it is chosen for the mesh
  Length length;              ///< if it is not automatic
};

}  // namespace whittle
