#pragma once

#include <cstdint>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/verify/verify.hh"

namespace whittle::bench {

/// A mesh as the verifier takes it.
class CertificateArrays {
 public:
  explicit CertificateArrays(const IndexedMesh& mesh) {
    for (const Vec3& p : mesh.positions) coordinates_.insert(coordinates_.end(), p.begin(), p.end());
    for (const Triangle& face : mesh.faces) corners_.insert(corners_.end(), face.begin(), face.end());
  }
  verify::Triangles triangles() const { return {coordinates_, corners_}; }

 private:
  std::vector<double> coordinates_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace whittle::bench
