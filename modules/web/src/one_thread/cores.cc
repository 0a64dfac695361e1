#include "whittle/core/detail/cores.hh"

namespace whittle::detail {

unsigned n_cores() { return 1; }

}  // namespace whittle::detail
