// Reports the progress of a run and cancels it. The result is a valid mesh all the same.
#include <cstdio>
#include <string>
#include <whittle/simplify/simplify.hh>

#include "torus.hh"

int main() {
  const Torus torus(200, 100);
  whittle::IndexedMesh mesh;
  for (const auto& p : torus.points) mesh.positions.emplace_back(p[0], p[1], p[2]);
  for (const auto& face : torus.faces) mesh.faces.push_back({face[0], face[1], face[2]});

  // Called now and then, on the thread that called `simplify`. Returning false ends the run. A program with a window
  // would draw a progress bar here, and check whether its cancel button was pressed.
  unsigned n_calls = 0;
  double fraction = 0;
  bool is_falling = false;
  whittle::SimplifyOptions options;
  options.decimate.progress = [&](const whittle::Progress& progress) {
    ++n_calls;
    is_falling = is_falling || progress.fraction < fraction;
    fraction = progress.fraction;
    return progress.fraction < 0.5;
  };
  const whittle::DecimateTarget target = whittle::DecimateTarget::faces(1000);
  const whittle::Simplification stopped = whittle::simplify(mesh, target, whittle::Effort::normal, options);

  // The result says that it was cancelled. It has fewer faces than the input, but hasn't reached the target.
  const std::size_t n_faces = stopped.mesh.faces.size();
  std::printf("%s after %u calls: %zu faces became %zu\n", std::string(whittle::to_string(stopped.result.stop)).c_str(),
              n_calls, mesh.faces.size(), n_faces);
  const bool is_between = n_faces > 1000 && n_faces < mesh.faces.size();
  return stopped.result.stop == whittle::StopReason::cancelled && is_between && !is_falling ? 0 : 1;
}
