#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace whittle {

/// What ends a run: the first limit reached. A target is always said; there is no default.
///
///   DecimateTarget::faces(500)
///   DecimateTarget::vertices(300).or_max_cost(1e-3)
class DecimateTarget {
 public:
  /// Stop once at most `n` faces are left.
  static DecimateTarget faces(std::uint64_t n) { return as_far_as_possible().or_faces(n); }
  /// Stop once at most `n` vertices are left.
  static DecimateTarget vertices(std::uint64_t n) { return as_far_as_possible().or_vertices(n); }
  /// Contract only what costs at most `cost`, in the unit of the cost (`Cost`), by model units. [0, inf).
  static DecimateTarget max_cost(double cost) { return as_far_as_possible().or_max_cost(cost); }
  /// Contract only what keeps the surface within a distance of the input, and the input within the same distance of
  /// the surface: all points, not only vertices. Model units. (0, inf).
  /// \param of_borders the same between the open borders; empty = as `distance`
  static DecimateTarget max_error(double distance, std::optional<double> of_borders = {}) {
    return as_far_as_possible().or_max_error(distance, of_borders);
  }
  /// Stop when the guards allow nothing more.
  static DecimateTarget as_far_as_possible() { return {}; }

  /// This target or that limit, whichever is reached first. A limit of the same kind is replaced.
  DecimateTarget or_faces(std::uint64_t n) const { return with(&DecimateTarget::n_faces_, n); }
  DecimateTarget or_vertices(std::uint64_t n) const { return with(&DecimateTarget::n_vertices_, n); }
  DecimateTarget or_max_cost(double cost) const { return with(&DecimateTarget::cost_limit_, cost); }
  DecimateTarget or_max_error(double distance, std::optional<double> of_borders = {}) const {
    return with(&DecimateTarget::error_limit_, distance)
        .with(&DecimateTarget::border_error_limit_, of_borders.value_or(distance));
  }

  std::optional<std::uint64_t> n_faces() const { return n_faces_; }
  std::optional<std::uint64_t> n_vertices() const { return n_vertices_; }
  std::optional<double> cost_limit() const { return cost_limit_; }
  std::optional<double> error_limit() const { return error_limit_; }
  /// Set if `error_limit` is.
  std::optional<double> border_error_limit() const { return border_error_limit_; }

  /// The same limits with counts larger by a factor, rounded up.
  DecimateTarget with_counts_times(double factor) const {
    const auto times = [factor](std::optional<std::uint64_t> n) {
      if (n) n = static_cast<std::uint64_t>(std::ceil(factor * static_cast<double>(*n)));
      return n;
    };
    return with(&DecimateTarget::n_faces_, times(n_faces_)).with(&DecimateTarget::n_vertices_, times(n_vertices_));
  }

  /// The share of a mesh with such counts that the limits of faces and vertices leave at least; 0 without these.
  double share_of(std::size_t n_faces, std::size_t n_vertices) const {
    const auto share = [](std::optional<std::uint64_t> wanted, std::size_t n) {
      return wanted ? static_cast<double>(*wanted) / static_cast<double>(n) : 0.0;
    };
    return std::max(share(n_faces_, n_faces), share(n_vertices_, n_vertices));
  }

  /// Whether a mesh with such counts has reached the limit of faces or that of vertices.
  bool is_reached_at(std::uint64_t n_faces, std::uint64_t n_vertices) const {
    return (n_faces_ && n_faces <= *n_faces_) || (n_vertices_ && n_vertices <= *n_vertices_);
  }

 private:
  DecimateTarget() = default;

  template <class T>
  DecimateTarget with(std::optional<T> DecimateTarget::*limit, std::optional<T> value) const {
    DecimateTarget other = *this;
    other.*limit = value;
    return other;
  }
  template <class T>
  DecimateTarget with(std::optional<T> DecimateTarget::*limit, T value) const {
    return with(limit, std::optional<T>(value));
  }

  std::optional<std::uint64_t> n_faces_;
  std::optional<std::uint64_t> n_vertices_;
  std::optional<double> cost_limit_;
  std::optional<double> error_limit_;
  std::optional<double> border_error_limit_;
};

}  // namespace whittle
