#include "whittle/core/detail/abi.hh"

#if defined(__GLIBCXX__) && defined(__GNUC__)
namespace whittle::detail {

#ifdef _GLIBCXX_DEBUG
const char built_with_glibcxx_debug = 0;
#else
const char built_without_glibcxx_debug = 0;
#endif

}  // namespace whittle::detail
#endif
