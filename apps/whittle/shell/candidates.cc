#include "shell/candidates.hh"

#include <algorithm>
#include <sstream>

#include "options/command_line.hh"
#include "whittle/scene/format.hh"

namespace whittle::app {
namespace {

bool is_word(const std::string& part) {
  return !part.empty() && part != "-" && std::all_of(part.begin(), part.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

}  // namespace

Candidates candidates_of(const CLI::Option& option) {
  Candidates candidates;
  std::istringstream parts(option.get_type_name());
  for (std::string part; std::getline(parts, part, '|');) {
    if (is_word(part)) candidates.words.push_back(part);
    if (part == "FILE") candidates.files = FileCandidates::all;
    if (part == "OUT") candidates.files = FileCandidates::meshes;
    if (part != "EXT") continue;
    for (const io::Format format : io::all_formats) candidates.words.emplace_back(io::name_of(format));
  }
  if (option.get_positional() && option.get_type_name().empty()) candidates.files = FileCandidates::meshes;
  return candidates;
}

std::vector<std::string> mesh_extensions() {
  std::vector<std::string> extensions;
  for (const SceneFormat* format : scene_formats()) {
    for (const std::string_view extension : format->extensions) {
      extensions.emplace_back(extension);
      if (!format->is_document) extensions.push_back(std::string(extension) + ".gz");
    }
  }
  return extensions;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<const CLI::App*> subcommands_of(const CLI::App& app) { return app.get_subcommands({}); }

std::vector<const CLI::Option*> named_options_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return !option->get_positional(); });
}

std::vector<const CLI::Option*> arguments_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string with_backslashes(const std::string& text, const std::string& special) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace whittle::app
