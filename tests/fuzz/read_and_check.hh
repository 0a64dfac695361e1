#pragma once

#include <string_view>

namespace whittle::test {

/// Reads `bytes` as a mesh file and checks what the reader promises: a `ReadError`, or a valid mesh that survives being
/// written and read again.
/// \param bytes the first one chooses the format and whether to weld, the rest is the file.
/// \throw std::logic_error that says which promise was broken.
void read_and_check(std::string_view bytes);

/// The first byte for `read_and_check`.
char choice(int format, bool weld);

}  // namespace whittle::test
