#pragma once

#include <string>
#include <vector>

#include "files/input.hh"
#include "files/output.hh"
#include "whittle/scene/write_scene.hh"

namespace whittle::app {

/// The format to write a file in: that of --output-format, otherwise the one by its name, otherwise that of --format.
/// \throw UsageError if there is neither, or if --ascii is given and the format has no choice of text.
const SceneFormat& format_for_output(const std::string& path, const FileOptions& options);
/// Whether a file is written as a document, such as glTF.
bool writes_document(const std::string& path, const FileOptions& options);
/// What to read of documents for an output, as the library has it.
SceneScope scope_for(const std::string& path, const FileOptions& options, bool keeps_attributes = true);
/// What is wrong with '-' where no option tells its format. \param option that would
std::string needs_format(const std::string& option);

/// \param compresses whether documents are compressed \throw as `format_for_output`
SceneOutput output_of(const std::string& path, const FileOptions& options, bool compresses = false);

/// As `write_scene`. Prints what it has to say, and adds its warnings to `warnings`.
void write_result(OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh& mesh,
                  const Talk& talk, std::vector<std::string>& warnings);
/// As the library has it, likewise.
void write_levels(OutputFiles& files, const SceneOutput& output, Scene& scene, CoarserLevels levels, const Talk& talk,
                  std::vector<std::string>& warnings);

}  // namespace whittle::app
