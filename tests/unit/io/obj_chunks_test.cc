// OBJ files are read in chunks. The result doesn't depend on them.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "obj/obj.hh"

namespace whittle::io {
namespace {

template <class Row>
void append_rows(std::string& text, const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    for (const auto x : row) text.append(std::to_string(x)).append(1, ' ');
    text.append(1, '\n');
  }
}

/// What reading gives or how it fails, as text.
std::string outcome(const std::string& obj, std::size_t bytes_per_chunk, unsigned threads = 1,
                    AttributeScope scope = AttributeScope::all) {
  try {
    const ReadResult result =
        read_obj_in_chunks(obj, "file", bytes_per_chunk, {.threads = threads, .attributes = scope});
    std::string text;
    append_rows(text, result.mesh.positions);
    append_rows(text, result.mesh.faces);
    append_rows(text, result.mesh.normals);
    append_rows(text, result.mesh.colors);
    append_rows(text, std::vector<std::vector<Index>>{result.mesh.wedges, result.mesh.face_groups});
    for (const auto* const attributes : {&result.mesh.attributes, &result.mesh.face_attributes}) {
      for (const Attribute& attribute : *attributes) {
        text.append(attribute.name).append(1, ' ');
        append_rows(text, std::vector<std::vector<double>>{attribute.values});
      }
    }
    for (const std::string& name : result.mesh.group_names) text.append(name).append(1, '\n');
    for (const std::string& library : result.notes.material_libraries) text.append(library).append(1, '\n');
    for (const auto& [attribute, names] : result.notes.face_names) {
      for (const std::string& name : names) text.append(attribute).append(name).append(1, '\n');
    }
    for (const std::string& warning : result.warnings) text.append(warning).append(1, '\n');
    return text.append(std::to_string(result.file_faces)).append(to_string(result.repairs));
  } catch (const ReadError& error) {
    return error.what();
  }
}

const std::vector<std::string>& sample_lines() {
  static const std::vector<std::string> lines = {"v 0 0 0",
                                                 "v 1 0 0 0.5 0.5 1",
                                                 "v 0 1 0",
                                                 "v 0 0 1 1 0 0 0.5",
                                                 "v 1 1 \\\n 1",
                                                 "vn 0 0 1",
                                                 "vn 1 0 0",
                                                 "vt 0 0",
                                                 "vt 0.5 0.25 1",
                                                 "f 1/1/1 2/-1/1 3//1",
                                                 "f 1/2 2/1 3/1 4/1",
                                                 "vt 1 \\\n 1",
                                                 "mtllib a b.mtl",
                                                 "o thing",
                                                 "s 2",
                                                 "f 1 2 3",
                                                 "f -1 -2 -3",
                                                 "f 1//1 2//2 3/",
                                                 "f -1//-1 -2//-1 -3//-2",
                                                 "f 1 2 3 4 1",
                                                 "f -3 -2 \\\n -1",
                                                 "# a comment \\",
                                                 "usemtl steel\\",
                                                 "g part",
                                                 "s 1",
                                                 "nonsense",
                                                 "",
                                                 "  v 2 2 2",
                                                 "f 6 7 8",
                                                 "v 3 1 2\r",
                                                 "vn 0 1 0\r",
                                                 "l 1 2",
                                                 "s \\\nv 1 2 3",
                                                 "f 1//9 2//9 3//9",
                                                 "f 90 91 92",
                                                 "v 1 2",
                                                 "v nan 0 0"};
  return lines;
}

TEST(ObjChunks, GiveTheSameAsTheWhole) {
  std::mt19937 random(1);
  const std::vector<std::string>& lines = sample_lines();
  std::size_t n_read = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string obj = i % 4 == 0 ? "" : "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn 0 1 0\n";
    // The last few lines are errors: most files have none.
    const std::size_t n_kinds = random() % 4 == 0 ? lines.size() : lines.size() - 5;
    for (std::size_t n = random() % 40; n > 0; --n) obj.append(lines[random() % n_kinds]).append(1, '\n');
    if (random() % 8 == 0 && !obj.empty()) obj.pop_back();
    const std::string expected = outcome(obj, obj.size() + 1);
    n_read += expected.starts_with("file") ? 0 : 1;
    for (const std::size_t bytes : {std::size_t{1}, std::size_t{11}, std::size_t{60}}) {
      ASSERT_EQ(outcome(obj, bytes, i % 10 == 0 ? 3 : 1), expected) << bytes << " bytes a chunk of\n" << obj;
    }
    ASSERT_EQ(outcome(obj, 11, 1, AttributeScope::per_vertex),
              outcome(obj, obj.size() + 1, 1, AttributeScope::per_vertex))
        << obj;
  }
  EXPECT_GT(n_read, 300U);
  EXPECT_LT(n_read, 1300U);
}

TEST(ObjChunks, MayBeTheFile) {
  EXPECT_EQ(outcome("", 1), outcome("", 100));
  EXPECT_EQ(outcome("\n\n", 1), outcome("\n\n", 100));
}

}  // namespace
}  // namespace whittle::io
