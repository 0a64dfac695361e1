#include "commands/page/live/live_moment.hh"

#include <sstream>
#include <utility>

#include "terminal/table.hh"
#include "whittle/core/text/text.hh"
#include "whittle/report/page.hh"
#include "whittle/report/rough_level.hh"

namespace whittle::app {
namespace {

report::PageSurface surface_of(const LiveMesh& shown) {
  report::PageSurface surface{shown.name, shown.mesh, {}, {}, {}, std::nullopt};
  const bool is_rough = shown.mesh.faces.size() < shown.n_faces;
  if (is_rough) surface.note = "A rough level is shown: there are " + faces_text(shown.n_faces);
  surface.n_faces_of_file = shown.n_faces;
  surface.marks_irregular_edges = !is_rough;
  return surface;
}

}  // namespace

LiveMesh live_mesh(const IndexedMesh& mesh) {
  constexpr std::size_t most_faces = 100'000;
  LiveMesh shown{{}, report::rough_level(mesh, most_faces), mesh.faces.size()};
  report::put_in_page_order(shown.mesh);
  return shown;
}

std::string page_of(const LiveMoment& moment) {
  report::Page page;
  page.title = moment.title;
  page.original = surface_of(moment.input);
  page.results.push_back(surface_of(moment.now));
  page.live =
      report::PageLive{moment.stage, moment.fraction, moment.n_faces, moment.target, moment.seconds, moment.problem};
  std::ostringstream out;
  write_page(out, page);
  return std::move(out).str();
}

}  // namespace whittle::app
