#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <bit>
#include <cstdint>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "whittle/engine/run_steps.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/detail/status_bits.hh"

// The steps of a decimater as a binary module: for `progressive::Replay` and `progressive::write_recording`, and for
// OpenMesh's own progressive meshes.
//
//   ModProgMeshT: which vertex went into which    -> a .pm file, with places as they are in the end
//   ModRecorderT: that, and where the vertex went -> levels with any placement; the same .pm file

namespace whittle {

/// Records the collapses that are made from `initialize()` on, and refuses none. In OpenMesh's decimaters and, with the
/// mesh driver, in `PairDecimaterT`. What a collapse costs is not recorded, as modules are not told: costs are 0.
template <class MeshT>
class ModRecorderT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModRecorderT, MeshT, Recorder);

  explicit ModRecorderT(MeshT& mesh) : Base(mesh, true), mesh_(mesh) { mesh_.add_property(number_); }
  ~ModRecorderT() override { mesh_.remove_property(number_); }
  ModRecorderT(const ModRecorderT&) = delete;
  ModRecorderT& operator=(const ModRecorderT&) = delete;

  /// The mesh at `initialize()`, in model units. Vertices and faces that were deleted then are left out.
  const IndexedMesh& input() const { return input_; }
  /// What was done since, in the vertex numbers of `input()`. \pre the decimater isn't running
  const RunSteps& steps() {
    complete_last();
    return steps_;
  }

  /// Writes the mesh as it is, and the vertex splits that lead back from it, as OpenMesh's `ModProgMeshT` does: 32-bit
  /// floats and numbers; its `ProgViewer` reads it. Call it before garbage collection.
  /// \throw std::logic_error if a collapse has moved the vertex that was left: the format has no place for that; or if
  ///        the garbage was collected since `initialize()`, as MixedDecimaterT does between its two parts
  /// \throw std::runtime_error if the file can't be written
  void write_pm(const std::string& path);

  void initialize() override {
    const auto numbers = detail::number_vertices(mesh_, Copies::apart);
    input_ = detail::geometry_of(mesh_, numbers);
    for (std::size_t v = 0; v < mesh_.n_vertices(); ++v) {
      mesh_.property(number_, VertexHandle(static_cast<int>(v))) = numbers.number_of[v];
    }
    n_vertices_ = mesh_.n_vertices();
    steps_ = {};
    splits_.clear();
    is_last_complete_ = true;
    has_moved_ = false;
  }
  float collapse_priority(const CollapseInfo& /*collapse*/) override { return Base::LEGAL_COLLAPSE; }
  void preprocess_collapse(const CollapseInfo& collapse) override {
    complete_last();
    before_ = to_vec3(mesh_.point(collapse.v1));
  }
  /// A module that moves the vertex may be told after this one. So the place is looked up later.
  void postprocess_collapse(const CollapseInfo& collapse) override {
    steps_.contractions.push_back({number(collapse.v1), number(collapse.v0), before_, 0, false, false});
    splits_.push_back({collapse.v0, collapse.v1, collapse.vl, collapse.vr});
    is_last_complete_ = false;
  }

 private:
  using VertexHandle = typename MeshT::VertexHandle;
  struct Split {
    VertexHandle removed, survivor, left, right;
  };

  Index number(VertexHandle v) const { return mesh_.property(number_, v); }
  /// The vertex of a number. \param v its handle, unless the garbage has been collected
  VertexHandle vertex_of(Index number, VertexHandle v) const {
    const auto n = static_cast<int>(mesh_.n_vertices());
    if (v.idx() < n && this->number(v) == number) return v;
    int i = 0;
    while (i < n && this->number(VertexHandle(i)) != number) ++i;
    return VertexHandle(i);
  }
  void complete_last() {
    if (is_last_complete_) return;
    const Index survivor = steps_.contractions.back().survivor;
    const Vec3 position = to_vec3(mesh_.point(vertex_of(survivor, splits_.back().survivor)));
    has_moved_ = has_moved_ || position != before_;
    steps_.contractions.back().position = position;
    is_last_complete_ = true;
  }

  MeshT& mesh_;
  IndexedMesh input_;
  OpenMesh::VPropHandleT<Index> number_;  ///< in `input_`. It goes with a vertex where handles change
  std::size_t n_vertices_ = 0;            ///< of the mesh at `initialize()`, deleted ones, too
  RunSteps steps_;
  std::vector<Split> splits_;
  Vec3 before_ = Vec3::Zero();    ///< where the survivor of the last collapse was
  bool is_last_complete_ = true;  ///< whether the last step has its position
  bool has_moved_ = false;        ///< whether a collapse has moved its survivor
};

