// Checks the source tree, and tests that each check finds violations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "structure/layers.hh"
#include "structure/sizes.hh"
#include "structure/source_tree.hh"
#include "structure/unbuilt.hh"
#include "structure/words.hh"

namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const SourceTree& project() {
  static const SourceTree tree = read_source_tree(WHITTLE_SOURCE_DIR, {"modules", "apps", "tests", "data"});
  return tree;
}

std::vector<Layer> project_layers() {
  std::ifstream file(WHITTLE_SOURCE_DIR "/tests/structure/layers.txt", std::ios::binary);
  return read_layers({std::istreambuf_iterator<char>(file), {}});
}

constexpr std::size_t most_lines_of_a_function = 60;
constexpr std::size_t most_lines_of_a_header = 300;
constexpr std::size_t most_files_of_a_folder = 20;

TEST(Layers, PointOneWay) { EXPECT_THAT(forbidden_includes(project(), project_layers()), IsEmpty()); }

TEST(Layers, NameFoldersThatExist) { EXPECT_THAT(idle_rows(project(), project_layers()), IsEmpty()); }

TEST(Includes, GoInNoCircle) { EXPECT_THAT(include_circles(project()), IsEmpty()); }

TEST(Includes, OfThePageGoInNoCircle) {
  const SourceTree page = read_source_tree(
      WHITTLE_SOURCE_DIR, {"modules/report/viewer/src", "modules/web/page/src", "modules/web/whittle"}, {".js"});
  EXPECT_GT(includes_of(page).size(), 10U);
  EXPECT_THAT(include_circles(page), IsEmpty());
}

TEST(Sizes, FunctionsAreShort) { EXPECT_THAT(long_functions(project(), most_lines_of_a_function), IsEmpty()); }

TEST(Sizes, HeadersAreShort) { EXPECT_THAT(long_headers(project(), most_lines_of_a_header), IsEmpty()); }

TEST(Sizes, FoldersAreSmall) { EXPECT_THAT(full_folders(project(), most_files_of_a_folder), IsEmpty()); }

TEST(Tests, AreBuilt) {
  EXPECT_THAT(unbuilt_tests(project(), read_source_tree(WHITTLE_SOURCE_DIR, {"tests", "data"}, {".txt"})), IsEmpty());
}

/// Of modules but web, which one compiler compiles.
TEST(Words, OfSomeCompilersStandInOneHeader) {
  SourceTree tree = project();
  std::erase_if(tree, [](const auto& file) { return file.first.starts_with("modules/web/src/"); });
  EXPECT_THAT(words_of_some_compilers(tree, "modules", "modules/core/include/whittle/core/detail/compiler.hh"),
              IsEmpty());
}

TEST(Words, NoResultDependsOnHowASystemRounds) {
  for (const std::string folder : {"core", "engine", "io", "pipeline", "polish", "scene", "simplify", "verify"}) {
    EXPECT_THAT(functions_rounded_anyhow(project(), "modules/" + folder), IsEmpty());
  }
}

// Planted violations -------------------------------------------------------------------------------------------------

const char* const two_layers =
    "# a comment\n"
    "low   modules/low                 uses\n"
    "deep  modules/high/src/deep       uses low\n"
    "high  modules/high modules/other  uses low deep\n";

TEST(LayerCheck, FindsAnIncludeThatPointsBack) {
  const SourceTree tree = {
      {"modules/low/include/whittle/low/a.hh", "#include <vector>\n#include \"whittle/high/b.hh\"\n"},
      {"modules/high/include/whittle/high/b.hh", "#include <whittle/low/a.hh>\n"},
      {"modules/high/src/deep/c.cc", "  #  include \"d.hh\"\n// #include \"whittle/high/b.hh\"\n"},
      {"modules/high/src/d.hh", ""},
  };
  EXPECT_THAT(forbidden_includes(tree, read_layers(two_layers)),
              ElementsAre("modules/high/src/deep/c.cc (deep) includes modules/high/src/d.hh (high)",
                          "modules/low/include/whittle/low/a.hh (low) includes "
                          "modules/high/include/whittle/high/b.hh (high)"));
}

TEST(LayerCheck, FindsFilesWithoutALayerAndNamesWithoutAFile) {
  const SourceTree tree = {{"modules/low/src/a.cc", "#include \"missing.hh\"\n"}, {"modules/new/src/b.cc", ""}};
  EXPECT_THAT(forbidden_includes(tree, read_layers(two_layers)),
              ElementsAre("modules/new/src/b.cc is in no layer",
                          "modules/low/src/a.cc includes \"missing.hh\", which is no file of the project"));
}

TEST(LayerCheck, FindsRowsWithoutAFile) {
  const SourceTree tree = {{"modules/low/src/a.cc", ""}, {"modules/high/src/deep/b.cc", ""}};
  EXPECT_THAT(idle_rows(tree, read_layers(two_layers)), ElementsAre("high: no file is in modules/other"));
}

TEST(LayerCheck, RefusesATableThatPointsBack) {
  EXPECT_THROW(read_layers("low modules/low uses high\nhigh modules/high uses\n"), std::runtime_error);
  EXPECT_THROW(read_layers("low uses\n"), std::runtime_error);
}

TEST(CircleCheck, FindsACircle) {
  const SourceTree tree = {{"tests/a.hh", "#include \"b.hh\"\n"},
                           {"tests/b.hh", "#include \"sub/c.hh\"\n#include \"b_impl.hh\"\n"},
                           {"tests/b_impl.hh", "#include \"b.hh\"\n"},
                           {"tests/sub/c.hh", "#include \"a.hh\"\n"}};
  EXPECT_THAT(include_circles(tree), ElementsAre("tests/a.hh -> tests/b.hh -> tests/sub/c.hh -> tests/a.hh"));
}

