// simplify --live: a page that shows the run while it goes on.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "program/program.hh"
#include "program/stand_in_programs.hh"

namespace whittle::test {
namespace {

/// What the page says of the run that goes on; null in a report.
nlohmann::json live_of(const std::filesystem::path& page) {
  const std::string text = read_text(page);
  const std::string begin = R"(<script id="whittle-data" type="application/json">)";
  const std::size_t from = text.find(begin);
  if (from == std::string::npos) throw std::runtime_error(page.string() + " is no page");
  const std::size_t at = from + begin.size();
  return parse_json(text.substr(at, text.find("</script>", at) - at)).value("live", nlohmann::json());
}

/// The run stands still at a known moment: its result goes to a pipe that is full before all of it is written.
class Live : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_page(folder)) GTEST_SKIP() << "this program was built without the page";
  }

  std::vector<std::string> run_into_pipe() const {
    return command({"simplify", data_file("knot.ply"), "-o", "-", "--format", "ply", "--face-ratio", "50%", "--live",
                    page, "--quiet"});
  }

  /// \return whether it came before the test has waited for long
  bool wait_for_result() const {
    for (int i = 0; i < 6000; ++i) {
      if (std::filesystem::exists(page) && live_of(page).value("stage", "") == "measuring and writing") return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  TemporaryFolder folder;
  std::string page = folder / "live.html";
};

TEST_F(Live, IsThereWhileTheRunGoesOnAndEndsAsTheReport) {
  const std::size_t n_files_before = folder.files().size();
  Running program(run_into_pipe());
  ASSERT_TRUE(wait_for_result());
  const nlohmann::json live = live_of(page);
  EXPECT_EQ(live["faces"], 25600);
  EXPECT_EQ(live["target"], "25600 faces");
  EXPECT_EQ(live["problem"], "");
  EXPECT_GT(live["seconds"], 0);
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_TRUE(live_of(page).is_null());
  EXPECT_EQ(folder.files().size(), n_files_before + 1);  // nothing else is left of the pages before
}

TEST_F(Live, SaysWhyARunWasInterrupted) {
  Running program(run_into_pipe());
  ASSERT_TRUE(wait_for_result());
  program.signal(SIGTERM);
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.exit_code, 128 + SIGTERM) << outcome;
  EXPECT_EQ(live_of(page)["problem"], "interrupted");
}

TEST_F(Live, SaysWhyARunFailed) {
  const Outcome outcome = whittle({"simplify", data_file("blob.obj"), "-o", "/dev/full", "--format", "ply", "--faces",
                                   "100", "--live", page, "--quiet"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome;
  const std::string problem = live_of(page)["problem"];
  EXPECT_NE(problem.find("/dev/full"), std::string::npos) << problem;
  EXPECT_NE(outcome.err.find(problem), std::string::npos) << outcome;
}

TEST_F(Live, ChangesNoResultAndIsThePageOfPage) {
  for (const std::vector<std::string>& target :
       {std::vector<std::string>{"--ratio", "10%"}, {"--max-error", "1%"}, {"--faces", "100000"}}) {
    for (const char* effort : {"fast", "normal", "best"}) {
      SCOPED_TRACE(target.front() + ' ' + effort);
      std::vector<std::string> arguments{"simplify", data_file("blob.obj"), "--effort", effort, "--quiet"};
      arguments.insert(arguments.end(), target.begin(), target.end());
      const auto with = [&arguments](std::vector<std::string> more) {
        more.insert(more.begin(), arguments.begin(), arguments.end());
        return whittle(more);
      };
      const std::string other = folder / "page.html";
      const Outcome alone = with({"-o", folder / "a.ply", "--record", folder / "a.rec"});
      EXPECT_EQ(alone.exit_code, 0) << alone;
      const Outcome live = with({"-o", folder / "b.ply", "--live", page, "--page", other});
      EXPECT_EQ(live.exit_code, 0) << live;
      EXPECT_EQ(read_text(folder / "a.ply"), read_text(folder / "b.ply"));
      EXPECT_EQ(read_text(page), read_text(other));
      EXPECT_TRUE(live_of(page).is_null());
    }
  }
}

TEST_F(Live, TakesAFileThatCanBeWrittenAgain) {
  const auto refused = [this](const std::string& path) {
    return whittle({"simplify", data_file("blob.obj"), "-o", folder / "x.ply", "--faces", "100", "--live", path});
  };
  EXPECT_EQ(refused("-").exit_code, 2);
  EXPECT_EQ(refused(folder / "none/page.html").exit_code, 1);
  EXPECT_EQ(refused(data_file("blob.obj")).exit_code, 2);
  EXPECT_EQ(refused("/dev/full").exit_code, 1);
}

TEST_F(Live, LeavesFilesThatAnInputNeeds) {
  write_text(folder / "a.obj", "mtllib a.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_text(folder / "a.mtl", "newmtl a\nKd 1 0 0\n");
  const Outcome outcome = whittle(
      {"simplify", folder / "a.obj", "-o", folder / "b.obj", "--faces", "1", "--live", folder / "a.mtl", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome;
  EXPECT_EQ(read_text(folder / "a.mtl"), "newmtl a\nKd 1 0 0\n");
}

TEST_F(Live, GoesWithSeveralInputs) {
  const Outcome outcome =
      whittle({"simplify", data_file("blob.obj"), data_file("cubes.obj"), "-o", folder / "{stem}.ply", "--face-ratio",
               "50%", "--live", folder / "{stem}.html", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  for (const char* name : {"blob.html", "cubes.html"}) EXPECT_TRUE(live_of(folder / name).is_null());
}

}  // namespace
}  // namespace whittle::test
