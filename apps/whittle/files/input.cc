#include "files/input.hh"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "files/companions.hh"
#include "files/gltf_file.hh"
#include "files/mesh_output.hh"
#include "terminal/errors.hh"
#include "terminal/stopwatch.hh"
#include "terminal/table.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/io/border_gaps.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/file_notes.hh"
#include "whittle/simplify/values.hh"

namespace whittle::app {
namespace {

namespace fs = std::filesystem;

GltfScope gltf_scope_of(const FileOptions& options) {
  if (options.reads_shown) return GltfScope::shown;
  return options.reads_scene ? GltfScope::scene : GltfScope::meshes;
}

/// \throw UnsupportedMesh naming a vertex that is too far from the origin to compute with
void refuse_large_coordinates(const IndexedMesh& mesh, const std::string& name) {
  const auto bad = std::find_if_not(mesh.positions.begin(), mesh.positions.end(), is_in_range);
  if (bad == mesh.positions.end()) return;
  throw UnsupportedMesh(name + ": coordinates too large: vertex " +
                        std::to_string(mesh.origins[static_cast<std::size_t>(bad - mesh.positions.begin())]) +
                        ", counted from 0, lies at " + shortest(bad->x()) + ' ' + shortest(bad->y()) + ' ' +
                        shortest(bad->z()) + "; scale the mesh, or drop the vertex, to stay below 3e150");
}

std::string needs_format(const std::string& option) {
  return "'-' needs --format or " + option + ": one of " + io::format_names();
}

/// \throw UsageError with --ascii
bool writes_gltf(const std::string& path, const FileOptions& options) {
  if (!is_gltf_output(path, options)) return false;
  if (!options.ascii) return true;
  throw UsageError("--ascii is for " + io::titles_with_text_and_binary() + "; glTF is text in a .gltf file");
}

/// \throw UsageError if neither name nor options tell it
io::Format output_format(const std::string& path, const FileOptions& options) {
  if (options.output_format) return *options.output_format;
  if (const std::optional<io::Format> by_name = format_by_name(path)) return *by_name;
  if (options.format) return *options.format;
  if (path == standard_stream) throw UsageError(needs_format("--output-format"));
  try {
    return io::format_of(path);
  } catch (const std::invalid_argument& error) {
    std::string problem = error.what();
    const std::size_t remedy = problem.find("not supported; ");  // helps who reads such a file
    if (remedy != std::string::npos) problem = problem.substr(0, remedy) + "not supported; use " + io::format_titles();
    throw UsageError(path + ": " + problem);
  }
}

}  // namespace

bool reads_gltf(const std::string& path, const FileOptions& options) {
  if (!options.reads_gltf) return false;
  return options.has_input_format() ? options.input_is_gltf : is_gltf(path);
}

std::optional<io::Format> format_by_name(const std::string& path) {
  try {
    return io::format_of(path);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

io::Format format_for_output(const std::string& path, const FileOptions& options) {
  const io::Format format = output_format(path, options);
  if (options.ascii && !io::has_text_and_binary(format)) {
    throw UsageError("--ascii is for " + io::titles_with_text_and_binary() + "; " + std::string(io::title_of(format)) +
                     " is always written the same way");
  }
  return format;
}

namespace {

/// \throw UsageError for an output, io::ReadError for an input that is glTF where that isn't taken
void refuse_gltf(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                 const FileOptions& options) {
  const auto is_packed = [](const std::string& path) {
    return io::has_gzip_extension(path) && is_gltf(path.substr(0, path.rfind('.')));
  };
  for (const std::string& input : inputs) {
    if (options.has_input_format()) break;
    if (is_packed(input)) throw io::ReadError(input, "is glTF packed with gzip: unpack it first");
    if (options.reads_gltf || !is_gltf(input)) continue;
    throw io::ReadError(
        input, "is glTF, which this command doesn't read; 'whittle convert' makes " + io::format_titles() + " of it");
  }
  for (const std::string& output : outputs) {
    if (options.output_format) break;
    if (is_packed(output)) throw UsageError(output + ": glTF isn't packed with gzip: leave out the extension .gz");
    if (options.writes_gltf || !is_gltf(output)) continue;
    throw UsageError(output + ": this command doesn't write glTF; write " + io::format_titles() +
                     ", and 'whittle convert' makes glTF of it");
  }
}

}  // namespace

void check_formats(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                   const FileOptions& options) {
  refuse_gltf(inputs, outputs, options);
  const auto n_standard = std::count(inputs.begin(), inputs.end(), standard_stream);
  if (n_standard > 1) throw UsageError("only one of the inputs can be standard input ('-')");
  if (n_standard == 1 && options.input_is_gltf) throw UsageError("glTF isn't read from standard input ('-')");
  if (n_standard == 1 && !options.format && !options.input_format) throw UsageError(needs_format("--input-format"));
  const auto is_told = [&options](const std::string& path) {
    return format_by_name(path).has_value() || (options.reads_gltf && is_gltf(path));
  };
  if (options.format && (options.has_input_format() || std::all_of(inputs.begin(), inputs.end(), is_told)) &&
      (options.output_format || std::all_of(outputs.begin(), outputs.end(), is_told))) {
    throw UsageError(
        "--format is for '-' and for names that don't tell the format; here every name does, or another option");
  }
  const bool welds_gaps = options.weld_tolerance.is_automatic || options.weld_tolerance.length.value > 0;
  const auto is_read_as_gltf = [&options](const std::string& path) { return reads_gltf(path, options); };
  if (welds_gaps && !options.reads_scene && std::any_of(inputs.begin(), inputs.end(), is_read_as_gltf)) {
    throw UsageError("--weld doesn't take glTF that stays glTF: its meshes are welded at equal positions alone");
  }
  for (const std::string& output : outputs) {
    if (!writes_gltf(output, options)) format_for_output(output, options);
  }
}

MeshFile::MeshFile(std::string path, const FileOptions& options)
    : path_(std::move(path)), takes_no_triangles_(options.takes_no_triangles), scope_(gltf_scope_of(options)) {
  format_ = options.input_format;
  if (!format_ && !format_by_name(path_)) format_ = options.format;
  if (path_ == standard_stream) standard_input_ = io::read_all(STDIN_FILENO, standard_input_name);
  if (reads_gltf(path_, options)) gltf_ = std::make_shared<GltfFile>(path_);
}

io::ReadResult MeshFile::read(bool weld, unsigned threads, io::AttributeScope attributes) const {
  const io::ReadOptions options{.weld = weld, .format = format_, .threads = threads, .attributes = attributes};
  io::ReadResult result = gltf_                      ? gltf_->read(options, scope_)
                          : path_ == standard_stream ? io::read_mesh(standard_input_, standard_input_name, options)
                                                     : io::read_mesh(path_, options);
  if (result.mesh.faces.empty() && !takes_no_triangles_) throw io::ReadError(name(), why_no_faces(result));
  refuse_large_coordinates(result.mesh, name());
  return result;
}

std::string format_name(const io::ReadResult& read, const MeshFile& file) {
  return file.gltf() ? "gltf" : std::string(io::name_of(read.format));
}

std::string format_title(const io::ReadResult& read, const MeshFile& file) {
  return file.gltf() ? "glTF" : std::string(io::title_of(read.format));
}

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

bool keeps_meshes(const Input& input) { return input.gltf && input.gltf->scope() == GltfScope::meshes; }

std::string about(const std::string& name, const std::string& text) { return name + ": " + text; }

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

namespace {

/// The files that an input needs beside it, which have not to be there.
std::vector<fs::path> files_needed_by(const Input& input) {
  if (input.path == standard_stream) return {};
  const fs::path folder = folder_of(input.path);
  std::vector<fs::path> files = input.gltf ? input.gltf->asset().buffer_files() : std::vector<fs::path>{};
  const std::vector<fs::path> images =
      input.gltf ? input.gltf->asset().image_files() : io::referenced_files(input.read.notes, folder);
  files.insert(files.end(), images.begin(), images.end());
  for (fs::path& file : files) file = folder / file;
  return files;
}

}  // namespace

Input read_input(const std::string& path, const FileOptions& options, unsigned threads, const Talk& talk,
                 io::AttributeScope attributes) {
  const Stopwatch watch;
  const MeshFile file(path, options);
  const std::string name = file.name();
  Input input{path, name, file.read(options.weld, threads, attributes), {}};
  input.format = format_name(input.read, file);
  input.gltf = file.gltf();
  input.needed_files = files_needed_by(input);
  input.mesh_name = fs::path(path).filename().stem().string();
  input.weld_tolerance = weld_gaps(input.read, options.weld_tolerance, threads);
  input.seconds = watch.seconds();
  if (input.read.repairs.any() && !input.read.mesh.faces.empty())
    talk.say(name + ": " + io::to_string(input.read.repairs));
  for (const std::string& warning : input.read.warnings) {
    input.warnings.push_back(about(name, warning));
    talk.warning(input.warnings.back());
  }
  talk.detail(name + ": read " + vertices_text(input.read.mesh.positions.size()) + ", " +
              faces_text(input.read.mesh.faces.size()));
  return input;
}

}  // namespace whittle::app
