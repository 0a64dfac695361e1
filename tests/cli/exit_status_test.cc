// Exit status when the input or the machine causes the error.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"

#if defined(__SANITIZE_ADDRESS__)
#define WHITTLE_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define WHITTLE_ADDRESS_SANITIZER 1
#endif
#endif

namespace whittle::test {
namespace {

namespace fs = std::filesystem;

struct BadFile {
  std::string name;
  std::string content;
  std::string said;
};

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ExitStatus, IsFourForInputThatCannotBeRead) {
  const TemporaryFolder folder;
  const std::vector<BadFile> cases{
      {"empty.obj", "", "empty.obj: "},
      {"empty.ply", "", "empty.ply: "},
      {"zero.obj", triangle + "f 0 1 2\n", "zero.obj:4: "},
      {"far.obj", triangle + "f 1 2 9\n", "far.obj:4: "},
      {"nan.obj", "v 0 0 nan\n" + triangle + "f 1 2 3\n", "nan.obj:1: "},
      {"points.obj", triangle, "points.obj: "},
      {"cut.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "cut.off"},
      {"wrong.stl", triangle + "f 1 2 3\n", "wrong.stl"},
      {"model.glb", "glTF", "model.glb: "},
      {"model.xyz", "0 0 0\n", "model.xyz: "},
  };
  for (const BadFile& bad : cases) {
    SCOPED_TRACE(bad.name);
    write_text(folder / bad.name, bad.content);
    const std::string out = folder / "out.obj";
    expect_failure(whittle({"info", folder / bad.name}), 4, {bad.said});
    expect_failure(whittle({"simplify", folder / bad.name, "-o", out, "--faces", "9"}), 4, {bad.said});
    expect_failure(whittle({"measure", data_file("cubes.obj"), folder / bad.name}), 4, {bad.said});
    expect_failure(whittle({"compare", folder / bad.name, "--faces", "9"}), 4, {bad.said});
    EXPECT_FALSE(fs::exists(out));
  }
  expect_failure(whittle({"info", folder / "absent.obj"}), 4, {"absent.obj"});
  fs::create_directory(folder / "folder.obj");
  expect_failure(whittle({"info", folder / "folder.obj"}), 4, {"folder.obj"});
}

TEST(ExitStatus, IsFourForBadStandardInput) {
  RunOptions options;
  options.input = triangle + "f 1 2 x\n";
  expect_failure(whittle({"info", "-", "--format", "obj"}, options), 4, {"standard input:4: "});
  options.input = "";
  expect_failure(whittle({"info", "-", "--format", "ply"}, options), 4, {"standard input: "});
}

TEST(ExitStatus, IsZeroAfterTheAdviceOnAWrongFormat) {
  const TemporaryFolder folder;
  fs::copy_file(data_file("knot.ply"), folder / "knot.obj");
  expect_failure(whittle({"info", folder / "knot.obj"}), 4, {"the content is ply, not obj; rename it to .ply\n"});
  fs::rename(folder / "knot.obj", folder / "knot.ply");
  EXPECT_EQ(whittle({"info", folder / "knot.ply"}).exit_code, 0);
  RunOptions options;
  options.input = read_text(data_file("knot.ply"));
  expect_failure(whittle({"info", "-", "--format", "obj"}, options), 4,
                 {"the content is ply, not obj; give --format ply\n"});
  EXPECT_EQ(whittle({"info", "-", "--format", "ply"}, options).exit_code, 0);
}

TEST(ExitStatus, IsFourWhereOpenMeshCannotHoldTheMesh) {
  const TemporaryFolder folder;
  expect_failure(whittle({"simplify", data_file("nonmanifold.obj"), "-o", folder / "out.obj", "--faces", "100",
                          "--engine", "openmesh", "--quiet"}),
                 4, {"nonmanifold.obj", "of the 875 faces", "--engine flat"});
  EXPECT_TRUE(folder.files().empty());
}

TEST(ExitStatus, IsOneWhereTheOutputCannotGo) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("blob.obj");
  expect_failure(whittle({"simplify", mesh, "-o", folder / "no/such/out.obj", "--faces", "150"}), 1,
                 {"out.obj", "no folder"});
  fs::create_directory(folder / "folder.obj");
  expect_failure(whittle({"simplify", mesh, "-o", folder / "folder.obj", "--faces", "150"}), 1, {"folder.obj"});
  EXPECT_EQ(folder.files(), std::vector<std::string>{"folder.obj"});
}

TEST(ExitStatus, IsTwoForTwoOutputsOfTheSameName) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("blob.obj");
  write_text(folder / "t.png", "pixels");
  write_text(folder / "a.mtl", "newmtl red\nmap_Kd t.png\n");
  write_text(folder / "a.obj", "mtllib a.mtl\n" + read_text(data_file("blob.obj")));
  fs::create_directory(folder / "out");
  const std::vector<std::string> before = folder.files();
  const std::vector<std::vector<std::string>> cases{
      {"lod", mesh, "--faces", "100,50", "-o", "q_{i}.ply", "--json", "q_1.ply"},
      {"lod", mesh, "--faces", "100,50", "-o", "q_{i}.gltf", "--json", "q_1.bin"},
      {"convert", mesh, "y.gltf", "--json", "y.bin"},
      {"convert", mesh, "y.ply", "--json", "./y.ply"},
      {"simplify", mesh, "-o", "y.gltf", "--faces", "500", "--json", "y.bin"},
      {"simplify", mesh, "-o", "y.gltf", "--faces", "500", "--record", "y.bin"},
      {"simplify", "a.obj", "-o", "out/b.obj", "--faces", "500", "--json", "out/t.png"},
      {"polish", mesh, mesh, "-o", "y.gltf", "--json", "y.bin"}};
  for (std::vector<std::string> arguments : cases) {
    const std::string file = arguments.back();
    arguments.emplace_back("--quiet");
    RunOptions here;
    here.folder = folder.path();
    expect_failure(whittle(arguments, here), 2, {file});
    EXPECT_EQ(folder.files(), before) << file;
    EXPECT_TRUE(fs::is_empty(folder / "out")) << file;
  }
}

