#include <open3d/geometry/TriangleMesh.h>

#include <limits>

#include "bench/peers/peer.hh"

// Open3D's SimplifyQuadricDecimation with its default weight of borders, 1.

namespace whittle::bench {
namespace {

class Open3d : public Peer {
 public:
  IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const override {
    open3d::geometry::TriangleMesh mesh;
    mesh.vertices_ = input.positions;
    for (const Triangle& face : input.faces)
      mesh.triangles_.push_back(Eigen::Map<const Eigen::Matrix<Index, 3, 1>>(face.data()).cast<int>());

    meter.start();
    const auto simplified =
        mesh.SimplifyQuadricDecimation(static_cast<int>(n_faces), std::numeric_limits<double>::infinity(), 1.0);
    meter.stop();

    IndexedMesh result;
    result.positions = simplified->vertices_;
    for (const Eigen::Vector3i& face : simplified->triangles_) {
      const Eigen::Matrix<Index, 3, 1> corners = face.cast<Index>();
      result.faces.push_back({corners[0], corners[1], corners[2]});
    }
    return result;
  }
};

}  // namespace

std::unique_ptr<Peer> make_open3d() { return std::make_unique<Open3d>(); }

}  // namespace whittle::bench
