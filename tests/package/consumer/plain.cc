// A program of another project, without OpenMesh: decimates a torus, writes it, reads it again and checks it.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <string>
#include <whittle/core/indexed_mesh.hh>
#include <whittle/engine/decimate.hh>
#include <whittle/io/read.hh>
#include <whittle/io/write.hh>
#include <whittle/metrics/topology.hh>
#include <whittle/version.hh>

#include "../../../apps/examples/torus.hh"
#include "digest.hh"

namespace {

unsigned long long digest_of(const whittle::IndexedMesh& mesh) {
  Digest digest;
  for (const auto& position : mesh.positions)
    for (const double x : position) digest.add(x);
  for (const auto& face : mesh.faces)
    for (const auto corner : face) digest.add(std::uint64_t{corner});
  return digest.value();
}

}  // namespace

int main() {
  if (std::strcmp(whittle::version(), WHITTLE_VERSION_STRING) != 0) return 1;
  const Torus torus(48, 24);
  whittle::IndexedMesh mesh;
  for (const auto& p : torus.points) mesh.positions.emplace_back(p[0], p[1], p[2]);
  for (const auto& face : torus.faces) mesh.faces.push_back({face[0], face[1], face[2]});

  const whittle::Decimation small = whittle::decimate(mesh, whittle::DecimateTarget::faces(300));

  std::ostringstream file;
  whittle::io::write_mesh(file, whittle::io::Format::ply, small.mesh);
  const std::string bytes = file.str();
  const auto again = whittle::io::read_mesh(bytes, "torus.ply");
  const whittle::metrics::Topology topology = whittle::metrics::topology(again.mesh);
  std::printf("%zu faces became %zu, genus %ld, digest %llx\n", mesh.faces.size(), again.mesh.faces.size(),
              topology.genus.value_or(-1), digest_of(small.mesh));
  return again.mesh.faces.size() == 300 && topology.genus == 1 ? 0 : 1;
}
