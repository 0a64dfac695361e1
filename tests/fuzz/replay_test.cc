// Mutations of small files of every format. Each gives an error or a valid mesh, and no single allocation is larger
// than the file justifies. The environment variables WHITTLE_FUZZ_RUNS and WHITTLE_FUZZ_SEED ask for more runs and
// other seeds.
#include <gtest/gtest.h>

#include <cstdlib>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/largest_allocation.hh"
#include "fuzz/mutate.hh"
#include "fuzz/read_and_check.hh"
#include "support/random.hh"
#include "support/shapes.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::stoull(text) : otherwise;
}

std::string written(const IndexedMesh& mesh, io::Format format, const io::WriteOptions& options) {
  std::ostringstream out;
  io::write_mesh(out, format, mesh, options);
  return choice_of(format, true) + out.str();
}

IndexedMesh with_attributes(IndexedMesh mesh) {
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  mesh.colors.assign(mesh.positions.size(), {0.25F, 0.5F, 1, 0.75F});
  return mesh;
}

// Each format as our writer writes it, and by hand features that our writers don't use.
std::vector<std::string> seeds() {
  using namespace std::string_literals;
  const std::vector<IndexedMesh> meshes = {octahedron(), with_attributes(tetrahedron()), soup(cube()),
                                           two_cubes_on_an_edge(), soup(two_cubes_on_an_edge())};
  std::vector<std::string> files;
  for (const IndexedMesh& mesh : meshes) {
    for (const io::Format format : io::all_formats) {
      files.push_back(written(mesh, format, {.ascii = true}));
      files.push_back(written(mesh, format, {}));
      files.push_back(written(mesh, format, {.gzip = true}));
    }
  }
  const char obj = choice_of(io::Format::obj, true);
  const char off = choice_of(io::Format::off, true);
  const char ply = choice_of(io::Format::ply, true);
  files.push_back(obj +
                  "mtllib a\nv 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0.5 0.25 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
                  "usemtl b\nf 1/1/1 2/1/1 3/1/1 4/1/1 5/1/1\nf -5//-1 -4//1 \\\n -3\ns 1\nl 1 2\n"s);
  files.push_back(off +
                  "STCNOFF\n4 2 0 # counts\n0 0 0 0 0 1 255 0 0 0 0\n1 0 0 0 0 1 9 9 9 0 0\n"
                  "1 1 0 0 0 1 0 0 0 1 1\n0 1 0 0 0 1 0 0 0 0 1\n4 0 1 2 3 1 0 0\n3 0 1 2\n"s);
  files.push_back(off +
                  "OFF BINARY\n\0\0\0\3\0\0\0\1\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x3F\x80\0\0\0\0\0\0"
                  "\0\0\0\0\0\0\0\0\x3F\x80\0\0\0\0\0\0\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\0"s);
  files.push_back(ply +
                  "ply\nformat ascii 1.0\nelement vertex 5\nproperty list uchar int many\n"
                  "property double x\nproperty float y\nproperty short z\nproperty float quality\n"
                  "element tristrips 1\nproperty list int int vertex_indices\nelement face 1\n"
                  "property list uchar uint vertex_index\nproperty float f\nelement edge 1\n"
                  "property int a\nend_header\n0 0 0 0 0\n1 7 1 0 0 0\n0 1 1 0 0\n0 0 1 0 0\n"
                  "2 8 9 5 5 5 0\n8 0 1 2 3 -1 2 3 4\n5 0 1 2 3 4 0.5\n7\n"s);
  files.push_back(ply +
                  "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\n"
                  "property uchar y\nproperty char z\nelement face 1\n"
                  "property list ushort short vertex_indices\nend_header\n"
                  "\0\1\2\3\0\4\5\6\0\7\7\7\0\3\0\0\0\1\0\2"s);
  return files;
}

TEST(FuzzIo, EveryMutationGivesAnErrorOrAValidMesh) {
  const std::uint64_t runs = from_environment("WHITTLE_FUZZ_RUNS", 300);
  const std::uint64_t first_seed = from_environment("WHITTLE_FUZZ_SEED", 1);
  const std::vector<std::string> files = seeds();
  for (std::size_t f = 0; f < files.size(); ++f) {
    for (std::uint64_t seed = first_seed; seed < first_seed + runs; ++seed) {
      Random random(seed * 1000 + f);
      std::string file = mutated(files[f], random);
      if (random.below(16) == 0) file += files[random.below(files.size())].substr(1);
      // Vectors grow by doubling. A position takes 24 bytes in memory, and possibly only three in the file. Buffers
      // take 1 MiB.
      const std::size_t justified = 64 * file.size() + (std::size_t{1} << 20);
      largest_allocation = 0;
      try {
        read_and_check(file);
      } catch (const std::exception& error) {
        FAIL() << error.what() << ": file " << f << ", seed " << seed << "\n" << file;
      }
      ASSERT_LE(largest_allocation, justified) << "file " << f << ", seed " << seed << "\n" << file;
    }
  }
}

// Mutations need valid files to start from.
TEST(FuzzIo, EverySeedIsAValidFile) {
  for (const std::string& file : seeds()) {
    const std::string_view bytes = std::string_view(file).substr(1);
    const io::Format format = format_chosen(file[0]);
    EXPECT_NO_THROW(io::read_mesh(bytes, "seed", {.format = format})) << bytes;
  }
}

}  // namespace
}  // namespace whittle::test
