#include "bench/meshes.hh"

#include "bench/subdivision.hh"
#include "support/meshes.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/io/read.hh"

namespace whittle::bench {
namespace {

// A fifth of an edge is about the noise of a scanner with good resolution.
constexpr double noise = 0.2;
constexpr std::uint64_t noise_seed = 1;

IndexedMesh noisy_sphere(int frequency) { return with_noise(geodesic_sphere(frequency), noise, noise_seed); }

IndexedMesh noisy_subdivided(const std::optional<std::filesystem::path>& base, int n_steps) {
  // As many faces as the scanned armadillo that is often used as a test mesh, 86,482.
  IndexedMesh mesh = base ? io::read_mesh(*base).mesh : test::knot(800, 54);
  for (int step = 0; step < n_steps; ++step) mesh = loop_subdivided(mesh);
  return with_noise(std::move(mesh), noise, noise_seed);
}

}  // namespace

std::vector<Case> made_cases(const std::optional<std::filesystem::path>& base) {
  return {{"sphere-70k", [] { return noisy_sphere(59); }},
          {"loop-346k", [base] { return noisy_subdivided(base, 1); }},
          {"loop-1384k", [base] { return noisy_subdivided(base, 2); }},
          {"cube-307k", [] { return test::tessellated_cube(160); }},
          {"terrain-349k", [] { return test::terrain(418, noise_seed); }},
          {"sphere-1394k", [] { return noisy_sphere(264); }}};
}

Case file_case(const std::filesystem::path& path) {
  return {path.stem().string(), [path] { return io::read_mesh(path).mesh; }};
}

Case permuted(const Case& original, std::uint64_t seed) {
  return {original.name + "/permuted", [original, seed] { return test::permuted(original.make(), seed).mesh; }};
}

}  // namespace whittle::bench
