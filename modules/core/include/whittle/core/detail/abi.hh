#pragma once

#include <version>

// With -D_GLIBCXX_DEBUG the containers of libstdc++ have another layout. A program compiled with it and a Whittle
// compiled without (or the reverse) would link, and fail while running. So each file that includes this one refers to a
// variable that the library has only if it was compiled in the same mode: the linker names the other one as missing.

#if defined(__GLIBCXX__) && defined(__GNUC__)
namespace whittle::detail {

#ifdef _GLIBCXX_DEBUG
extern const char built_with_glibcxx_debug;
[[gnu::used]] static const char* const required_mode = &built_with_glibcxx_debug;
#else
extern const char built_without_glibcxx_debug;
[[gnu::used]] static const char* const required_mode = &built_without_glibcxx_debug;
#endif

}  // namespace whittle::detail
#endif
