#pragma once

#include <stdexcept>
#include <string>

namespace whittle::test {

/// What the code promises does not hold.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// \param about what of, for the message
inline void require(bool holds, const char* promise, const std::string& about = {}) {
  if (!holds) throw BrokenPromise(std::string("broken promise: ") + promise + about);
}

}  // namespace whittle::test
