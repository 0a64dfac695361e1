#pragma once

#include <cstdint>
#include <optional>

#include "whittle/openmesh/detail/face_guard.hh"

namespace whittle {

/// What `PairDecimaterT` asks of `ModMaxErrorT`. It needs no proof: programs without that module don't compile one.
template <class MeshT>
class ErrorGuardT : public FaceGuardT<MeshT> {
 public:
  /// Largest distance between the input and the mesh, both ways, model units; empty = no limit.
  virtual std::optional<double> max_error() const = 0;
  /// The same between the open borders of both.
  virtual std::optional<double> max_border_error() const = 0;
  /// Whether the mesh as it is is proven to keep the limits. \throw std::logic_error without a limit
  virtual bool is_proven() = 0;
  /// Tells it that the mesh was changed without it.
  virtual void note_new_surface() = 0;

  /// Of how many collapses it was told before and after, since it was made.
  std::uint64_t n_followed() const { return n_followed_; }
  /// How many questions it has answered by no because of a limit.
  std::uint64_t n_refused() const { return n_refused_; }

 protected:
  using FaceGuardT<MeshT>::FaceGuardT;
  void count_followed() { ++n_followed_; }
  void count_refused() { ++n_refused_; }

 private:
  std::uint64_t n_followed_ = 0;
  std::uint64_t n_refused_ = 0;
};

}  // namespace whittle