namespace detail {

/// 32-bit numbers, the lowest byte first.
class PmWriter {
 public:
  explicit PmWriter(const std::string& path) : out_(path, std::ios::binary) {}

  void text(const char* text) { out_ << text; }
  void number(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) out_.put(static_cast<char>(value >> shift & 0xffU));
  }
  void number(float value) { number(std::bit_cast<std::uint32_t>(value)); }
  template <class Point>
  void point(const Point& p) {
    for (unsigned i = 0; i < 3; ++i) number(static_cast<float>(p[i]));
  }
  bool close() {
    out_.close();
    return !out_.fail();
  }

 private:
  std::ofstream out_;
};

}  // namespace detail

template <class MeshT>
void ModRecorderT<MeshT>::write_pm(const std::string& path) {
  complete_last();
  if (has_moved_) throw std::logic_error("ModRecorderT: a .pm file is for vertices that stay where they are");
  if (mesh_.n_vertices() != n_vertices_) {
    throw std::logic_error("ModRecorderT: a .pm file is written before the garbage is collected");
  }
  const ConstStatusBits<OpenMesh::FaceHandle> bits(mesh_);
  std::vector<std::uint32_t> numbers(
      mesh_.n_vertices());  // those that are left, then those removed, the last one first
  std::vector<typename MeshT::VertexHandle> left;
  for (const auto v : mesh_.vertices()) {  // those that aren't deleted
    numbers[static_cast<std::size_t>(v.idx())] = static_cast<std::uint32_t>(left.size());
    left.push_back(v);
  }
  auto next = static_cast<std::uint32_t>(left.size());
  for (auto split = splits_.rbegin(); split != splits_.rend(); ++split) {
    numbers[static_cast<std::size_t>(split->removed.idx())] = next++;
  }
  std::uint32_t n_faces = 0;
  for (int f = 0; f < static_cast<int>(mesh_.n_faces()); ++f)
    n_faces += bits.is_deleted(OpenMesh::FaceHandle(f)) ? 0U : 1U;
  const auto number_in_file = [&numbers](typename MeshT::VertexHandle v) {
    return v.is_valid() ? numbers[static_cast<std::size_t>(v.idx())] : ~std::uint32_t{0};
  };
  detail::PmWriter writer(path);
  writer.text("ProgMesh");
  writer.number(static_cast<std::uint32_t>(left.size()));
  writer.number(n_faces);
  writer.number(static_cast<std::uint32_t>(splits_.size()));
  for (const auto v : left) writer.point(mesh_.point(v));
  for (int f = 0; f < static_cast<int>(mesh_.n_faces()); ++f) {
    if (bits.is_deleted(OpenMesh::FaceHandle(f))) continue;
    for (const auto v : face_corners(mesh_, OpenMesh::FaceHandle(f))) writer.number(number_in_file(v));
  }
  for (auto split = splits_.rbegin(); split != splits_.rend(); ++split) {
    writer.point(mesh_.point(split->removed));
    for (const auto v : {split->survivor, split->left, split->right}) writer.number(number_in_file(v));
  }
  if (!writer.close()) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace whittle
