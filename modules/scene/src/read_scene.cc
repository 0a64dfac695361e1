#include "whittle/scene/read_scene.hh"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "whittle/core/detail/checks.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/text/text.hh"
#include "whittle/io/border_gaps.hh"
#include "whittle/io/path_of.hh"

namespace whittle {
namespace {

/// \throw UnsupportedMesh naming a vertex that is too far from the origin to compute with
void refuse_large_coordinates(const IndexedMesh& mesh, const std::string& name) {
  const auto bad = std::find_if_not(mesh.positions.begin(), mesh.positions.end(), is_in_range);
  if (bad == mesh.positions.end()) return;
  throw UnsupportedMesh(name + ": coordinates too large: vertex " +
                        std::to_string(mesh.origins[static_cast<std::size_t>(bad - mesh.positions.begin())]) +
                        ", counted from 0, lies at " + shortest(bad->x()) + ' ' + shortest(bad->y()) + ' ' +
                        shortest(bad->z()) + "; scale the mesh, or drop the vertex, to stay below 3e150");
}

/// Welds vertices that lie near each other, if `tolerance` asks for that. \return to which length, model units; 0: not
double weld_gaps(io::ReadResult& read, const AutomaticLength& tolerance, unsigned threads) {
  const double length = tolerance.is_automatic ? io::find_border_gaps(read.mesh).tolerance()
                                               : tolerance.length.in_units(diagonal_of(read.mesh.positions));
  if (length == 0) {
    if (tolerance.is_automatic)
      read.warnings.emplace_back("no gaps between borders, '--weld auto' welds exact duplicates alone");
    return 0;
  }
  std::vector<Index> welded;
  read.repairs += io::weld_gaps(read.mesh, length, &welded, threads);
  for (Index& v : read.vertex_map) v = v == invalid_index ? v : welded[v];
  return length;
}

/// What is done with every scene. \pre it has its path and its name
void finish(Scene& scene, const SceneReadOptions& options) {
  if (scene.read.mesh.faces.empty() && !options.takes_no_triangles) {
    throw io::ReadError(scene.name, why_no_faces(scene.read));
  }
  refuse_large_coordinates(scene.read.mesh, scene.name);
  scene.weld_tolerance = weld_gaps(scene.read, options.weld_tolerance, options.threads);
  for (const std::string& warning : scene.read.warnings) scene.warnings.push_back(about(scene.name, warning));
}

}  // namespace

SceneFile::SceneFile(std::string path, const SceneFormat* format)
    : path_(std::move(path)), format_(format != nullptr ? format : format_by_name(path_)) {
  if (path_ == standard_stream) content_ = io::read_all(STDIN_FILENO, name());
}

std::string SceneFile::name() const { return path_ == standard_stream ? "standard input" : path_; }

Scene SceneFile::read(const SceneReadOptions& options) const {
  const SceneFormat& format =
      format_ != nullptr ? *format_ : *scene_formats().front();  // its reader reports the problem
  Scene scene = format.read(*this, options);
  scene.path = path_;
  scene.name = name();
  scene.mesh_name = io::path_of(path_).filename().stem().string();
  finish(scene, options);
  return scene;
}

Scene scene_of(IndexedMesh mesh, const std::string& name, std::vector<double> tolerances,
               const SceneReadOptions& options) {
  Scene scene;
  scene.name = scene.mesh_name = name;
  scene.read = io::take_mesh(std::move(mesh), name,
                             {.weld = options.weld, .threads = options.threads, .attributes = options.attributes});
  scene.read.tolerances = std::move(tolerances);
  scene.format = &format_of(scene.read.format);
  finish(scene, options);
  return scene;
}

IndexedMesh shown_scene(const Scene& scene, SceneReadOptions options) {
  options.scope = SceneScope::scene;
  return SceneFile(scene.path, scene.format).read(options).read.mesh;
}

Scene read_scene(const std::string& path, const SceneReadOptions& options) { return SceneFile(path).read(options); }

}  // namespace whittle