TEST(ExitStatus, IsOneOnAFullDisk) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("knot.ply");
  fs::create_symlink("/dev/full", folder / "full.ply");
  const std::vector<std::string> simplify{"simplify", mesh, "--ratio", "0.5", "--quiet", "-o"};
  const auto with = [&simplify](std::vector<std::string> more) {
    more.insert(more.begin(), simplify.begin(), simplify.end());
    return more;
  };
  expect_failure(whittle(with({folder / "full.ply"})), 1, {"full.ply", "No space left"});
  expect_failure(whittle(with({folder / "out.ply", "--map", folder / "full.ply"})), 1, {"full.ply", "No space left"});
  expect_failure(whittle(with({folder / "out.ply", "--json", folder / "full.ply"})), 1, {"full.ply", "No space left"});
  EXPECT_EQ(folder.files(), std::vector<std::string>{"full.ply"}) << "what was written before the disk was full stayed";

  RunOptions full;
  full.stdout_to = "/dev/full";
  expect_failure(whittle(with({"-", "--format", "ply"}), full), 1, {"standard output", "No space left"});
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"info", mesh}, {"info", mesh, "--json", "-"}, {"--help"}, {"--version"}}) {
    expect_failure(whittle(arguments, full), 1, {"standard output", "No space left"});
  }
}

