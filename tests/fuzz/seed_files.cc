#include "fuzz/seed_files.hh"

#include <sstream>

#include "support/shapes/shapes.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

constexpr char weld = 1;

SeedFile written(const IndexedMesh& mesh, io::Format format, const io::WriteOptions& options) {
  std::ostringstream out;
  io::write_mesh(out, format, mesh, options);
  return {format, weld + out.str()};
}

IndexedMesh with_attributes(IndexedMesh mesh) {
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  mesh.colors.assign(mesh.positions.size(), {0.25F, 0.5F, 1, 0.75F});
  return mesh;
}

}  // namespace

std::vector<SeedFile> seed_files() {
  using namespace std::string_literals;
  const std::vector<IndexedMesh> meshes = {octahedron(), with_attributes(tetrahedron()), soup(cube()),
                                           two_cubes_on_an_edge(), soup(two_cubes_on_an_edge())};
  std::vector<SeedFile> files;
  for (const IndexedMesh& mesh : meshes) {
    for (const io::Format format : io::all_formats) {
      files.push_back(written(mesh, format, {.ascii = true}));
      files.push_back(written(mesh, format, {}));
      files.push_back(written(mesh, format, {.gzip = true}));
    }
  }
  files.push_back(
      {io::Format::obj, weld + "mtllib a\nv 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0.5 0.25 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
                               "usemtl b\nf 1/1/1 2/1/1 3/1/1 4/1/1 5/1/1\nf -5//-1 -4//1 \\\n -3\ns 1\nl 1 2\n"s});
  files.push_back({io::Format::off, weld +
                                        "STCNOFF\n4 2 0 # counts\n0 0 0 0 0 1 255 0 0 0 0\n1 0 0 0 0 1 9 9 9 0 0\n"
                                        "1 1 0 0 0 1 0 0 0 1 1\n0 1 0 0 0 1 0 0 0 0 1\n4 0 1 2 3 1 0 0\n3 0 1 2\n"s});
  files.push_back(
      {io::Format::off, weld + "OFF BINARY\n\0\0\0\3\0\0\0\1\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x3F\x80\0\0\0\0\0\0"
                               "\0\0\0\0\0\0\0\0\x3F\x80\0\0\0\0\0\0\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\0"s});
  files.push_back(
      {io::Format::ply, weld + "ply\nformat ascii 1.0\nelement vertex 5\nproperty list uchar int many\n"
                               "property double x\nproperty float y\nproperty short z\nproperty float quality\n"
                               "element tristrips 1\nproperty list int int vertex_indices\nelement face 1\n"
                               "property list uchar uint vertex_index\nproperty float f\nelement edge 1\n"
                               "property int a\nend_header\n0 0 0 0 0\n1 7 1 0 0 0\n0 1 1 0 0\n0 0 1 0 0\n"
                               "2 8 9 5 5 5 0\n8 0 1 2 3 -1 2 3 4\n5 0 1 2 3 4 0.5\n7\n"s});
  files.push_back({io::Format::ply, weld + "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\n"
                                           "property uchar y\nproperty char z\nelement face 1\n"
                                           "property list ushort short vertex_indices\nend_header\n"
                                           "\0\1\2\3\0\4\5\6\0\7\7\7\0\3\0\0\0\1\0\2"s});
  return files;
}

}  // namespace whittle::test
