#pragma once

// Comes before all headers: lets libc++ declare <filesystem> and <fstream>, which it leaves out for WebAssembly.
// filesystem.cc defines what its library hasn't.

#include <__config>
#undef _LIBCPP_HAS_NO_FILESYSTEM
