// In place of make_page.cc, in a program that is built without whittle::report.
#include <stdexcept>

#include "commands/page/make_page.hh"

namespace whittle::app {

bool has_page() { return false; }

MadePage make_page(const ReportCommand&, const Talk&, PageFacts&) { throw std::logic_error("no page"); }

std::string make_page(const RunForPage&, const CommonOptions&, const Talk&) { throw std::logic_error("no page"); }

}  // namespace whittle::app