TEST(ExitStatus, LeavesNothingHalfWritten) {
  const TemporaryFolder folder;
  write_text(folder / "out.ply", "as it was");
  RunOptions small;  // a disk that takes 10,000 bytes a file
  small.prepare = [] {
    const rlimit limit{10000, 10000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_DFL);
  };
  expect_failure(
      whittle({"simplify", data_file("knot.ply"), "-o", folder / "out.ply", "--ratio", "0.5", "--quiet"}, small), 1,
      {"out.ply"});
  EXPECT_EQ(folder.files(), std::vector<std::string>{"out.ply"});
  EXPECT_EQ(read_text(folder / "out.ply"), "as it was");
}

TEST(ExitStatus, IsOneForAWriteProtectedOutputUnlessForced) {
  const TemporaryFolder folder;
  const std::string out = folder / "out.obj";
  write_text(out, "precious");
  fs::permissions(out, fs::perms::owner_read);
  std::vector<std::string> arguments{"simplify", data_file("cubes.obj"), "-o", out, "--faces", "150"};
  expect_failure(whittle(arguments), 1, {"out.obj", "write-protected", "--force"});
  EXPECT_EQ(read_text(out), "precious");
  arguments.emplace_back("--force");
  EXPECT_EQ(whittle(arguments).exit_code, 0);
  EXPECT_NE(read_text(out), "precious");
}

TEST(ExitStatus, IsZeroWithFewerThreadsThanAskedFor) {
#ifdef WHITTLE_ADDRESS_SANITIZER
  GTEST_SKIP() << "the address sanitizer needs all addresses";
#endif
  const TemporaryFolder folder;
  RunOptions no_threads;  // each would get a stack of a gigabyte, which is more than there is
  no_threads.prepare = [] {
    const rlimit stack{1U << 30, 1U << 30};
    const rlimit all{900U << 20, 900U << 20};
    ::setrlimit(RLIMIT_STACK, &stack);
    ::setrlimit(RLIMIT_AS, &all);
  };
  const std::string mesh = data_file("knot.ply");
  const std::string one = folder / "one.ply";
  const std::string many = folder / "many.ply";
  const std::vector<std::string> simplify{"simplify", mesh, "--ratio", "0.1", "--effort", "best"};
  const auto with = [&simplify](const std::string& out, const char* threads) {
    std::vector<std::string> arguments = simplify;
    arguments.insert(arguments.end(), {"-o", out, "--threads", threads});
    return arguments;
  };
  EXPECT_EQ(whittle(with(one, "1")).exit_code, 0);
  const Outcome limited = whittle(with(many, "8"), no_threads);
  EXPECT_EQ(limited.exit_code, 0) << limited;
  EXPECT_EQ(read_text(many), read_text(one));
  const Outcome measured = whittle({"measure", mesh, one, "--samples", "1000", "--threads", "8"}, no_threads);
  EXPECT_EQ(measured.exit_code, 0) << measured;
}

