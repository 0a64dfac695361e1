// In place of make_page.cc and live_moment.cc, in a program that is built without whittle::report.
#include <stdexcept>

#include "commands/page/live/live_moment.hh"
#include "commands/page/make_page.hh"

namespace whittle::app {

bool has_page() { return false; }

MadePage make_page(const ReportCommand&, const Talk&, PageFacts&) { throw std::logic_error("no page"); }

std::string make_page(const RunForPage&, const CommonOptions&, const Talk&) { throw std::logic_error("no page"); }

LiveMesh live_mesh(const IndexedMesh&) { throw std::logic_error("no page"); }

std::string page_of(const LiveMoment&) { throw std::logic_error("no page"); }

}  // namespace whittle::app
