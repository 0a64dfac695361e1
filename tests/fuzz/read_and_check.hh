#pragma once

#include <string_view>

#include "whittle/io/format.hh"

namespace whittle::test {

/// Reads a mesh file and checks what the reader promises: it throws a `ReadError` or gives a valid mesh. That mesh
/// stays the same when it is written and read again.
/// \param bytes a byte that chooses the format and whether to weld, then the file.
/// \throw std::logic_error that names the broken promise.
void read_and_check(std::string_view bytes);

/// The first byte for `read_and_check`.
char choice_of(io::Format format, bool weld);

/// The format that a first byte chooses; any byte chooses one.
io::Format format_chosen(char choice);

}  // namespace whittle::test
