#pragma once

#include <string>
#include <vector>

#include "whittle/io/output_files.hh"
#include "whittle/pipeline/run.hh"
#include "whittle/scene/format.hh"

namespace whittle {

/// What to read of a document: all meshes, each once, if they are written as a document again with their attributes;
/// otherwise what its scene shows.
SceneScope scope_for(const SceneFormat* output, bool keeps_attributes = true);

struct FileRun {
  Plan plan;
  Outcome outcome;
  SceneMessages messages;  ///< of writing

  /// All warnings, in the order in which they came up: a line each.
  std::vector<std::string> warnings() const;
};

/// What `whittle simplify INPUT -o OUTPUT` does, to the byte: reads a file, plans, runs, and writes the result, with
/// the files that it needs beside it. \param request its `output.ascii`, `output.compress` and `reading` are taken
/// over, but for what the names tell \throw std::invalid_argument if the output's name tells no format; what
/// `read_scene`, `plan`, `run` and `write_scene` throw. No file is left half-written.
FileRun simplify_file(const std::string& input, const std::string& output, Request request,
                      const RunObserver& observer = {});

}  // namespace whittle
