// Reading what doesn't tell its size: descriptors and pipes.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>
#include <vector>

#include "support/shapes/shapes.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::io {
namespace {

namespace fs = std::filesystem;

class UnsizedInput : public testing::Test {
 protected:
  UnsizedInput() : folder_(fs::path(testing::TempDir()) / ("whittle_bytes_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  ~UnsizedInput() override { fs::remove_all(folder_); }

  static void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  fs::path folder_;
};

TEST_F(UnsizedInput, IsReadUpToItsEnd) {
  const fs::path path = folder_ / "bytes";
  constexpr std::size_t block = std::size_t{1} << 20;  // read at once
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, block - 1, block, block + 1, 2 * block, 5 * block}) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * i % 251);
    write(path, bytes);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.string().c_str(), "rb"), std::fclose);
    ASSERT_TRUE(file);
    const std::vector<char> read = read_all(fileno(file.get()), "bytes");
    EXPECT_EQ(std::string(read.begin(), read.end()), bytes) << size;
  }
}

TEST_F(UnsizedInput, ThatCannotBeReadIsAnError) {
  try {
    read_all(-1, "standard input");
    ADD_FAILURE() << "read";
  } catch (const ReadError& error) {
    EXPECT_EQ(error.file(), "standard input");
    EXPECT_EQ(std::string(error.what()), "standard input: cannot be read: Bad file descriptor");
  }
}

#ifndef _WIN32  // there pipes are no files
TEST_F(UnsizedInput, FromAPipeGivesTheMeshOfAFile) {
  const IndexedMesh mesh = whittle::test::sphere(6);
  std::ostringstream out;
  write_mesh(out, Format::ply, mesh);
  ASSERT_GT(out.str().size(), std::size_t{1} << 20) << "it takes more than one block";
  const fs::path path = folder_ / "pipe.ply";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&] { write(path, out.str()); });
  const ReadResult result = read_mesh(path);
  writer.join();
  EXPECT_EQ(result.mesh.positions, mesh.positions);
  EXPECT_EQ(result.mesh.faces, mesh.faces);
}
#endif

}  // namespace
}  // namespace whittle::io
