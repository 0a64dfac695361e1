#include <meshoptimizer.h>

#include <cfloat>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

// The smallest program that simplifies an OBJ file of triangles with meshoptimizer.
// meshoptimizer_obj IN OUT RATIO; it does not check the file.

int main(int argc, char** argv) {
  std::FILE* in = argc == 4 ? std::fopen(argv[1], "r") : nullptr;
  std::FILE* out = in != nullptr ? std::fopen(argv[2], "w") : nullptr;
  if (out == nullptr) return 1;
  std::vector<float> positions;
  std::vector<unsigned> indices;
  char line[256];
  while (std::fgets(line, sizeof(line), in) != nullptr) {
    char* at = line + 1;
    for (int i = 0; i < 3; ++i) {
      if (std::strncmp(line, "v ", 2) == 0) positions.push_back(std::strtof(at, &at));
      if (std::strncmp(line, "f ", 2) == 0) indices.push_back(static_cast<unsigned>(std::strtoul(at, &at, 10)) - 1);
    }
  }
  std::vector<unsigned> kept(indices.size());
  const auto wanted = static_cast<std::size_t>(std::atof(argv[3]) * static_cast<double>(indices.size() / 3)) * 3;
  kept.resize(meshopt_simplify(kept.data(), indices.data(), indices.size(), positions.data(), positions.size() / 3,
                               3 * sizeof(float), wanted, FLT_MAX, 0, nullptr));
  const std::size_t n_vertices = meshopt_optimizeVertexFetch(positions.data(), kept.data(), kept.size(),
                                                             positions.data(), positions.size() / 3, 3 * sizeof(float));
  for (const float* p = positions.data(); p < positions.data() + 3 * n_vertices; p += 3)
    std::fprintf(out, "v %g %g %g\n", static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
  for (std::size_t i = 0; i < kept.size(); i += 3)
    std::fprintf(out, "f %u %u %u\n", kept[i] + 1, kept[i + 1] + 1, kept[i + 2] + 1);
  return std::fclose(in) == 0 && std::fclose(out) == 0 ? 0 : 1;
}
