#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace whittle::test {

/// The file `name` ("bunny.obj", "nasty/fan3.obj") in the folder of real meshes (CMake's WHITTLE_TEST_MESHES); nothing
/// if the folder or the file is absent.
std::optional<std::filesystem::path> real_mesh(const std::string& name);

/// The file `name` in data/, which is always there. \throw std::runtime_error if it isn't.
std::filesystem::path data_mesh(const std::string& name);

}  // namespace whittle::test

/// Defines `variable` as the path of a real mesh, or skips the test with a message that names the missing mesh.
#define WHITTLE_REAL_MESH_OR_SKIP(variable, name)          \
  std::filesystem::path variable;                          \
  if (const auto found = ::whittle::test::real_mesh(name)) \
    variable = *found;                                     \
  else                                                     \
    GTEST_SKIP() << "no mesh " << (name) << " in " << WHITTLE_TEST_MESHES << " (CMake: WHITTLE_TEST_MESHES)"
