#include <gtest/gtest.h>

#include <string>
#include <whittle/version.hh>

namespace whittle::test {
namespace {

TEST(Version, OfTheLibraryIsThatOfItsHeaders) {
  EXPECT_STREQ(version(), WHITTLE_VERSION_STRING);
  EXPECT_EQ(version(), std::to_string(WHITTLE_VERSION_MAJOR) + '.' + std::to_string(WHITTLE_VERSION_MINOR) + '.' +
                           std::to_string(WHITTLE_VERSION_PATCH));
}

}  // namespace
}  // namespace whittle::test
