// Files whose content isn't what their extension says.
#include <gtest/gtest.h>

#include <array>

#include "io_test_tools.hh"

namespace whittle::io {
namespace {

using test::cat;
using test::error_of;
using test::expect_error;
using test::read;

struct Sample {
  Format format;
  std::string content;
};

const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string stl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
const std::vector<Sample> samples = {
    {Format::off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {Format::ply,
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
     "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {Format::stl, stl}};

TEST(WrongContent, IsNamedWhateverTheExtension) {
  for (const Sample& sample : samples) {
    for (const Format named : all_formats) {
      const std::string name = "a." + std::string(name_of(named));
      const std::string real(name_of(sample.format));
      if (named == sample.format) {
        EXPECT_EQ(read(sample.content, name).mesh.faces.size(), 1U);
        continue;
      }
      expect_error(sample.content, name,
                   cat(name, ": the content is ", real, ", not ", name_of(named), "; rename it to .", real));
    }
  }
}

TEST(WrongContent, IsReadWhenTheFormatIsNamed) {
  for (const Sample& sample : samples) {
    const std::span<const char> bytes(sample.content.data(), sample.content.size());
    try {
      read_mesh(bytes, "-", {.format = Format::obj});
      FAIL() << "read";
    } catch (const ReadError& error) {
      const std::string right(name_of(sample.format));
      EXPECT_EQ(error.what(), cat("-: the content is ", right, ", not obj; give --format ", right));
    }
    EXPECT_EQ(read_mesh(bytes, "-", {.format = sample.format}).mesh.faces.size(), 1U);
  }
}

TEST(WrongContent, OfAnObjNamedOtherwiseIsRefused) {
  expect_error(obj, "a.off", "a.off:1: not an OFF file: it doesn't begin with OFF");
  expect_error(obj, "a.ply", "a.ply:1: not a PLY file: it doesn't begin with \"ply\"");
  const auto error = error_of(obj, "a.stl");
  EXPECT_NE(std::string(error->what()).find("the file ends where the header"), std::string::npos) << error->what();
}

TEST(WrongContent, SuchAsUtf16IsNamed) {
  std::string little_endian;
  std::string big_endian;
  for (const char c : obj) {
    little_endian += {c, '\0'};
    big_endian += {'\0', c};
  }
  for (const std::string& text : {"\xFF\xFE" + little_endian, "\xFE\xFF" + big_endian, little_endian, big_endian}) {
    expect_error(text, "a.obj", "a.obj: the content is UTF-16 text; save it as UTF-8 or plain ASCII");
  }
}

TEST(WrongContent, MayBeginWithAUtf8Mark) {
  EXPECT_EQ(read("\xEF\xBB\xBF" + obj, "a.obj").mesh.faces.size(), 1U);
  for (const Sample& sample : samples) {
    const std::string name = "a." + std::string(name_of(sample.format));
    EXPECT_EQ(read("\xEF\xBB\xBF" + sample.content, name).mesh.faces.size(), 1U) << name;
  }
}

TEST(WrongContent, OfOtherFormatsAndArchivesIsNamed) {
  using namespace std::string_literals;
  const std::array<std::pair<std::string, std::string>, 6> foreign = {{
      {"Kaydara FBX Binary  "s, "FBX; which is not supported; convert it with assimp"},
      {"PK\x03\x04\x14\x00\x00"s, "a zip archive"},
      {"glTF\x02\x00\x00\x00"s, "binary glTF; rename it to .glb, or give --input-format glb"},
      {"<!DOCTYPE html>\n<html>\n", "a web page"},
      {"version https://git-lfs.github.com/spec/v1\n", "a Git LFS pointer"},
      {"<?xml version=\"1.0\"?>\n<COLLADA>", "XML"},
  }};
  for (const auto& [content, what] : foreign) {
    for (const Format format : all_formats) {
      const auto error = error_of(content, "a." + std::string(name_of(format)));
      EXPECT_NE(std::string(error->what()).find("the content is " + what), std::string::npos) << error->what();
    }
  }
}

TEST(WrongContent, ThatIsBinaryIsNoObj) {
  expect_error(std::string("v 0 0 0\n\0\x12\x13", 11), "a.obj",
               "a.obj: the content is binary data; OBJ files are text");
}

TEST(WrongContent, OfNothingIsRefusedInEveryFormat) {
  for (const Format format : all_formats) {
    const std::string name = "a." + std::string(name_of(format));
    expect_error("", name, name + ": the file is empty");
    for (const std::string blank : {" ", "\n", "\n\n  \n"}) EXPECT_NE(error_of(blank, name), std::nullopt);
  }
}

TEST(WrongContent, OfAnUnsupportedFormatIsRefusedByItsExtension) {
  expect_error("anything", "Duck.glb",
               "Duck.glb: is glTF (.glb), a format that is not supported; use " + format_titles());
}

TEST(ReadMesh, RefusesWhatItCannotOpen) {
  const auto message = [](const std::string& path) -> std::string {
    try {
      read_mesh(std::filesystem::path(path));
    } catch (const ReadError& error) {
      return error.what();
    }
    return "read";
  };
  EXPECT_EQ(message("no/such/file.obj"), "no/such/file.obj: cannot be opened: No such file or directory");
  EXPECT_EQ(message("no_such_file"), "no_such_file: cannot be opened: No such file or directory");
  EXPECT_EQ(message(testing::TempDir()), testing::TempDir() + ": is a folder, not a mesh file");
  const std::string folder = testing::TempDir() + "whittle_folder.obj";
  std::filesystem::create_directory(folder);
  EXPECT_EQ(message(folder), folder + ": is a folder, not a mesh file");
  std::filesystem::remove(folder);
}

}  // namespace
}  // namespace whittle::io
