#include <fstream>
#include <stdexcept>

#include "bench/max_error/contenders/contender.hh"
#include "bench/processes/process.hh"
#include "support/temporary_folder.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

// MeshLab's quadric edge collapse, which is vcglib's, as a process from file to file. With its defaults, but that
// normals and borders are preserved, which brings it nearer to the input.

namespace whittle::bench {
namespace {

constexpr double limit_s = 1000;  // the benchmark has its own

std::string script(int n_faces) {
  return R"(<!DOCTYPE FilterScript><FilterScript><filter name="Simplification: Quadric Edge Collapse Decimation">
<Param name="TargetFaceNum" type="RichInt" value=")" +
         std::to_string(n_faces) + R"("/>
<Param name="TargetPerc" type="RichFloat" value="0"/>
<Param name="QualityThr" type="RichFloat" value="0.3"/>
<Param name="PreserveBoundary" type="RichBool" value="true"/>
<Param name="BoundaryWeight" type="RichFloat" value="1"/>
<Param name="PreserveNormal" type="RichBool" value="true"/>
<Param name="PreserveTopology" type="RichBool" value="false"/>
<Param name="OptimalPlacement" type="RichBool" value="true"/>
<Param name="PlanarQuadric" type="RichBool" value="false"/>
<Param name="PlanarWeight" type="RichFloat" value="0.001"/>
<Param name="QualityWeight" type="RichBool" value="false"/>
<Param name="AutoClean" type="RichBool" value="true"/>
<Param name="Selected" type="RichBool" value="false"/>
</filter></FilterScript>)";
}

}  // namespace

IndexedMesh by_meshlab(const IndexedMesh& input, double n_faces) {
  const test::TemporaryFolder folder;
  IndexedMesh geometry;
  geometry.positions = input.positions;
  geometry.faces = input.faces;
  io::write_mesh(folder / "in.ply", geometry);
  std::ofstream(folder / "script.mlx") << script(static_cast<int>(n_faces));
  const ProcessRun run =
      run_process({"meshlabserver", "-i", folder / "in.ply", "-o", folder / "out.ply", "-s", folder / "script.mlx"},
                  folder / "log", limit_s);
  if (!run.failure.empty()) throw std::runtime_error("meshlabserver " + run.failure);
  return io::read_mesh(folder / "out.ply").mesh;
}

}  // namespace whittle::bench
