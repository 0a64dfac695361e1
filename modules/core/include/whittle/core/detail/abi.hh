#pragma once

#include <version>

#include "whittle/core/detail/compiler.hh"

// A program must be compiled as its Whittle was, in two ways. With -D_GLIBCXX_DEBUG the containers of libstdc++ have
// another layout. With WHITTLE_SCALAR, functions in headers have another text. Each mixture would link, and might fail
// while running. So each file that includes this one refers to variables that the library has only if it was compiled
// in the same way: the linker names the others as missing.

#ifdef __GNUC__
namespace whittle::detail {

#ifdef WHITTLE_HAS_LANES
extern const char built_with_lanes;
WHITTLE_USED static const char* const required_lanes = &built_with_lanes;
#else
extern const char built_without_lanes;
WHITTLE_USED static const char* const required_lanes = &built_without_lanes;
#endif

#ifdef __GLIBCXX__
#ifdef _GLIBCXX_DEBUG
extern const char built_with_glibcxx_debug;
WHITTLE_USED static const char* const required_mode = &built_with_glibcxx_debug;
#else
extern const char built_without_glibcxx_debug;
WHITTLE_USED static const char* const required_mode = &built_without_glibcxx_debug;
#endif
#endif

}  // namespace whittle::detail
#endif
