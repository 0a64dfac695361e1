#include "files/mesh_output.hh"

#include <stdexcept>

#include "terminal/errors.hh"
#include "whittle/io/path_of.hh"
#include "whittle/pipeline/simplify_file.hh"

namespace whittle::app {
namespace {

/// \throw UsageError if neither name nor options tell it
const SceneFormat& output_format(const std::string& path, const FileOptions& options) {
  if (options.output_format != nullptr) return *options.output_format;
  if (const SceneFormat* const by_name = format_by_name(path); by_name != nullptr) return *by_name;
  if (options.format != nullptr) return *options.format;
  if (path == standard_stream) throw UsageError(needs_format("--output-format"));
  try {
    return format_of(io::format_of(io::path_of(path)));
  } catch (const std::invalid_argument& error) {
    std::string problem = error.what();
    const std::size_t remedy = problem.find("not supported; ");  // helps who reads such a file
    if (remedy != std::string::npos) problem = problem.substr(0, remedy) + "not supported; use " + io::format_titles();
    throw UsageError(path + ": " + problem);
  }
}

void tell(const SceneMessages& messages, const Talk& talk, std::vector<std::string>& warnings) {
  for (const std::string& note : messages.notes) talk.say(note);
  for (const std::string& warning : messages.warnings) talk.warning(warning);
  warnings.insert(warnings.end(), messages.warnings.begin(), messages.warnings.end());
}

}  // namespace

const SceneFormat& format_for_output(const std::string& path, const FileOptions& options) {
  const SceneFormat& format = output_format(path, options);
  if (options.ascii && !format.has_text_and_binary) {
    throw UsageError("--ascii is for " + io::titles_with_text_and_binary() + "; " + std::string(format.title) +
                     (format.is_document ? " is text in a .gltf file" : " is always written the same way"));
  }
  return format;
}

bool writes_document(const std::string& path, const FileOptions& options) {
  const SceneFormat* const format = options.output_format != nullptr ? options.output_format : format_by_name(path);
  return options.writes_documents && format != nullptr && format->is_document;
}

void check_rounding(const std::string& path, const FileOptions& options, const gltf::WriteOptions& gltf) {
  if (!gltf.rounds() || writes_document(path, options)) return;
  const std::string names = rounding_options(gltf);
  throw UsageError(names + (names.find(' ') == std::string::npos ? " is" : " are") + " for outputs in glTF");
}

SceneScope scope_for(const std::string& path, const FileOptions& options, bool keeps_attributes) {
  return whittle::scope_for(writes_document(path, options) ? format_by_name(path) : nullptr, keeps_attributes);
}

std::string needs_format(const std::string& option) {
  return "'-' needs --format or " + option + ": one of " + io::format_names();
}

SceneOutput output_of(const std::string& path, const FileOptions& options, const gltf::WriteOptions& gltf) {
  return {path, &format_for_output(path, options), options.ascii, gltf};
}

void write_result(OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh& mesh,
                  const Talk& talk, std::vector<std::string>& warnings) {
  SceneMessages messages;
  write_scene(files, output, scene, mesh, messages);
  tell(messages, talk, warnings);
}

void write_levels(OutputFiles& files, const SceneOutput& output, Scene& scene, CoarserLevels levels, const Talk& talk,
                  std::vector<std::string>& warnings) {
  SceneMessages messages;
  whittle::write_levels(files, output, scene, levels, messages);
  tell(messages, talk, warnings);
}

}  // namespace whittle::app
