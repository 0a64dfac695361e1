#pragma once

#include <string>
#include <vector>

#include "files/input.hh"
#include "files/output.hh"
#include "whittle/scene/write_scene.hh"

namespace whittle::app {

/// The format of a file to write: by --output-format, otherwise by its name, otherwise by --format.
/// \throw UsageError without a format, or if --ascii is given and the format has no text form.
const SceneFormat& format_for_output(const std::string& path, const FileOptions& options);
/// Whether a file is written as a document, such as glTF.
bool writes_document(const std::string& path, const FileOptions& options);
/// \throw UsageError for options of glTF where another format is written
void check_rounding(const std::string& path, const FileOptions& options, const gltf::WriteOptions& gltf);
/// The scope to read from documents for an output.
SceneScope scope_for(const std::string& path, const FileOptions& options, bool keeps_attributes = true);
/// The problem with '-' without an option for its format. \param option that sets the format
std::string needs_format(const std::string& option);

/// \throw as `format_for_output`
SceneOutput output_of(const std::string& path, const FileOptions& options, const gltf::WriteOptions& gltf = {});

/// Calls `write_scene`, prints its messages, and adds its warnings to `warnings`.
void write_result(OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh& mesh,
                  const Talk& talk, std::vector<std::string>& warnings);
/// The same for `whittle::write_levels`.
void write_levels(OutputFiles& files, const SceneOutput& output, Scene& scene, CoarserLevels levels, const Talk& talk,
                  std::vector<std::string>& warnings);

}  // namespace whittle::app
