#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <utility>

#include "whittle/engine/options.hh"

namespace whittle {

/// One progress callback for many loops on many threads. It is called on the thread that made this, and no other.
class SharedProgress {
 public:
  /// \param target_share of the faces, that are to be left. (0, 1)
  SharedProgress(const DecimateOptions& options, std::uint64_t n_vertices, std::uint64_t n_faces, double target_share)
      : callback_(options.progress),
        n_vertices_(n_vertices),
        n_faces_(n_faces),
        n_left_(n_faces),
        share_(target_share) {}

  bool is_cancelled() const { return is_cancelled_.load(std::memory_order_relaxed); }

  /// Says what makes `Progress::surface` from now on. On the caller's thread.
  void set_surface(std::function<IndexedMesh()> surface) { surface_ = std::move(surface); }

  /// Tells how many faces are gone. \param surface in place of the one that was set, or null
  /// \return whether to go on
  bool advance(std::uint64_t n_faces_gone, const std::function<IndexedMesh()>* surface = nullptr) {
    n_left_.fetch_sub(n_faces_gone, std::memory_order_relaxed);
    if (!callback_ || std::this_thread::get_id() != caller_ || is_cancelled()) return !is_cancelled();
    Progress progress = now();
    progress.surface = surface != nullptr ? *surface : surface_;
    if (!callback_(progress)) is_cancelled_.store(true, std::memory_order_relaxed);
    return !is_cancelled();
  }

  /// How far the levels have come.
  Progress now() const {
    const double left = static_cast<double>(n_left_.load(std::memory_order_relaxed)) / static_cast<double>(n_faces_);
    const auto n_vertices = static_cast<std::uint64_t>(left * static_cast<double>(n_vertices_));
    const double fraction = std::min(1.0, (1 - left) / (1 - share_));
    return {n_vertices, n_left_.load(std::memory_order_relaxed), fraction};
  }

 private:
  const std::function<bool(const Progress&)>& callback_;
  std::uint64_t n_vertices_;
  std::uint64_t n_faces_;
  std::atomic<std::uint64_t> n_left_;
  double share_;
  std::function<IndexedMesh()> surface_;
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<bool> is_cancelled_ = false;
};

}  // namespace whittle
