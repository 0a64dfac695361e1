// A command line error gives one line on stderr that names it, and exit status 2.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "whittle/engine/cost_traits.hh"
#include "whittle/io/format.hh"
#include "whittle/pipeline/request.hh"

namespace whittle::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

/// The names as the help lists them.
std::string all_costs() {
  std::string names;
  for (const CostTraits& traits : all_cost_traits) names += (names.empty() ? "" : "|") + std::string(traits.name);
  return names;
}

/// A valid `simplify` command with further arguments.
Arguments simplify_with(const TemporaryFolder& folder, const Arguments& more) {
  Arguments arguments{"simplify", data_file("cubes.obj"), "-o", folder / "out.obj", "--faces", "150"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Usage, NeedsASubcommand) {
  expect_usage_error(whittle({}),
                     {"subcommand", "simplify, measure, info, polish, compare, convert", "see 'whittle --help'"});
  expect_usage_error(whittle({"shrink", "a.obj"}), {"'shrink' is not a subcommand", "see 'whittle --help'"});
  expect_usage_error(whittle({"simpify", "a.obj"}), {"'simpify' is not a subcommand", "did you mean 'simplify'?"});
  expect_usage_error(whittle({"--fast"}), {"--fast", "see 'whittle --help'"});
}

TEST(Usage, NamesWhatIsMissing) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("cubes.obj");
  expect_usage_error(whittle({"simplify"}), {"IN", "required", "see 'whittle simplify --help'"});
  expect_usage_error(whittle({"simplify", mesh, "--faces", "9"}), {"--output", "required"});
  expect_usage_error(whittle({"simplify", mesh, "-o", folder / "out.obj"}),
                     {"no target", "--faces", "--vertices", "--ratio", "--max-cost"});
  expect_usage_error(whittle({"simplify", mesh, "-o", folder / "out.obj", "--faces"}), {"--faces needs a value"});
  expect_usage_error(whittle({"measure", mesh}), {"TEST", "required", "see 'whittle measure --help'"});
  expect_usage_error(whittle({"info"}), {"IN", "required", "see 'whittle info --help'"});
  expect_usage_error(whittle({"convert", mesh}), {"OUT", "required", "see 'whittle convert --help'"});
  expect_usage_error(whittle({"verify", mesh, mesh}), {"CERT", "required", "see 'whittle verify --help'"});
  expect_usage_error(whittle({"compare", mesh}), {"no target", "see 'whittle compare --help'"});
  EXPECT_TRUE(folder.files().empty());
}

TEST(Usage, NamesWhatIsUnknown) {
  const TemporaryFolder folder;
  expect_usage_error(whittle(simplify_with(folder, {"--fases", "9"})),
                     {"--fases is not an option of 'simplify'", "did you mean '--faces'?"});
  expect_usage_error(whittle(simplify_with(folder, {"--max-norml-flip=9"})), {"did you mean '--max-normal-flip'?"});
  const Outcome far = whittle(simplify_with(folder, {"--watertight"}));
  expect_usage_error(far, {"--watertight is not an option of 'simplify'"});
  EXPECT_EQ(far.err.find("did you mean"), std::string::npos) << far;
  expect_usage_error(whittle(simplify_with(folder, {"another.obj"})),
                     {"one argument too many: 'another.obj'", "'out/{stem}.ply'"});
  expect_usage_error(whittle({"info", data_file("cubes.obj"), "another.obj"}),
                     {"one argument too many: 'another.obj'"});
  // An unknown option, or an unknown value of `--effort`, is an error.
  for (const char* option : {"--effort", "--curve"}) {
    expect_usage_error(whittle(simplify_with(folder, {option, "1"})), {option});
  }
}

TEST(Usage, StaysOnOneLineWhateverTheArguments) {
  const TemporaryFolder folder;
  expect_usage_error(whittle(simplify_with(folder, {"--weights", "a\nb\x1b[31m"})), {"--weights", "a?b?[31m"});
  expect_usage_error(whittle(simplify_with(folder, {"two\nlines"})), {"two?lines"});
}

struct BadValue {
  std::string option;
  std::string value;
  std::string said;
};

