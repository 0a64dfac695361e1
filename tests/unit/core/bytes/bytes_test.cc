#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>

#include "whittle/core/bytes/base64.hh"
#include "whittle/core/bytes/glb.hh"
#include "whittle/core/bytes/little_endian.hh"

namespace whittle::test {
namespace {

using namespace std::string_literals;

TEST(Base64, IsThatOfTheRfc) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Base64, DecodesWhatItEncodes) {
  std::mt19937 random(1);
  for (std::size_t n = 0; n < 300; ++n) {
    std::string bytes(n, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    EXPECT_EQ(decode_base64(base64(bytes)), bytes) << n << " bytes";
  }
}

TEST(Base64, NeedsNoPaddingAndRefusesOtherText) {
  EXPECT_EQ(decode_base64("Zm8"), "fo");
  for (const char* const text : {"Z", "Zm9v!", "Zm 9v", "Zm9vY"}) EXPECT_EQ(decode_base64(text), std::nullopt) << text;
}

TEST(LittleEndian, PutsTheLowestByteFirst) {
  std::string bytes;
  append_little_endian(bytes, std::uint32_t{0x01020304});
  append_little_endian(bytes, 1.0F);
  EXPECT_EQ(bytes, "\x04\x03\x02\x01\x00\x00\x80\x3f"s);
  EXPECT_EQ(load_little_endian<std::uint32_t>(bytes.data()), 0x01020304U);
  EXPECT_EQ(load<std::uint32_t>(bytes.data(), std::endian::big), 0x04030201U);
  EXPECT_EQ(load_little_endian<float>(bytes.data() + 4), 1.0F);
}

TEST(Glb, PadsItsTwoChunks) {
  EXPECT_EQ(join_glb("{}", "\1\2\3\4\5"), "glTF\2\0\0\0\x28\0\0\0\4\0\0\0JSON{}  \x08\0\0\0BIN\0\1\2\3\4\5\0\0\0"s);
  EXPECT_EQ(join_glb("{} ", ""), "glTF\2\0\0\0\x18\0\0\0\4\0\0\0JSON{}  "s);
}

}  // namespace
}  // namespace whittle::test
