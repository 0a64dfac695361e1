#include "companions.hh"

#include <algorithm>
#include <set>
#include <system_error>

#include "whittle/core/text/text.hh"
#include "whittle/io/path_of.hh"
#include "whittle/io/whole_file.hh"

namespace whittle {
namespace {

namespace fs = std::filesystem;

/// Copies a file. \return the reason of a failure, or empty
std::string copied(io::OutputFiles& files, const fs::path& from, const fs::path& to, const fs::path& name,
                   bool& is_new) {
  std::error_code error;
  if (!is_inside(name)) return "outside of the folder";
  if (!fs::exists(from / name, error)) return fs::exists(to / name, error) ? "" : "not there";
  const std::optional<std::string> content = io::content_of(from / name);
  if (!content) return "can't be read";
  if (fs::exists(to / name, error)) return io::content_of(to / name) == content ? "" : "there is another one";
  is_new = files.write_with_folders((to / name).string(), *content);
  return "";
}

}  // namespace

bool is_inside(const fs::path& name) {
  return name.is_relative() && std::none_of(name.begin(), name.end(), [](const auto& part) { return part == ".."; });
}

void copy_companions(io::OutputFiles& files, const std::string& input, const std::string& output,
                     std::span<const fs::path> names, SceneMessages& messages) {
  std::error_code error;
  const fs::path from = folder_of(input);
  const fs::path to = folder_of(output);
  if (input == standard_stream || output == standard_stream || fs::equivalent(from, to, error)) return;
  std::vector<std::string> new_files;
  std::string missing;
  std::set<fs::path> seen;
  for (const fs::path& name : names) {
    if (name.is_absolute() || to / name == io::path_of(output) || !seen.insert(name.lexically_normal()).second)
      continue;
    bool is_new = false;
    const std::string problem = copied(files, from, to, name, is_new);
    if (is_new) new_files.push_back(name.generic_string());
    if (!problem.empty()) missing += (missing.empty() ? "" : ", ") + name.generic_string() + " (" + problem + ")";
  }
  if (!new_files.empty()) {
    const std::string others = counted(new_files.size() - 1, "more file", "more files");
    messages.notes.push_back(
        about(output, "copied " + new_files.front() + (new_files.size() > 1 ? " and " + others : "") + " beside it"));
  }
  if (missing.empty()) return;
  messages.warnings.push_back(about(output, "needs files that were not copied: " + missing));
}

}  // namespace whittle
