#include "whittle/version.hh"

namespace whittle {

const char* version() noexcept { return WHITTLE_VERSION_STRING; }

}  // namespace whittle
