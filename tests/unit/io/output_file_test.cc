#include "whittle/io/output_file.hh"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "support/shapes/shapes.hh"
#include "whittle/io/output_files.hh"
#include "whittle/io/path_of.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::io {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
 protected:
  OutputFileTest() : folder_(fs::path(testing::TempDir()) / ("whittle_output_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  ~OutputFileTest() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
  }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  /// \return whether the system has symbolic links
  bool make_link(const fs::path& to, const std::string& name) const {
    std::error_code problem;
    fs::create_symlink(to, folder_ / name, problem);
    return !problem;
  }

  fs::path folder_;
};

TEST_F(OutputFileTest, AppearsWhenCommitted) {
  const fs::path path = folder_ / "a.txt";
  OutputFile file(path);
  file.stream() << "text";
  EXPECT_FALSE(fs::exists(path));
  file.commit();
  EXPECT_EQ(content(path), "text");
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFileTest, LeavesNothingWhenNotCommitted) {
  try {
    OutputFile file(folder_ / "a.txt");
    file.stream() << "text";
    throw std::runtime_error("cancelled");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(files(), 0U);
}

TEST_F(OutputFileTest, LeavesTheOldFileUntilCommitted) {
  const fs::path path = folder_ / "a.txt";
  std::ofstream(path) << "old";
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  const fs::perms permissions = fs::status(path).permissions();  // Windows has more of them
  {
    OutputFile file(path);
    file.stream() << "new";
    EXPECT_EQ(content(path), "old");
  }
  EXPECT_EQ(content(path), "old");
  OutputFile file(path);
  file.stream() << "new";
  file.commit();
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(fs::status(path).permissions(), permissions);
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFileTest, FollowsSymbolicLinks) {
  const fs::path target = folder_ / "target.txt";
  const fs::path link = folder_ / "link.txt";
  if (!make_link("target.txt", "link.txt")) GTEST_SKIP() << "no symbolic links";  // the target doesn't exist yet
  for (const std::string text : {"first", "second"}) {
    OutputFile file(link);
    file.stream() << text;
    file.commit();
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(content(target), text);
  }
}

TEST_F(OutputFileTest, HasANameInUtf8) {
  const fs::path path = path_of("Größe ∞.txt");
  EXPECT_EQ(path.u16string(), u"Größe ∞.txt");
  OutputFiles files;
  files.write((folder_ / path).string(), [](std::ostream& out) { out << "text"; });
  files.commit();
  EXPECT_EQ(content(folder_ / u"Größe ∞.txt"), "text");
}

TEST_F(OutputFileTest, HasOneIdentityByAnyName) {
  for (const char* name : {"ä.txt", "b.txt"}) std::ofstream(folder_ / path_of(name)) << name;
  fs::create_hard_link(folder_ / path_of("ä.txt"), folder_ / "c.txt");
  const auto identity = [&](const std::string& name) { return file_identity((folder_ / path_of(name)).string()); };
  EXPECT_EQ(identity("ä.txt"), identity("c.txt"));
  EXPECT_EQ(identity("ä.txt"), identity("./ä.txt"));
  EXPECT_NE(identity("ä.txt"), identity("b.txt"));
  EXPECT_EQ(identity("none.txt"), identity("../" + folder_.filename().string() + "/none.txt"));
  EXPECT_NE(identity("none.txt"), identity("b.txt"));
}

TEST_F(OutputFileTest, WritesDevicesDirectlyAndLeavesThemThere) {
  const fs::path null = "/dev/null";
  if (!fs::is_character_file(null)) GTEST_SKIP() << "no /dev/null";
  write_mesh(null, whittle::test::cube(), {.format = Format::ply});
  EXPECT_TRUE(fs::is_character_file(null));
}

TEST_F(OutputFileTest, ReportsAFullDisk) {
  const fs::path full = "/dev/full";
  if (!fs::is_character_file(full)) GTEST_SKIP() << "no /dev/full";
  try {
    write_mesh(full, whittle::test::cube(), {.format = Format::ply});
    FAIL() << "written";
  } catch (const WriteError& error) {
    EXPECT_STREQ(error.what(), "/dev/full: writing failed: No space left on device");
  }
}

TEST_F(OutputFileTest, ReportsWhatCannotBeOpened) {
  try {
    write_mesh(folder_ / "none" / "a.obj", whittle::test::cube());
    FAIL() << "written";
  } catch (const WriteError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot be written: No such file or directory"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(OutputFile{folder_}, WriteError);
}

TEST_F(OutputFileTest, IsNotTouchedWhenTheFormatIsUnknown) {
  EXPECT_THROW(write_mesh(folder_ / "a.glb", whittle::test::cube()), std::invalid_argument);
  EXPECT_EQ(files(), 0U);
}

TEST_F(OutputFileTest, HoldsTheMeshInEveryFormat) {
  for (const Format format : all_formats) {
    const fs::path path = folder_ / ("cube." + std::string(name_of(format)));
    write_mesh(path, whittle::test::cube());
    const ReadResult back = read_mesh(path);
    EXPECT_EQ(back.mesh.positions.size(), 8U) << path;
    EXPECT_EQ(back.mesh.faces.size(), 12U) << path;
    EXPECT_EQ(back.format, format);
  }
}

TEST_F(OutputFileTest, KeepsWhatInputsNeed) {
  const fs::path texture = folder_ / "texture.png";
  std::ofstream(texture) << "pixels";
  std::vector<std::string> refused = {"texture.png", "./texture.png", "missing.bin"};
  if (make_link(texture, "link.png")) refused.push_back("link.png");
  OutputFiles files;
  files.protect({texture, folder_ / "missing.bin"});
  const auto write = [&files](const fs::path& path) {
    files.write(path.string(), [](std::ostream& out) { out << "other"; });
  };
  for (const std::string& name : refused) {
    EXPECT_THROW(write(folder_ / name), WriteError) << name;
  }
  write(folder_ / "own.png");
  files.commit();
  EXPECT_EQ(content(texture), "pixels");
  EXPECT_EQ(content(folder_ / "own.png"), "other");
  EXPECT_FALSE(fs::exists(folder_ / "missing.bin"));
}

TEST_F(OutputFileTest, RefusesASecondFileOfTheSameName) {
  std::vector<fs::path> seconds = {folder_ / "first.txt", folder_ / "." / "first.txt"};
  const fs::path from_here = fs::relative(folder_ / "first.txt");
  if (!from_here.empty()) seconds.push_back(from_here);       // empty: on another drive
  const bool is_linked = make_link("first.txt", "link.txt");  // to what is not there yet
  if (is_linked) seconds.push_back(folder_ / "link.txt");
  for (const fs::path& second : seconds) {
    OutputFiles files;
    const auto write = [&files](const fs::path& path) {
      files.write(path.string(), [](std::ostream& out) { out << "text"; });
    };
    write(folder_ / "other.txt");
    write(folder_ / "first.txt");
    EXPECT_THROW(write(second), OutputConflict) << second;
  }
  EXPECT_EQ(files(), is_linked ? 1U : 0U) << "nothing but the link";
}

TEST_F(OutputFileTest, RefusesOtherBytesForASharedFile) {
  const std::string shared = (folder_ / "a" / "b" / "texture.png").string();
  const auto fill = [](std::ostream& out) { out << "report"; };
  {
    OutputFiles files;
    EXPECT_TRUE(files.write_with_folders(shared, "pixels"));
    EXPECT_FALSE(files.write_with_folders(shared, "pixels"));
    EXPECT_THROW(files.write_with_folders(shared, "other pixels"), OutputConflict);
    EXPECT_THROW(files.write(shared, fill), OutputConflict);
  }
  EXPECT_EQ(files(), 0U);
  {
    OutputFiles files;
    const std::string report = (folder_ / "report.json").string();
    files.write(report, fill);
    EXPECT_THROW(files.write_with_folders(report, "pixels"), OutputConflict);
  }
  EXPECT_EQ(files(), 0U);
  OutputFiles files;
  files.write_with_folders(shared, "pixels");
  files.commit();
  EXPECT_EQ(content(shared), "pixels");
}

}  // namespace
}  // namespace whittle::io