std::vector<BadValue> bad_values() {
  return {
      {"--vertices", "0", "at least 1"},
      {"--vertices", "-5", "at least 1"},
      {"--vertices", "1e3", "whole number"},
      {"--vertices", "12x", "whole number"},
      {"--vertices", "99999999999999999999", "whole number"},
      {"--vertices", "", "whole number"},
      {"--ratio", "0", "0 < R < 1"},
      {"--ratio", "1", "0 < R < 1"},
      {"--ratio", "1.5", "0 < R < 1"},
      {"--ratio", "-0.5", "0 < R < 1"},
      {"--ratio", "0%", "0 < R < 1"},
      {"--ratio", "100%", "0 < R < 1"},
      {"--ratio", "30 %", "30%"},
      {"--ratio", "nan", "0 < R < 1"},
      {"--ratio", "half", "0 < R < 1"},
      {"-r", "2", "--ratio"},
      {"--face-ratio", "2", "0 < R < 1"},
      {"--max-cost", "-1", "C >= 0"},
      {"--max-cost", "inf", "C >= 0"},
      {"--max-cost", "nan", "C >= 0"},
      {"--max-cost", "1,5", "C >= 0"},
      {"--max-error", "0", "not above 0"},
      {"-e", "0%", "not above 0"},
      {"--max-error", "-1", "--max-error"},
      {"--max-error", "small", "--max-error"},
      {"--max-error-borders", "0", "not above 0"},
      {"--weights", "volume", "area|uniform|area-angle"},
      {"--placement", "best", "optimal|midpoint|endpoint"},
      {"--boundary", "open", "weighted|locked|free"},
      {"--boundary-weight", "-1", "W >= 0"},
      {"--max-normal-flip", "0", "0 < DEG <= 180"},
      {"--max-normal-flip", "181", "0 < DEG <= 180"},
      {"--engine", "fast", "flat|openmesh"},
      {"--cost", "memory", all_costs()},
      {"--order", "any", "exact|approximate"},
      {"--valence", "-1", "W >= 0"},
      {"--valence", "nan", "W >= 0"},
      {"--isotropic", "1.1", "0 <= W <= 1"},
      {"--feature-angle", "0", "0 < DEG <= 180"},
      {"--feature-tolerance", "-1%", "T >= 0"},
      {"--crease-angle", "0", "0 < DEG <= 180"},
      {"--min-radius-ratio", "2", "0 <= X <= 1"},
      {"--threshold", "-1", "T >= 0"},
      {"--threshold", "1 %", "percentage"},
      {"--threshold", "inf", "'auto'"},
      {"-t", "automatic", "'auto'"},
      {"--max-pairs", "-1", "at least 0"},
      {"--max-pairs", "4294967296", "at most 4294967295"},
      {"--topology", "loose", "auto|keep|free"},
      {"--normals", "smooth", "keep|recompute|drop"},
      {"--prune", "-2%", "S >= 0"},
      {"--format", "glb", io::format_names("|")},
      {"--input-format", "fbx", io::format_names("|") + "|glb|gltf"},
      {"--output-format", "glb", io::format_names("|")},
      {"--threads", "-1", "at most 1024"},
      {"--threads", "1025", "at most 1024"},
  };
}

TEST(Usage, NamesTheOptionAndTheRange) {
  const TemporaryFolder folder;
  for (const BadValue& bad : bad_values()) {
    SCOPED_TRACE(bad.option + " '" + bad.value + "'");
    const std::string name = bad.option == "-r" ? "--ratio" : bad.option == "-t" ? "--threshold" : bad.option;
    expect_usage_error(whittle(simplify_with(folder, {bad.option, bad.value})), {name, bad.said});
  }
  const std::string mesh = data_file("cubes.obj");
  expect_usage_error(whittle({"measure", mesh, mesh, "--samples", "0"}), {"--samples", "at least 1"});
  expect_usage_error(whittle({"measure", mesh, mesh, "--seed", "-1"}), {"--seed", "at least 0"});
  for (const char* angle : {"0", "180", "-40", "nan", "sharp"}) {
    expect_usage_error(whittle({"measure", mesh, mesh, "--feature-angle", angle}),
                       {"--feature-angle", "0 < DEG < 180"});
  }
  expect_usage_error(whittle({"compare", mesh, "--faces", "9", "--input-format", "glb"}),
                     {"--input-format", "this command doesn't read glTF"});
  EXPECT_TRUE(folder.files().empty());
}

