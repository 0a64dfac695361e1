#include <gtest/gtest.h>

#include "whittle/io/file_notes.hh"

namespace whittle::io {
namespace {

TEST(FileNotes, AreThoseThatAFormatHas) {
  FileNotes notes;
  notes.material_libraries = {"a.mtl"};
  notes.header_lines = {"comment TextureFile a.png"};
  EXPECT_TRUE(notes_in(Format::obj, notes).header_lines.empty());
  EXPECT_EQ(notes_in(Format::obj, notes).material_libraries, notes.material_libraries);
  EXPECT_EQ(notes_in(Format::ply, notes).header_lines, notes.header_lines);
  EXPECT_EQ(notes_in(Format::ply, notes).material_libraries, notes.material_libraries);
  EXPECT_TRUE(notes_in(Format::stl, notes).material_libraries.empty());
}

}  // namespace
}  // namespace whittle::io
