// Ctrl-C and other signals: exit status 128 + signal number, one line of output, no files left behind.
#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <vector>

#include "program/program.hh"
#include "program/terminal.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

std::vector<std::string> simplify_arguments(const std::string& mesh, const TemporaryFolder& out) {
  return command(
      {"simplify", mesh, "-o", out / "out.off", "--map", out / "map", "--json", out / "report.json", "--faces", "100"});
}

TEST(Interruption, EndsReadingAtOnce) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = simplify_arguments("-", folder);
    arguments.insert(arguments.end(), {"--format", "off"});
    Running program(arguments);
    program.feed("OFF\n3 1 0\n");
    program.signal(signal);
    const Outcome outcome = program.finish();
    EXPECT_EQ(outcome.exit_code, 128 + signal) << outcome;
    EXPECT_EQ(outcome.err, "whittle: interrupted\n") << outcome;
    EXPECT_EQ(outcome.out, "") << outcome;
    EXPECT_TRUE(folder.files().empty());
  }
}

TEST(Interruption, EndsDecimationWithNothingWritten) {
  const TemporaryFolder meshes;
  const TemporaryFolder folder;
  // Large enough that the program still runs when the signal comes, even if this test has to wait for a processor.
  const std::string mesh = meshes / "sphere.ply";
  io::write_mesh(mesh, noisy_sphere(8, 0.01, 1));
  for (const char* engine : {"flat", "openmesh"}) {
    SCOPED_TRACE(engine);
    Terminal terminal;
    std::vector<std::string> arguments = simplify_arguments(mesh, folder);
    arguments.insert(arguments.end(), {"--engine", engine});
    RunOptions options;
    options.stderr_to = terminal.descriptor();
    options.environment = {{"TERM", "xterm"}, {"NO_COLOR", "1"}};
    Running program(arguments, options);
    const std::string seen = terminal.read_until("decimating [");
    ASSERT_NE(seen.find("decimating ["), std::string::npos) << seen;
    program.signal(SIGINT);
    const Outcome outcome = program.finish();
    EXPECT_EQ(outcome.exit_code, 130) << outcome;
    EXPECT_NE(terminal.read_all().find("whittle: interrupted"), std::string::npos);
    EXPECT_TRUE(folder.files().empty());
  }
}

TEST(Interruption, IsIgnoredWhereTheCallerIgnoresIt) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = simplify_arguments("-", folder);
  arguments.insert(arguments.end(), {"--format", "off", "--quiet"});
  RunOptions options;
  options.prepare = [] { ::signal(SIGHUP, SIG_IGN); };  // as nohup does
  Running program(arguments, options);
  const std::string mesh = read_text(data_file("flat.off"));
  program.feed(mesh.substr(0, 100));
  program.signal(SIGHUP);
  const Outcome outcome = program.finish(mesh.substr(100));
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"map", "out.off", "report.json"}));
}

}  // namespace
}  // namespace whittle::test