TEST(Usage, NamesWhatOptionsOfOlderProgramsAreHere) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("cubes.obj");
  const std::string out = folder / "out.obj";
  const auto refuse = [&](const Arguments& arguments, const std::string& said) {
    expect_usage_error(whittle(arguments), {said});
  };
  refuse({"simplify", "-i", mesh, "-o", out, "--faces", "9"},
         "IN is an argument without an option: 'simplify IN -o OUT'");
  refuse({"simplify", mesh, "-o", out, "-p", "0.5"}, "-p is not an option of 'simplify': the share");
  refuse({"simplify", mesh, "-o", out, "-r", "0.5", "-isotropic"}, "'--isotropic W'");
  refuse({"simplify", mesh, "-o", out, "-v", "147"}, "'147'; -v takes no value and says more, '--vertices 147'");
  // What the messages advise.
  EXPECT_EQ(whittle({"simplify", mesh, "-o", out, "--ratio", "0.9"}).exit_code, 0);
  EXPECT_EQ(whittle({"simplify", mesh, "-o", out, "--vertices", "147"}).exit_code, 0);
}

/// Everything that the parser of the command line can object to, in words of our own.
TEST(Usage, SaysInPlainWordsWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("cubes.obj");
  const struct {
    Arguments arguments;
    std::string said;
  } cases[] = {
      {simplify_with(folder, {"--quiet=3"}), "--quiet takes no value"},
      {simplify_with(folder, {"--force=false"}), "--force takes no value"},
      {simplify_with(folder, {"--no-weld=maybe"}), "--no-weld takes no value"},
      {simplify_with(folder, {"-q=3"}), "a short option takes no '=': '=3'"},
      {simplify_with(folder, {"--prune"}), "--prune needs a value"},
      {simplify_with(folder, {"--prune="}), "--prune needs a value"},
      {simplify_with(folder, {"-t"}), "--threshold needs a value"},
      {simplify_with(folder, {"-o", "x.obj", "-o", "y.obj"}), "--output is given 3 times"},
      {simplify_with(folder, {"x.obj"}), "one argument too many: 'x.obj'"},
      {simplify_with(folder, {"-"}), "one argument too many: '-'"},
      {simplify_with(folder, {""}), "one argument too many: ''"},
      {simplify_with(folder, {"--", "x.obj"}), "one argument too many: 'x.obj'"},
      {simplify_with(folder, {"++", "x.obj"}), "one argument too many: 'x.obj'"},
      {simplify_with(folder, {"-x"}), "-x is not an option of 'simplify'"},
      {simplify_with(folder, {"-qx"}), "-x is not an option of 'simplify'"},
      {{"--quiet", "info", mesh}, "--quiet must come after 'info'"},
      {{"--loud", "info", mesh}, "--loud is not an option of 'info'"},
      {{"info", mesh, "measure"}, "one argument too many: 'measure'"},
      {{"convert", mesh, "-o", "x.obj"}, "OUT is its second argument"},
      {{"simplify", mesh, "--outptu", "x.obj", "--faces", "9"}, "did you mean '--output'?"},
      {{"info", "--verbos"}, "did you mean '--verbose'?"},
      {{"info", "--"}, "IN is required"},
      {{"help", "simplfy"}, "did you mean 'simplify'?"},
      {{"completion"}, "SHELL is required"},
      {{"man", "bash"}, "one argument too many: 'bash'"},
  };
  for (const auto& [arguments, said] : cases) {
    const Outcome outcome = whittle(arguments);
    expect_usage_error(outcome, {said});
    for (const char* parsers_words :
         {"Could not", "Most", "Least", "expected", "override", "following", "should not"}) {
      EXPECT_EQ(outcome.err.find(parsers_words), std::string::npos) << outcome;
    }
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(Usage, RefusesAnOptionGivenTwice) {
  const TemporaryFolder folder;
  expect_usage_error(whittle(simplify_with(folder, {"--faces", "9"})), {"--faces is given 2 times"});
}

TEST(Usage, NamesBothOptionsThatDoNotGoTogether) {
  const TemporaryFolder folder;
  expect_usage_error(whittle(simplify_with(folder, {"--quiet", "-v"})), {"--quiet", "--verbose"});
  expect_usage_error(whittle(simplify_with(folder, {"--boundary", "free", "--boundary-weight", "3"})),
                     {"--boundary free", "--boundary-weight"});
  for (const char* option : {"--threshold", "--max-pairs"}) {
    expect_usage_error(whittle(simplify_with(folder, {option, "1", "--engine", "openmesh"})),
                       {option, "--engine openmesh"});
  }
  expect_usage_error(whittle(simplify_with(folder, {"--topology", "free", "--engine", "openmesh"})),
                     {"--topology free", "--engine openmesh"});
  expect_usage_error(whittle(simplify_with(folder, {"--max-cost", "1", "--engine", "openmesh"})),
                     {"--max-cost", "--engine openmesh"});
  EXPECT_EQ(whittle(simplify_with(folder, {"--boundary", "weighted", "--boundary-weight", "3"})).exit_code, 0);
}

/// An option of `simplify` with its value, if it takes one.
void expect_conflict(const Arguments& option, const Arguments& other, std::string_view why) {
  const TemporaryFolder folder;
  Arguments arguments = option;
  arguments.insert(arguments.end(), other.begin(), other.end());
  expect_usage_error(whittle(simplify_with(folder, arguments)),
                     {option.front(), other.front() + ' ' + other.back(), "doesn't go with", std::string(why)});
}

void expect_no_conflict(const Arguments& option, const Arguments& other) {
  const TemporaryFolder folder;
  Arguments arguments = option;
  arguments.insert(arguments.end(), other.begin(), other.end());
  const Outcome outcome = whittle(simplify_with(folder, arguments));
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
}

TEST(Usage, RefusesWhatACostDoesNotTakeAndNothingElse) {
  for (const CostTraits& traits : all_cost_traits) {
    const CostConflicts& why = traits.why_not;
    const auto check = [&](const Arguments& option, std::string_view reason) {
      const Arguments cost{"--cost", std::string(traits.name)};
      if (reason.empty()) {
        expect_no_conflict(option, cost);
      } else {
        expect_conflict(option, cost, reason);
      }
    };
    check({"--weights", "uniform"}, why.weights);
    check({"--weights", "area-angle"}, why.weights);
    check({"--placement", "midpoint"}, why.placement);
    check({"--placement", "endpoint"}, why.placement);
    check({"--boundary-weight", "1"}, why.boundary_weight);
    check({"--isotropic", "1"}, why.isotropy);
    check({"--valence", "1"}, why.valence_weight);
    check({"--threshold", "1"}, why.threshold);
  }
}

std::vector<Arguments> options_of_our_decimater() {
  std::vector<Arguments> options;
  Request request;
  for (const OptionRow& row : option_rows(request)) {
    if (!row.own_decimater) continue;
    options.push_back({long_name(row)});
    if (!row.access.meta.empty()) options.back().push_back(row.own_decimater->empty() ? "1" : *row.own_decimater);
  }
  return options;
}

TEST(Usage, RefusesWhatOpenMeshsDecimaterDoesNotDo) {
  const Arguments openmesh{"--engine", "openmesh"};
  std::vector<Arguments> own = options_of_our_decimater();
  ASSERT_GE(own.size(), 2U);
  own.insert(own.end(), {{"--record", "r"},
                         {"--curve", "c.csv"},
                         {"--page", "p.html"},
                         {"--live", "p.html"},
                         {"--frames", "f_{i}.png"},
                         {"--animate", "a.webp"}});
  for (const Arguments& option : own) expect_conflict(option, openmesh, "only Whittle's own loop does that");
  for (const char* order : {"exact", "approximate"}) {
    expect_conflict({"--order", order}, openmesh, "OpenMesh's decimater has an order of its own");
  }
  for (const Arguments& option :
       {Arguments{"--threshold", "1"}, Arguments{"--max-pairs", "1"}, Arguments{"--across-walls"}}) {
    expect_conflict(option, openmesh, "OpenMesh's decimater contracts edges alone");
  }
  expect_conflict({"--max-cost", "1"}, openmesh, "OpenMesh looks at a cost when it is queued");
  expect_conflict({"--topology", "free"}, openmesh, "a half-edge mesh keeps its topology");
}

TEST(Usage, WarnsOfOptionsThatDoNothing) {
  const TemporaryFolder folder;
  const auto said_of = [&](Arguments more) {
    more.push_back("--force");
    const Outcome outcome = whittle(simplify_with(folder, more));
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    return outcome.err;
  };
  const auto is_said = [&](const Arguments& more, const std::string& text) {
    return said_of(more).find("warning: " + text) != std::string::npos;
  };
  EXPECT_TRUE(is_said({"--max-pairs", "8"}, "'--max-pairs' does nothing without '--threshold'"));
  EXPECT_TRUE(is_said({"--across-walls"}, "'--across-walls' does nothing without '--threshold'"));
  EXPECT_TRUE(is_said({"--feature-tolerance", "1%"}, "'--feature-tolerance' does nothing without '--feature-angle'"));
  EXPECT_TRUE(is_said({"--crease-angle", "30"}, "'--crease-angle' does nothing without '--normals recompute'"));
  EXPECT_TRUE(is_said({"--boundary", "free", "--cost", "lindstrom-turk"},
                      "'--boundary free' does nothing with '--cost lindstrom-turk'"));
  EXPECT_TRUE(
      is_said({"--boundary", "free", "--cost", "midpoint"}, "'--boundary free' does nothing with '--cost midpoint'"));
  EXPECT_TRUE(is_said({"--fit", "max", "--polish", "0"}, "'--fit' does nothing without polish"));
  EXPECT_TRUE(is_said({"--fit", "mean", "--effort", "fast"}, "'--fit' does nothing without polish"));
  for (const Arguments& used :
       {Arguments{"--max-pairs", "8", "-t", "1%"}, Arguments{"--boundary", "free"}, Arguments{"--fit", "max"},
        Arguments{"--fit", "max", "--effort", "fast", "--polish", "1"},
        Arguments{"--feature-tolerance", "1%", "--feature-angle", "40"},
        Arguments{"--crease-angle", "30", "--normals", "recompute"}}) {
    EXPECT_EQ(said_of(used).find("does nothing"), std::string::npos);
  }
}

TEST(Usage, StandardStreamsNeedAFormat) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("cubes.obj");
  expect_usage_error(whittle({"simplify", "-", "-o", folder / "out.obj", "--faces", "150"}), {"'-'", "--format"});
  expect_usage_error(whittle({"simplify", mesh, "-o", "-", "--faces", "150"}), {"'-'", "--format"});
  expect_usage_error(whittle({"info", "-"}), {"'-'", "--format"});
  expect_usage_error(whittle({"measure", "-", "-", "--format", "obj"}), {"only one", "standard input"});
  expect_usage_error(whittle(simplify_with(folder, {"--format", "ply"})), {"--format", "every name does"});
}

TEST(Usage, RefusesToWriteAFormatItDoesNotKnow) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("cubes.obj");
  expect_usage_error(whittle({"simplify", mesh, "-o", folder / "out.fbx", "--faces", "150"}), {"out.fbx", "FBX"});
  // What makes a mesh of such a file is no advice for who writes one.
  expect_usage_error(whittle({"simplify", mesh, "-o", folder / "out.xyz", "--faces", "150"}),
                     {"out.xyz: is a point cloud (.xyz), a format that is not supported; use " + io::format_titles()});
  expect_usage_error(whittle({"simplify", mesh, "-o", folder / "out", "--faces", "150"}), {"out", io::format_names()});
  EXPECT_TRUE(folder.files().empty());
}

