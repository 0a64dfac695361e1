// Certificates whose bytes are wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "certificate.hh"
#include "support/random.hh"

namespace whittle::test {
namespace {

using ::testing::HasSubstr;
using verify::Verification;

/// Two triangles near each other, with a proof of each kind of step.
class CertificateBytes : public ::testing::Test {
 protected:
  CertificateBytes() {
    in_.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    in_.faces = {{0, 1, 2}};
    out_ = in_;
    for (Vec3& p : out_.positions) p.z() = 0.1;
    certificate_.prove(0, Steps().halve(1).face(0).patch(0));
    certificate_.prove(1, Steps().patch(0));
    certificate_.prove(2, Steps().face(0).face(1).face(2));
    certificate_.prove(3, Steps().face(0).halve(0).face(1).face(1).face(2));
    bytes_ = certificate_.bytes(in_, out_);
  }

  void expect_malformed(const std::string& bytes, const std::string& why) const {
    const Verification result = verified(in_, out_, bytes);
    EXPECT_FALSE(result.holds);
    EXPECT_TRUE(result.is_malformed) << result.why_not;
    EXPECT_THAT(result.why_not, HasSubstr(why));
  }
  /// A certificate whose first proof is other bytes.
  std::string with_first_proof(const std::string& proof) const {
    Certificate certificate = certificate_;
    certificate.sections[0] = {proof};
    return certificate.bytes(in_, out_);
  }
  /// A certificate whose number of vertices of IN is other bytes.
  std::string with_first_number(const std::string& number) const {
    constexpr std::size_t begin = 22 + 8 + 8;
    return bytes_.substr(0, begin) + number + bytes_.substr(begin + 1);
  }

  IndexedMesh in_;
  IndexedMesh out_;
  Certificate certificate_{.max_error = 0.2, .max_error_borders = 0.3, .tolerances = {1, 0.2, infinity}};
  std::string bytes_;
};

TEST_F(CertificateBytes, AreRight) {
  const Verification result = verified(in_, out_, bytes_);
  EXPECT_TRUE(result.holds) << result.why_not;
}

TEST_F(CertificateBytes, AreRefusedWhereTheyEnd) {
  for (std::size_t n = 0; n < bytes_.size(); ++n) expect_malformed(bytes_.substr(0, n), "it ends too early");
}

TEST_F(CertificateBytes, AreRefusedIfMoreFollow) {
  expect_malformed(bytes_ + '\0', "bytes follow the last proof");
  expect_malformed(bytes_ + bytes_, "bytes follow the last proof");
  expect_malformed(with_first_proof(Steps().face(0).face(0).bytes()), "IN, face 0: bytes follow its proof");
}

TEST_F(CertificateBytes, BeginWithTheirLine) {
  for (std::size_t i = 0; i < 22; ++i) {
    std::string bytes = bytes_;
    bytes[i] = '0';
    expect_malformed(bytes, "its first line is not 'whittle certificate 1'");
  }
}

TEST_F(CertificateBytes, HaveLimitsAboveZero) {
  for (const double bad : {0.0, -0.0, -1.0, -infinity, std::nan("")}) {
    for (const std::size_t begin : {22U, 30U, 43U, 51U, 59U}) {
      expect_malformed(std::string(bytes_).replace(begin, 8, real_bytes(bad)), "a length is not positive");
    }
  }
  EXPECT_TRUE(verified(in_, out_, std::string(bytes_).replace(22, 8, real_bytes(infinity))).holds);
  EXPECT_FALSE(verified(in_, out_, std::string(bytes_).replace(22, 8, real_bytes(5e-324))).holds);
}

TEST_F(CertificateBytes, HaveShortNumbers) {
  EXPECT_TRUE(verified(in_, out_, with_first_number("\x03")).holds);
  expect_malformed(with_first_number(std::string("\x83\0", 2)), "a number is too long");
  expect_malformed(with_first_number(std::string("\x83\x80\0", 3)), "a number is too long");
  expect_malformed(with_first_number(std::string(10, '\x83') + '\x01'), "a number is too long");
  expect_malformed(with_first_number(std::string(9, '\xff') + '\x02'), "a number is too long");
  const std::string longest = std::string(9, '\xff') + '\x01';
  EXPECT_THAT(verified(in_, out_, with_first_number(longest)).why_not, HasSubstr("18446744073709551615 vertices"));
}

TEST_F(CertificateBytes, NameTheirMeshes) {
  for (const std::size_t count : {0U, 1U, 2U, 3U}) {
    std::string bytes = bytes_;
    ++bytes[38 + count];
    const Verification result = verified(in_, out_, bytes);
    EXPECT_FALSE(result.holds);
    EXPECT_FALSE(result.is_malformed);
    EXPECT_THAT(result.why_not, HasSubstr(count < 2 ? "it is about other meshes: IN is to have"
                                                    : "it is about other meshes: OUT is to have"));
  }
  std::string bytes = bytes_;
  bytes[42] = 2;
  expect_malformed(bytes, "it has tolerances of some vertices alone");
}

TEST_F(CertificateBytes, HaveStepsOfKnownKinds) {
  for (const std::uint64_t rest : {0ULL, 1ULL, 1ULL << 61}) {
    expect_malformed(with_first_proof(Steps().add(3, rest).bytes()), "IN, face 0: a step is of no known kind");
  }
  for (const std::uint64_t edge : {3ULL, 1ULL << 32, (1ULL << 62) - 1}) {
    expect_malformed(with_first_proof(Steps().add(2, edge).bytes()), "a step halves an edge that is not there");
  }
  for (const unsigned kind : {0U, 1U}) {
    for (const std::uint64_t rest : {1ULL, 2ULL, 1ULL << 33, (1ULL << 33) + 1, (1ULL << 62) - 1, (1ULL << 62) - 2}) {
      expect_malformed(with_first_proof(Steps().add(kind, rest).bytes()), "a step names no face");
    }
  }
}

TEST_F(CertificateBytes, HaveChunksOfTheRightLength) {
  std::string bytes = bytes_;
  const std::size_t chunk = certificate_.head(in_, out_).size();
  --bytes[chunk];
  expect_malformed(bytes, "");
  bytes[chunk] += 2;
  expect_malformed(bytes, "");
  bytes = bytes_.substr(0, chunk) + number_bytes(~std::uint64_t{0}) + bytes_.substr(chunk + 1);
  expect_malformed(bytes, "it ends too early");
}

/// Whatever the bytes are: no crash, and a limit that is below the distance is never proven.
TEST_F(CertificateBytes, MayBeAnything) {
  Random random(1);
  std::size_t n_hold = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = bytes_;
    for (std::uint64_t k = random.below(4); k < 4; ++k) {
      const std::size_t at = random.below(bytes.size());
      if (random.below(4) == 0) {
        bytes.insert(at, 1, static_cast<char>(random.below(256)));
      } else if (random.below(4) == 0) {
        bytes.erase(at, 1);
      } else {
        bytes[at] = static_cast<char>(random.below(2) == 0 ? random.below(256) : random.below(8));
      }
    }
    const Verification result = verified(in_, out_, bytes);
    if (!result.holds) continue;
    ++n_hold;
    EXPECT_GE(result.max_error, 0.1) << i;
    EXPECT_GE(result.max_error_borders, 0.1) << i;
  }
  EXPECT_GT(n_hold, 100U);
}

}  // namespace
}  // namespace whittle::test
