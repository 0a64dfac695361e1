#pragma once

#include <string>

#include "support/random.hh"

namespace whittle::test {

/// A text or binary file with one to four small damages: flipped bits, replaced bytes, parts dropped, doubled, moved or
/// cut off, numbers replaced by ones that are likely to hurt.
std::string mutated(std::string file, Random& random);

}  // namespace whittle::test
