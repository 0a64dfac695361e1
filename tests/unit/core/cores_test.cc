#include "whittle/core/detail/cores.hh"

#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "whittle/core/detail/parallel.hh"

namespace whittle::detail {
namespace {

namespace fs = std::filesystem;

class ControlGroups : public testing::Test {
 protected:
  ControlGroups() { fs::remove_all(root_); }
  ~ControlGroups() override { fs::remove_all(root_); }

  void write(const fs::path& file, const std::string& text) {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text << '\n';
  }
  std::optional<unsigned> allowed(std::string_view groups) const { return cores_allowed(groups, root_); }

 private:
  fs::path root_ = fs::path(testing::TempDir()) /
                   ("whittle_groups_of_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(ControlGroups, SetNoLimitWhereThereAreNone) {
  EXPECT_FALSE(allowed(""));
  EXPECT_FALSE(allowed("0::/\n"));
  EXPECT_FALSE(allowed("neither\nof::"));
}

TEST_F(ControlGroups, OfVersionTwoLimitTheirMembers) {
  write("cpu.max", "250000 100000");
  EXPECT_EQ(allowed("0::/\n"), 3U);
  EXPECT_EQ(allowed("0::/not/mounted/here\n"), 3U);
  write("cpu.max", "max 100000");
  EXPECT_FALSE(allowed("0::/\n"));
  write("cpu.max", "1000 100000");
  EXPECT_EQ(allowed("0::/"), 1U);
}

TEST_F(ControlGroups, AreLimitedByThoseThatTheyAreIn) {
  write("a/cpu.max", "400000 100000");
  write("a/b/cpu.max", "max 100000");
  write("a/b/c/cpu.max", "800000 100000");
  EXPECT_EQ(allowed("0::/a/b/c\n"), 4U);
  write("a/b/c/cpu.max", "200000 100000");
  EXPECT_EQ(allowed("0::/a/b/c\n"), 2U);
  EXPECT_EQ(allowed("0::/a/b\n"), 4U);
  EXPECT_FALSE(allowed("0::/other\n"));
}

TEST_F(ControlGroups, OfVersionOneAreFoundByTheirController) {
  write("cpu,cpuacct/docker/cpu.cfs_quota_us", "150000");
  write("cpu,cpuacct/docker/cpu.cfs_period_us", "50000");
  write("cpuset/docker/cpu.cfs_quota_us", "50000");
  write("cpuset/docker/cpu.cfs_period_us", "50000");
  EXPECT_EQ(allowed("5:cpuset:/docker\n4:cpu,cpuacct:/docker\n"), 3U);
  write("cpu,cpuacct/docker/cpu.cfs_quota_us", "-1");
  EXPECT_FALSE(allowed("5:cpuset:/docker\n4:cpu,cpuacct:/docker\n"));
}

TEST(Cores, AreThoseOfTheProcessorThatControlGroupsAllow) {
  EXPECT_EQ(usable_cores(8, std::nullopt), 8U);
  EXPECT_EQ(usable_cores(8, 3U), 3U);
  EXPECT_EQ(usable_cores(2, 3U), 2U);
  EXPECT_EQ(usable_cores(0, std::nullopt), 1U);
  EXPECT_EQ(usable_cores(0, 4U), 1U);
}

TEST(Cores, AreAtLeastOneAndAtMostThoseOfTheProcessor) {
  EXPECT_GE(n_cores(), 1U);
  EXPECT_LE(n_cores(), std::max(1U, std::thread::hardware_concurrency()));
  EXPECT_EQ(n_threads(0), n_cores());
  EXPECT_EQ(n_threads(7), 7U);
}

}  // namespace
}  // namespace whittle::detail
