#include "files/input.hh"

#include <algorithm>
#include <utility>

#include "files/mesh_output.hh"
#include "terminal/errors.hh"
#include "whittle/core/progress.hh"
#include "whittle/core/text/text.hh"
#include "whittle/io/path_of.hh"
#include "whittle/scene/join_scenes.hh"

namespace whittle::app {
namespace {

/// Null if nothing tells it.
const SceneFormat* input_format(const std::string& path, const FileOptions& options) {
  if (options.input_format != nullptr) return options.input_format;
  const SceneFormat* const by_name = format_by_name(path);
  return by_name != nullptr ? by_name : options.format;
}

/// The title of a document that is packed with gzip. Empty if it is not one.
std::string_view title_of_packed_document(const std::string& path) {
  if (!io::has_gzip_extension(io::path_of(path))) return {};
  const SceneFormat* const format = format_by_name(path.substr(0, path.rfind('.')));
  return format != nullptr && format->is_document ? format->title : std::string_view();
}

/// \throw io::ReadError for a document that isn't read
void refuse_document_input(const std::string& input, const FileOptions& options) {
  if (const std::string title(title_of_packed_document(input)); !title.empty()) {
    throw io::ReadError(input, "is " + title + " packed with gzip: unpack it first");
  }
  const SceneFormat* const format = format_by_name(input);
  if (options.reads_documents || format == nullptr || !format->is_document) return;
  throw io::ReadError(input, "is " + std::string(format->title) +
                                 ", which this command doesn't read; 'whittle convert' makes " + io::format_titles() +
                                 " of it");
}

/// \throw UsageError for a document that isn't written
void refuse_document_output(const std::string& output, const FileOptions& options) {
  if (const std::string title(title_of_packed_document(output)); !title.empty()) {
    throw UsageError(output + ": " + title + " isn't packed with gzip: leave out the extension .gz");
  }
  const SceneFormat* const format = format_by_name(output);
  if (options.writes_documents || format == nullptr || !format->is_document) return;
  const std::string title(format->title);
  throw UsageError(output + ": this command doesn't write " + title + "; write " + io::format_titles() +
                   ", and 'whittle convert' makes " + title + " of it");
}

void check_standard_input(const std::vector<std::string>& inputs, const FileOptions& options) {
  const auto n_standard = std::count(inputs.begin(), inputs.end(), standard_stream);
  if (n_standard > 1) throw UsageError("only one of the inputs can be standard input ('-')");
  if (n_standard == 0) return;
  if (options.input_format != nullptr && options.input_format->is_document) {
    throw UsageError(std::string(options.input_format->title) + " isn't read from standard input ('-')");
  }
  if (options.format == nullptr && options.input_format == nullptr) throw UsageError(needs_format("--input-format"));
}

}  // namespace

bool reads_document(const std::string& path, const FileOptions& options) {
  const SceneFormat* const format = input_format(path, options);
  return options.reads_documents && format != nullptr && format->is_document;
}

void check_formats(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                   const FileOptions& options) {
  if (options.input_format == nullptr) {
    for (const std::string& input : inputs) refuse_document_input(input, options);
  }
  if (options.output_format == nullptr) {
    for (const std::string& output : outputs) refuse_document_output(output, options);
  }
  check_standard_input(inputs, options);
  const auto is_told = [](const std::string& path) { return format_by_name(path) != nullptr; };
  if (options.format != nullptr &&
      (options.input_format != nullptr || std::all_of(inputs.begin(), inputs.end(), is_told)) &&
      (options.output_format != nullptr || std::all_of(outputs.begin(), outputs.end(), is_told))) {
    throw UsageError(
        "--format is for '-' and for names that don't tell the format; here every name does, or another option");
  }
  const bool welds_gaps = options.weld_tolerance.is_automatic || options.weld_tolerance.length.value > 0;
  const auto is_document = [&options](const std::string& path) { return reads_document(path, options); };
  if (welds_gaps && options.scope != SceneScope::scene && std::any_of(inputs.begin(), inputs.end(), is_document)) {
    throw UsageError("--weld doesn't take glTF that stays glTF: its meshes are welded at equal positions alone");
  }
  for (const std::string& output : outputs) format_for_output(output, options);
}

SceneFile scene_file(const std::string& path, const FileOptions& options) {
  return SceneFile(path, input_format(path, options));
}

SceneReadOptions read_options(const FileOptions& options, unsigned threads, io::AttributeScope attributes) {
  return {.weld = options.weld,
          .weld_tolerance = options.weld_tolerance,
          .scope = options.scope,
          .takes_no_triangles = options.takes_no_triangles,
          .attributes = attributes,
          .threads = threads};
}

Input read_input(const std::string& path, const FileOptions& options, unsigned threads, const Talk& talk,
                 io::AttributeScope attributes) {
  const Stopwatch watch;
  Input input{scene_file(path, options).read(read_options(options, threads, attributes))};
  input.seconds = watch.seconds();
  const IndexedMesh& mesh = input.read.mesh;
  if (input.read.repairs.any() && !mesh.faces.empty()) talk.say(about(input.name, io::to_string(input.read.repairs)));
  for (const std::string& warning : input.warnings) talk.warning(warning);
  talk.detail(input.name + ": read " + vertices_text(mesh.positions.size()) + ", " + faces_text(mesh.faces.size()));
  return input;
}

Input read_joined(const std::vector<std::string>& paths, const FileOptions& options, unsigned threads, const Talk& talk,
                  io::AttributeScope attributes) {
  SceneJoiner joiner;
  double seconds = 0;
  std::size_t n_told = 0;
  for (const std::string& path : paths) {
    Input input = read_input(path, options, threads, talk, attributes);
    seconds += input.seconds;
    n_told += input.warnings.size();
    joiner.add(std::move(input));
  }
  Input joined{joiner.finish(), seconds};
  for (std::size_t i = n_told; i < joined.warnings.size(); ++i) talk.warning(joined.warnings[i]);
  return joined;
}

std::vector<std::uint8_t> held_borders(const Input& input, unsigned threads, const Talk& talk,
                                       std::vector<std::string>& warnings) {
  const std::size_t n_told = warnings.size();
  std::vector<std::uint8_t> held = whittle::held_borders(input, input.read.mesh, threads, warnings);
  for (std::size_t i = n_told; i < warnings.size(); ++i) talk.warning(warnings[i]);
  return held;
}

}  // namespace whittle::app
