#include <stdexcept>

#include "commands/page/make_page.hh"

namespace whittle::app {

void require_page() {
  if (has_page()) return;
  throw std::runtime_error("this whittle was built without the page: that takes Node.js, npm and meshoptimizer");
}

}  // namespace whittle::app