TEST(Usage, ReplacesAnInputUnderForceOnly) {
  const TemporaryFolder folder;
  const std::string mesh = folder / "mesh.obj";
  fs::copy_file(data_file("cubes.obj"), mesh);
  fs::create_hard_link(mesh, folder / "hard.obj");
  fs::create_symlink(mesh, folder / "soft.obj");
  const std::string before = read_text(mesh);
  for (const std::string& out : {mesh, folder / "./mesh.obj", folder / "hard.obj", folder / "soft.obj"}) {
    expect_usage_error(whittle({"simplify", mesh, "-o", out, "--faces", "150"}), {out, "--force"});
  }
  expect_usage_error(whittle({"simplify", mesh, "-o", folder / "out.obj", "--faces", "150", "--map", mesh}),
                     {mesh, "--force"});
  for (const char* sub : {"info", "compare"}) {
    Arguments arguments{sub, mesh, "--json", mesh};
    if (arguments[0] == "compare") arguments.insert(arguments.end(), {"--faces", "150"});
    expect_usage_error(whittle(arguments), {mesh, "--force"});
  }
  expect_usage_error(whittle({"measure", data_file("cubes.obj"), mesh, "--json", mesh}), {mesh, "--force"});
  EXPECT_EQ(read_text(mesh), before);

  const Outcome forced = whittle({"simplify", mesh, "-o", mesh, "--faces", "150", "--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced;
  EXPECT_NE(read_text(mesh), before);
}

TEST(Usage, RefusesTheSameOutputTwice) {
  const TemporaryFolder folder;
  expect_usage_error(whittle(simplify_with(folder, {"--map", folder / "out.obj"})), {"--map", "--output", "out.obj"});
  expect_usage_error(whittle(simplify_with(folder, {"--map", folder / "x", "--json", folder / "./x"})),
                     {"--map", "--json"});
  expect_usage_error(
      whittle({"simplify", data_file("cubes.obj"), "-o", "-", "--format", "obj", "--faces", "150", "--json", "-"}),
      {"--json -", "--output -"});
  EXPECT_TRUE(folder.files().empty());
}

}  // namespace
}  // namespace whittle::test
