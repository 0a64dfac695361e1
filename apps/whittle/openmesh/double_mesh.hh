#pragma once

#include <algorithm>  // before OpenMesh's headers, which use std::find without it

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <cstddef>
#include <functional>
#include <utility>

namespace whittle::app {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

/// OpenMesh's triangle mesh with coordinates in double.
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// Keeps the status bits of a mesh requested while it exists. The decimaters request them too, but release them before
/// the garbage collection.
class HeldStatus {
 public:
  explicit HeldStatus(DoubleMesh& mesh) : mesh_(mesh) {
    mesh_.request_vertex_status();
    mesh_.request_halfedge_status();
    mesh_.request_edge_status();
    mesh_.request_face_status();
  }
  ~HeldStatus() {
    mesh_.release_vertex_status();
    mesh_.release_halfedge_status();
    mesh_.release_edge_status();
    mesh_.release_face_status();
  }
  HeldStatus(const HeldStatus&) = delete;
  HeldStatus& operator=(const HeldStatus&) = delete;

 private:
  DoubleMesh& mesh_;
};

/// Calls back with the number of contractions every `interval` contractions. Ends the run when the callback returns
/// false.
class ContractionObserver : public OpenMesh::Decimater::Observer {
 public:
  explicit ContractionObserver(std::function<bool(std::size_t n_contractions)> goes_on)
      : Observer(interval), goes_on_(std::move(goes_on)) {}
  void notify(std::size_t n_contractions) override { aborted_ = !goes_on_(n_contractions); }
  bool abort() const override { return aborted_; }

 private:
  static constexpr std::size_t interval = 256;  // some milliseconds of the stock decimater
  std::function<bool(std::size_t)> goes_on_;
  bool aborted_ = false;
};

}  // namespace whittle::app
