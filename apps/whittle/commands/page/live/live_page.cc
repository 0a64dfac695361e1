#include "commands/page/live/live_page.hh"

#include <algorithm>
#include <ostream>
#include <utility>

#include "files/output.hh"
#include "files/report.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/output_file.hh"
#include "whittle/io/path_of.hh"
#include "whittle/pipeline/targets.hh"

namespace whittle::app {
namespace {

constexpr double interval = 1;     ///< between two pages at least, seconds
constexpr double times_work = 15;  ///< between two pages, how many times as long as writing the one before took

}  // namespace

LivePage::LivePage(std::string path, const Plan& plan, const std::string& output, bool force,
                   const Stopwatch& since_start)
    : path_(std::move(path)),
      since_start_(since_start),
      title_(short_name(plan.scene.name) + ", " + short_name(output)),
      target_(to_string(plan.target)),
      input_(live_mesh(plan.scene.read.mesh)),
      now_(input_),
      stage_("preparing"),
      n_faces_(plan.scene.read.mesh.faces.size()) {
  input_.name = short_name(plan.scene.name);
  now_.name = short_name(output);
  OutputFiles files(force);
  files.protect(plan.scene.needed_files);
  files.write(path_, [this](std::ostream& out) { out << page(); });
  files.commit();
  next_ = since_start_.seconds() + interval;
}

void LivePage::set_now(const IndexedMesh& mesh) {
  if (mesh.faces.empty()) return;
  std::string name = std::move(now_.name);
  now_ = live_mesh(mesh);
  now_.name = std::move(name);
  n_faces_ = mesh.faces.size();
}

std::string LivePage::page(const std::string& problem) const {
  return page_of({input_, now_, title_, target_, stage_, fraction_, n_faces_, since_start_.seconds(), problem});
}

void LivePage::write(const std::string& problem) {
  io::OutputFile file(io::path_of(path_));
  file.stream() << page(problem);
  file.commit();
}

bool LivePage::update(const RunProgress& progress) {
  const double begin = since_start_.seconds();
  if (begin < next_) return true;
  try {
    if (progress.surface) set_now(progress.surface());
    stage_ = progress.stage;
    fraction_ = progress.fraction;
    write();
  } catch (...) {
    failure_ = std::current_exception();  // not to be thrown through a library at work
    return false;
  }
  const double end = since_start_.seconds();
  next_ = end + std::max(interval, times_work * (end - begin));
  return true;
}

void LivePage::throw_if_failed() const {
  if (failure_) std::rethrow_exception(failure_);
}

void LivePage::show(const IndexedMesh& mesh, const std::string& stage) {
  set_now(mesh);
  stage_ = stage;
  fraction_ = 0;
  write();
}

void LivePage::end(const std::string& problem) {
  try {
    write(problem);
  } catch (const std::exception&) {
    // What ended the run is told in any case.
  }
}

}  // namespace whittle::app
