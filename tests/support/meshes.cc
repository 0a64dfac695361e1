#include "support/meshes.hh"

#include <stdexcept>

namespace whittle::test {

std::optional<std::filesystem::path> real_mesh(const std::string& name) {
  std::error_code error;
  auto path = std::filesystem::path(WHITTLE_TEST_MESHES) / name;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  return path;
}

std::filesystem::path data_mesh(const std::string& name) {
  auto path = std::filesystem::path(WHITTLE_DATA_DIR) / name;
  if (!std::filesystem::is_regular_file(path)) throw std::runtime_error("no mesh " + path.string());
  return path;
}

}  // namespace whittle::test
