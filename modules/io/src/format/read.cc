#include "whittle/io/read.hh"

#include <numeric>
#include <stdexcept>
#include <utility>

#include "bytes/file_bytes.hh"
#include "bytes/gzip.hh"
#include "format/content.hh"
#include "format/format_row.hh"
#include "format/mesh_builder.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/float32_positions.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/path_of.hh"

namespace whittle::io {

namespace {

Format choose_format(std::string_view name, const ReadOptions& options) {
  if (options.format) return *options.format;
  try {
    return format_of(path_of(name));
  } catch (const std::invalid_argument& problem) {
    throw ReadError(std::string(name), problem.what());
  }
}

ReadResult parse_unpacked(std::string_view bytes, std::string_view name, Format format, const ReadOptions& options) {
  refuse_wrong_content(bytes, name, format);
  return row_of(format).read(bytes, name, options);
}

// The content tells whether it is packed, not the name: servers unpack files and leave their names, or the reverse.
ReadResult parse(std::string_view bytes, std::string_view name, Format format, const ReadOptions& options) {
  if (!is_gzip(bytes)) return parse_unpacked(bytes, name, format, options);
  const std::vector<char> unpacked = gunzip(bytes, name);
  return parse_unpacked({unpacked.data(), unpacked.size()}, name, format, options);
}

void finish(ReadResult& result, std::string_view name, const ReadOptions& options, Format format) {
  result.format = format;
  if (result.file_faces == 0) {
    throw ReadError(std::string(name), result.file_vertices == 0
                                           ? "the file has no faces"
                                           : "the file has " + std::to_string(result.file_vertices) +
                                                 " vertices but no faces; point clouds are not supported");
  }
  if (result.mesh.faces.size() > most_elements) {
    throw ReadError(std::string(name),
                    "the polygons have more than the " + std::to_string(most_elements) + " triangles a mesh can have");
  }
  result.notes.has_float32_positions = fit_float32(result.mesh.positions);
  std::vector<Index> joined_to;
  result.repairs += repair(result.mesh, options.weld, &joined_to, options.threads);
  if (result.mesh.faces.empty()) {
    throw ReadError(std::string(name), "no face is left of " + std::to_string(result.file_faces) +
                                           ": all are degenerate (" + to_string(result.repairs) + ")");
  }
  if (options.attributes == AttributeScope::per_vertex) drop_seams(result.mesh);
  result.vertex_map = vertex_map_of(result.mesh, result.file_vertices, joined_to);
}

}  // namespace

ReadResult read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string name = path.string();
  refuse_what_is_no_file(path);
  const Format format = choose_format(name, options);
  ReadResult result = [&] {
    const FileBytes file(path);  // Freed before the repairs need memory.
    return parse(file.view(), name, format, options);
  }();
  finish(result, name, options, format);
  return result;
}

ReadResult read_mesh(std::span<const char> bytes, std::string_view name, const ReadOptions& options) {
  const Format format = choose_format(name, options);
  ReadResult result = parse(std::string_view(bytes.data(), bytes.size()), name, format, options);
  finish(result, name, options, format);
  return result;
}

ReadResult take_mesh(IndexedMesh mesh, std::string_view name, const ReadOptions& options) {
  if (mesh.faces.empty()) throw ReadError(std::string(name), "there are no faces");
  ReadResult result;
  result.file_vertices = mesh.positions.size();
  result.file_faces = mesh.faces.size();
  mesh.origins.resize(mesh.positions.size());
  std::iota(mesh.origins.begin(), mesh.origins.end(), Index{0});
  result.mesh = std::move(mesh);
  finish(result, name, options, Format::ply);
  return result;
}

}  // namespace whittle::io
