#pragma once

#include <string>

#include "support/random.hh"

namespace whittle::test {

/// Damages a text or binary file slightly in one to four ways: flips bits, replaces bytes, drops, doubles, moves or
/// cuts off parts, or replaces numbers by ones that are likely to cause errors.
std::string mutated(std::string file, Random& random);

}  // namespace whittle::test
