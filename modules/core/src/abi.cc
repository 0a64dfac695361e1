#include "whittle/core/detail/abi.hh"

#ifdef __GNUC__
namespace whittle::detail {

#ifdef WHITTLE_HAS_LANES
const char built_with_lanes = 0;
#else
const char built_without_lanes = 0;
#endif

#ifdef __GLIBCXX__
#ifdef _GLIBCXX_DEBUG
const char built_with_glibcxx_debug = 0;
#else
const char built_without_glibcxx_debug = 0;
#endif
#endif

}  // namespace whittle::detail
#endif
