// Writes the tables of options on the pages of docs/user anew, from the help of the program: those between
// <!-- options: GROUP --> and <!-- end -->. Run it after a change of an option.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "program/help_text.hh"
#include "program/program.hh"

namespace whittle::test {
namespace {

const std::string opening = "<!-- options: ";
const std::string closing = "<!-- end -->";

std::string with_tables(const std::string& page, const std::string& help) {
  std::string result;
  bool is_inside = false;
  for (const std::string& line : lines_of(page)) {
    if (line == closing) is_inside = false;
    if (!is_inside) result += line + '\n';
    if (!line.starts_with(opening)) continue;
    const std::size_t end = line.find(" -->");
    result += short_table_of(options_of_group(help, line.substr(opening.size(), end - opening.size())));
    is_inside = true;
  }
  return result;
}

void write_tables(const std::filesystem::path& path) {
  const std::string page = read_text(path);
  if (page.find(opening) == std::string::npos) return;
  const bool is_index = path.stem() == "README";  // it has the options that all subcommands share
  const std::string help = whittle({is_index ? "simplify" : path.stem().string(), "--help"}).out;
  const std::string written = with_tables(page, help);
  if (written == page) return;
  std::ofstream(path) << written;
  std::cout << path.string() << '\n';
}

}  // namespace
}  // namespace whittle::test

int main() {
  for (const auto& entry : std::filesystem::directory_iterator(WHITTLE_DOCS_DIR "/user")) {
    if (entry.path().extension() == ".md") whittle::test::write_tables(entry.path());
  }
}
