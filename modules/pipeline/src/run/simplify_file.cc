#include "whittle/pipeline/simplify_file.hh"

#include <utility>

#include "whittle/io/path_of.hh"
#include "whittle/scene/read_scene.hh"
#include "whittle/scene/write_scene.hh"

namespace whittle {

SceneScope scope_for(const SceneFormat* output, bool keeps_attributes) {
  const bool stays_document = output != nullptr && output->is_document && keeps_attributes;
  return stays_document ? SceneScope::meshes : SceneScope::scene;
}

std::vector<std::string> FileRun::warnings() const {
  std::vector<std::string> all = all_warnings(plan, outcome);
  all.insert(all.end(), messages.warnings.begin(), messages.warnings.end());
  return all;
}

FileRun simplify_file(const std::string& input, const std::string& output, Request request,
                      const RunObserver& observer) {
  const SceneFormat* const by_name = format_by_name(output);
  request.output.path = output;
  request.output.format =
      by_name != nullptr ? by_name : &format_of(io::format_of(io::path_of(output)));  // which says what is wrong
  request.reading.scope = scope_for(request.output.format, request.keeps_attributes);
  request.reading.takes_no_triangles = request.reading.scope == SceneScope::meshes;
  FileRun file_run;
  file_run.plan = plan(read_scene(input, request.reading), request);
  file_run.outcome = run(file_run.plan, observer);
  io::OutputFiles files;
  files.protect(file_run.plan.scene.needed_files);
  write_scene(files, request.output, file_run.plan.scene, file_run.outcome.simplified.mesh, file_run.messages);
  files.commit();
  return file_run;
}

}  // namespace whittle
