// Compares hashes of results with a table, and says which differ. The results must not depend on the machine: neither
// on the processor and its registers, nor on the compiler and its optimisation, nor on the system's library.
//
//   same_bytes           compares with hashes.txt
//   same_bytes --write   writes hashes.txt anew, after a change that is meant to change results
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "cases.hh"

namespace {

/// FNV-1a, byte for byte.
class Hash {
 public:
  template <class T>
  void add(const T& number) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof(T));
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 1099511628211U;
  }
  std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%08x%08x", static_cast<unsigned>(value_ >> 32),
                  static_cast<unsigned>(value_ & 0xffffffffU));
    return digits;
  }

 private:
  std::uint64_t value_ = 14695981039346656037U;
};

std::string hash_of(const whittle::IndexedMesh& mesh) {
  Hash hash;
  for (const auto& point : mesh.positions) {
    for (const double x : point) hash.add(x);
  }
  for (const auto& face : mesh.faces) {
    for (const auto corner : face) hash.add(corner);
  }
  for (const auto& normal : mesh.normals) {
    for (const float x : normal) hash.add(x);
  }
  for (const auto& color : mesh.colors) {
    for (const float x : color) hash.add(x);
  }
  for (const auto& attribute : mesh.attributes) {
    for (const double x : attribute.values) hash.add(x);
  }
  for (const auto wedge : mesh.wedges) hash.add(wedge);
  return hash.text();
}

std::map<std::string, std::string> read_table() {
  std::map<std::string, std::string> table;
  std::ifstream file(WHITTLE_HASHES);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string hash, result;
    if (line.starts_with('#') || !(words >> hash >> result)) continue;
    table[result] = hash;
  }
  return table;
}

void write_table(const std::vector<whittle::test::Case>& cases) {
  std::ofstream file(WHITTLE_HASHES);
  file << "# Written by `same_bytes --write` (tests/README.md).\n";
  for (const auto& [result_name, result] : cases) file << hash_of(result()) << ' ' << result_name << '\n';
}

/// Says which results differ. \return how many
int compare(const std::vector<whittle::test::Case>& cases) {
  const std::map<std::string, std::string> table = read_table();
  int n_different = table.size() == cases.size() ? 0 : 1;
  if (n_different > 0) std::printf("hashes.txt has %zu results, not %zu\n", table.size(), cases.size());
  for (const auto& [result_name, result] : cases) {
    const auto row = table.find(result_name);
    const std::string expected = row == table.end() ? "nothing" : row->second;
    const std::string hash = hash_of(result());
    if (hash == expected) continue;
    std::printf("%s differs: %s, not %s\n", result_name.c_str(), hash.c_str(), expected.c_str());
    ++n_different;
  }
  std::printf("%zu results, %d differ\n", cases.size(), n_different);
  return n_different;
}

}  // namespace

int main(int argc, char** argv) {
  const bool writes = argc == 2 && std::strcmp(argv[1], "--write") == 0;
  if (argc != 1 && !writes) {
    std::fputs("same_bytes [--write]\n", stderr);
    return 2;
  }
  try {
    const std::vector<whittle::test::Case> cases = whittle::test::cases(WHITTLE_DATA_DIR);
    if (!writes) return compare(cases) == 0 ? 0 : 1;
    write_table(cases);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "same_bytes: %s\n", problem.what());
    return 2;
  }
}
