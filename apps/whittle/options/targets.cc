#include "options/targets.hh"

#include "terminal/errors.hh"
#include "terminal/table.hh"

namespace whittle::app {

void check_targets(const Targets& targets, const std::string& all) {
  if (!targets.any()) throw UsageError("no target: give at least one of " + all);
}

}  // namespace whittle::app