TEST(ExitStatus, IsZeroForStreamsThatAreOpenAlready) {
  const TemporaryFolder folder;
  const std::string script =
      "whittle simplify \"$0\" -o /dev/stdout --format ply --ratio 0.5 --quiet > \"$1/a.ply\" &&"
      "whittle simplify \"$0\" -o >(cat > \"$1/b.ply\") --format ply --ratio 0.5 --quiet && wait $! &&"
      "mkfifo \"$1/pipe.ply\" && (cat \"$1/pipe.ply\" > \"$1/c.ply\" &"
      " whittle simplify \"$0\" -o \"$1/pipe.ply\" --ratio 0.5 --quiet; wait) &&"
      "whittle simplify <(cat \"$0\") --format ply -o \"$1/d.ply\" --ratio 0.5 --quiet &&"
      "whittle simplify \"$0\" -o - --format ply --ratio 0.5 --quiet > \"$1/expected.ply\"";
  const Outcome outcome = run({"bash", "-c", script, data_file("knot.ply"), folder.path().string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  for (const char* name : {"a.ply", "b.ply", "c.ply", "d.ply"}) {
    EXPECT_TRUE(read_text(folder / name) == read_text(folder / "expected.ply")) << name << outcome;
  }
}

TEST(ExitStatus, IsOneWhenNobodyReadsStandardOutput) {
  const Outcome outcome =
      run({"bash", "-c", "(whittle simplify \"$0\" -o - --format ply --ratio 0.9 --quiet; echo $? >&2) | true",
           data_file("knot.ply")});
  EXPECT_EQ(outcome.err, "whittle: standard output: can't be written: Broken pipe\n1\n") << outcome;
}

TEST(ExitStatus, IsOneOutOfMemory) {
#ifdef WHITTLE_ADDRESS_SANITIZER
  GTEST_SKIP() << "the address sanitizer needs all addresses";
#endif
  const TemporaryFolder folder;
  // 400,000 facets in binary are 20 MB and take more than 60 MB in memory: three corners each.
  const std::uint32_t facets = 400'000;
  std::string stl(80, ' ');
  stl.append(reinterpret_cast<const char*>(&facets), sizeof facets);
  for (std::uint32_t i = 0; i < facets; ++i) {
    const std::array<float, 12> numbers{0, 0, 1, static_cast<float>(i), 0, 0, static_cast<float>(i), 1, 0, 0, 1, 0};
    stl.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    stl.append(2, '\0');
  }
  write_text(folder / "big.stl", stl);
  RunOptions small;
  small.prepare = [] {
    const rlimit limit{60'000'000, 60'000'000};
    ::setrlimit(RLIMIT_AS, &limit);
  };
  expect_failure(whittle({"simplify", folder / "big.stl", "-o", folder / "out.stl", "--faces", "100"}, small), 1,
                 {"out of memory"});
  EXPECT_EQ(folder.files(), std::vector<std::string>{"big.stl"});
}

TEST(ExitStatus, IsThreeForATargetNotMetUnderStrict) {
  const TemporaryFolder folder;
  const std::vector<std::string> arguments{"simplify", data_file("cubes.obj"), "-o",  folder / "out.obj", "--faces",
                                           "10",       "--topology",           "keep"};
  const Outcome lenient = whittle(arguments);
  EXPECT_EQ(lenient.exit_code, 0) << lenient;
  EXPECT_EQ(lenient.out, "");
  // The message gives what was reached and what was asked for, why, and what to do.
  for (const char* said : {"warning: ", "cubes.obj: target not met: 10 faces asked, 100 faces and 100 vertices reached",
                           "by topology", "by turning a face", "locked"}) {
    EXPECT_NE(lenient.err.find(said), std::string::npos) << "not said: " << said << '\n' << lenient;
  }
  const std::string written = read_text(folder / "out.obj");

  std::vector<std::string> strict = arguments;
  strict.insert(strict.end(), {"--strict", "--json", "-"});
  const Outcome failed = whittle(strict);
  EXPECT_EQ(failed.exit_code, 3) << failed;
  EXPECT_EQ(failed.err.find("warning: " + data_file("cubes.obj") + ": target"), std::string::npos) << failed;
  EXPECT_NE(failed.err.find("cubes.obj: target not met: 10 faces asked"), std::string::npos) << failed;
  const auto json = parse_json(failed.out);
  EXPECT_EQ(json["target"]["met"], false);
  EXPECT_EQ(json["stop"], "exhausted");
  EXPECT_NE(json["warnings"].back().get<std::string>().find("target not met"), std::string::npos);
  EXPECT_EQ(read_text(folder / "out.obj"), written) << "what was reached is written all the same";

  strict.push_back("--quiet");
  const Outcome quiet = whittle(strict);
  EXPECT_EQ(quiet.exit_code, 3) << quiet;
  EXPECT_EQ(std::count(quiet.err.begin(), quiet.err.end(), '\n'), 1) << quiet;

  std::vector<std::string> enough = arguments;
  enough[5] = "100";
  enough.push_back("--strict");
  EXPECT_EQ(whittle(enough).exit_code, 0);
}

}  // namespace
}  // namespace whittle::test
