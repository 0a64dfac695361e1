// Makes the meshes of this folder. `whittle_data FOLDER` writes them; `whittle_data --check FOLDER` compares instead
// and fails with the names of the files that differ, are missing, or aren't made here.
#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>
#include <whittle/io/format.hh>
#include <whittle/io/write.hh>

#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace {

using whittle::IndexedMesh;
using whittle::Vec3;
namespace fs = std::filesystem;
namespace shapes = whittle::test;

struct DataMesh {
  std::string name;
  IndexedMesh mesh;
  bool ascii = false;
};

/// Rounds coordinates to six decimals, with 0 for −0. For text: files are short, and the last bit of a C library's sine
/// has no effect.
IndexedMesh with_decimals(IndexedMesh mesh) {
  for (Vec3& p : mesh.positions)
    for (double& x : p) x = std::round(x * 1e6) / 1e6 + 0.0;
  return mesh;
}

/// Rounds coordinates to 24 bits, as binary files hold them.
IndexedMesh with_floats(IndexedMesh mesh) {
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
  return mesh;
}

/// Green valleys, brown slopes, white tops.
IndexedMesh coloured_by_height(IndexedMesh mesh) {
  double low = mesh.positions.front().z();
  double high = low;
  for (const Vec3& p : mesh.positions) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  for (const Vec3& p : mesh.positions) {
    // In steps of 1/20, so that rounding of the height has no effect on the 8 bits of a colour.
    const auto t = static_cast<float>(std::round(20 * (p.z() - low) / (high - low)) / 20);
    mesh.colors.push_back({t, 0.4F + 0.6F * t * t, t * t, 1.0F});
  }
  return mesh;
}

IndexedMesh nonmanifold() {
  const IndexedMesh cubes = shapes::two_cubes_on_an_edge(6);
  const IndexedMesh bow_tie = shapes::moved(shapes::bow_tie(), Vec3(8, 0, 0));
  const IndexedMesh fan = shapes::moved(shapes::three_faces_on_an_edge(), Vec3(-4, 0, 0));
  return shapes::joined(shapes::joined(cubes, bow_tie), fan);
}

std::vector<DataMesh> all_meshes() {
  return {{"knot.ply", with_floats(shapes::knot(400, 64))},
          {"blob.obj", with_decimals(shapes::blob(4, 12))},
          {"terrain.ply", with_decimals(coloured_by_height(shapes::terrain(48, 5))), true},
          {"cylinder.off", with_decimals(shapes::open_cylinder(48, 24))},
          {"bracket.stl", with_floats(shapes::bracket(8))},
          {"cubes.obj", with_decimals(shapes::boxes(5, 5, 0.2))},
          {"flat.off", shapes::grid(24, 24)},
          {"nonmanifold.obj", with_decimals(nonmanifold())}};
}

std::string bytes_of(const DataMesh& entry) {
  std::ostringstream out;
  whittle::io::write_mesh(out, whittle::io::format_of(entry.name), entry.mesh, {.ascii = entry.ascii});
  return out.str();
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_all(const fs::path& folder) {
  fs::create_directories(folder);
  for (const DataMesh& entry : all_meshes())
    whittle::io::write_mesh(folder / entry.name, entry.mesh, {.ascii = entry.ascii});
}

/// \return the number of files that differ, are missing, or aren't made here.
int check_all(const fs::path& folder) {
  const std::vector<DataMesh> meshes = all_meshes();
  int wrong = 0;
  const auto complain = [&](const fs::path& path, const char* what) {
    std::cerr << path.string() << ' ' << what << '\n';
    ++wrong;
  };
  for (const DataMesh& entry : meshes) {
    const fs::path path = folder / entry.name;
    if (!fs::exists(path)) {
      complain(path, "is missing");
    } else if (bytes_of(path) != bytes_of(entry)) {
      complain(path, "is not what the generator writes");
    }
  }
  for (const auto& file : fs::directory_iterator(folder)) {
    const std::string ending = file.path().extension().string();
    const bool is_mesh = ending == ".obj" || ending == ".off" || ending == ".ply" || ending == ".stl";
    const bool is_made =
        std::ranges::any_of(meshes, [&](const DataMesh& m) { return file.path().filename() == m.name; });
    if (is_mesh && !is_made) complain(file.path(), "is not made by the generator");
  }
  return wrong;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() == 2 && arguments[0] == "--check") return check_all(arguments[1]) == 0 ? 0 : 1;
    if (arguments.size() == 1 && arguments[0] != "--check") {
      write_all(arguments[0]);
      return 0;
    }
  } catch (const std::exception& error) {
    std::cerr << "whittle_data: " << error.what() << '\n';
    return 1;
  }
  std::cerr << "usage: whittle_data [--check] FOLDER\n";
  return 2;
}