/// `opening` and statements, `n` lines together with the closing line.
std::string function_of(const std::string& opening, std::size_t n) {
  std::string text = opening + "\n";
  for (std::size_t i = 2; i < n; ++i) text += i % 2 ? "  // }\n" : "  if (x) { y = '}'; }\n";
  return text + "}\n";
}

TEST(CircleCheck, FindsACircleOfImports) {
  const SourceTree tree = {{"page/a.js", "import {b} from './b.js';\n"}, {"page/b.js", "export {a} from './a.js';\n"}};
  EXPECT_THAT(include_circles(tree), ElementsAre("page/a.js -> page/b.js -> page/a.js"));
}

TEST(FunctionCheck, FindsLongFunctionsOfEveryForm) {
  const std::string before = "#define OPEN {\nnamespace a {\nenum class E { b, c };\nconstexpr int t[] = {1, 2};\n";
  for (const std::string opening :
       {"void f() {", "TEST(Suite, Name) {", "template <class T = int>\nauto A<T>::f(int x = {}) const -> int {",
        "A::A(int x) : B(x), c_{x}, d_{} {", "bool operator==(A, B) noexcept {", "const auto f = [](int x) {",
        "std::string f() { const char* s = R\"x(})\" }{)x\"; int n = 1'000;",
        "struct A {\n  A() : a{1} {}\n};\nint f() {"}) {
    const std::size_t extra = static_cast<std::size_t>(std::count(opening.begin(), opening.end(), '\n'));
    for (const std::string& after :
         {std::string("}\n"), std::string("struct S {\n  int n{};\n  void g() {}\n};\n}\n")}) {
      const SourceTree longer = {{"a.cc", before + function_of(opening, 61) + after}};
      EXPECT_EQ(long_functions(longer, 60).size(), 1) << opening;
      const SourceTree shorter = {{"a.cc", before + function_of(opening, 60 - extra) + after}};
      EXPECT_THAT(long_functions(shorter, 60), IsEmpty()) << opening;
    }
  }
}

TEST(FunctionCheck, NamesTheFunctionAndItsLine) {
  const SourceTree tree = {{"a.cc", "\n\n" + function_of("int A::f(int) const {", 61)}};
  EXPECT_THAT(long_functions(tree, 60), ElementsAre("a.cc: A::f has 61 lines, from line 3"));
}

TEST(FunctionCheck, LetsLongTablesAndClassesPass) {
  const SourceTree tree = {{"a.cc", function_of("class A : public B {\n public:", 100) + ";\n" +
                                        function_of("const std::map<int, int> table = {", 100) + ";\n"}};
  EXPECT_THAT(long_functions(tree, 60), IsEmpty());
}

TEST(FunctionCheck, SeesTheFunctionsOfTheProject) {
  std::size_t n_functions = 0;
  for (const auto& [path, text] : project()) n_functions += function_sizes(text).size();
  EXPECT_GT(n_functions, 2500);
}

TEST(HeaderCheck, FindsLongHeaders) {
  const std::string text(301, '\n');
  EXPECT_THAT(long_headers({{"a.hh", text}, {"b.hh", text.substr(1)}, {"c.cc", text}}, 300),
              ElementsAre("a.hh has 301 lines"));
}

TEST(FolderCheck, FindsFullFolders) {
  SourceTree tree;
  for (int i = 0; i < 21; ++i) {
    tree["a/" + std::to_string(i) + ".hh"] = "";
    if (i > 0) tree["a/b/" + std::to_string(i) + ".hh"] = "";
  }
  EXPECT_THAT(full_folders(tree, 20), ElementsAre("a has 21 files"));
}

TEST(BuildCheck, FindsTestsThatNobodyNames) {
  const SourceTree tree = {{"tests/a/one_test.cc", ""},  {"tests/a/b/two_test.cc", ""}, {"tests/a/b/three_test.cc", ""},
                           {"tests/c/four_test.cc", ""}, {"tests/five_test.cc", ""},    {"tests/five.cc", ""}};
  const SourceTree scripts = {{"tests/a/CMakeLists.txt", "one_test.cc b/two_test.cc three_test.cc"},
                              {"tests/c/CMakeLists.txt", "file(GLOB sources *.cc)"}};
  EXPECT_THAT(unbuilt_tests(tree, scripts), ElementsAre("tests/a/b/three_test.cc", "tests/five_test.cc"));
}

TEST(WordCheck, FindsWordsOfSomeCompilers) {
  const SourceTree tree = {
      {"modules/a.hh", "[[gnu::pure]] int f();\nint g() { asm(\"\"); return __builtin_ctz(1); }\n"},
      {"modules/b.hh", "struct __attribute__((packed)) A {};\n"},
      {"tests/c.hh", "__extension__ int x;\n"}};
  EXPECT_THAT(words_of_some_compilers(tree, "modules", "modules/b.hh"),
              ElementsAre("modules/a.hh: gnu::pure", "modules/a.hh: asm", "modules/a.hh: __builtin_ctz"));
}

TEST(WordCheck, FindsFunctionsRoundedAnyhow) {
  const SourceTree tree = {{"modules/a.cc", "x = std::cos(y) + std::sqrt(z) + std::pow(x, 2) + std::log1p(y);\n"}};
  EXPECT_THAT(functions_rounded_anyhow(tree, "modules"),
              ElementsAre("modules/a.cc: std::cos(", "modules/a.cc: std::pow(", "modules/a.cc: std::log1p("));
}

}  // namespace
