#include "structure/layers.hh"

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace {

[[noreturn]] void reject(const std::string& line, const std::string& why) {
  throw std::runtime_error("layers: \"" + line + "\": " + why);
}

Layer read_row(const std::string& line, const std::vector<Layer>& earlier) {
  std::istringstream words(line);
  Layer layer;
  std::string word;
  words >> layer.name;
  while (words >> word && word != "uses") layer.folders.push_back(word);
  if (word != "uses" || layer.folders.empty()) reject(line, "not: name, folders, `uses`, names");
  while (words >> word) {
    if (word == "all") {
      for (const Layer& l : earlier) layer.uses.insert(l.name);
      continue;
    }
    const bool known = std::any_of(earlier.begin(), earlier.end(), [&](const Layer& l) { return l.name == word; });
    if (!known) reject(line, word + " is not an earlier row");
    layer.uses.insert(word);
  }
  return layer;
}

/// The layer of the longest folder that contains the path; null if there is none.
const Layer* layer_of(const std::vector<Layer>& layers, const std::string& path) {
  const Layer* found = nullptr;
  std::size_t longest = 0;
  for (const Layer& layer : layers)
    for (const std::string& folder : layer.folders)
      if (path.starts_with(folder + "/") && folder.size() > longest) {
        longest = folder.size();
        found = &layer;
      }
  return found;
}

/// x_impl.hh includes x.hh, and x.hh includes it at its end. For other files the two are one file.
bool is_own_declaration(const Include& include) {
  const std::size_t suffix = include.from.rfind("_impl.hh");
  return suffix != std::string::npos && include.to == include.from.substr(0, suffix) + ".hh";
}

}  // namespace

std::vector<Layer> read_layers(const std::string& text) {
  std::vector<Layer> layers;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line.front() != '#') layers.push_back(read_row(line, layers));
  return layers;
}

Findings forbidden_includes(const SourceTree& tree, const std::vector<Layer>& layers) {
  Findings findings;
  for (const auto& [path, text] : tree)
    if (!layer_of(layers, path)) findings.push_back(path + " is in no layer");
  for (const Include& include : includes_of(tree)) {
    if (include.to.empty()) {
      findings.push_back(include.from + " includes \"" + include.name + "\", which is no file of the project");
      continue;
    }
    const Layer* from = layer_of(layers, include.from);
    const Layer* to = layer_of(layers, include.to);
    if (!from || !to || from == to || from->uses.contains(to->name)) continue;
    findings.push_back(include.from + " (" + from->name + ") includes " + include.to + " (" + to->name + ")");
  }
  return findings;
}

Findings idle_rows(const SourceTree& tree, const std::vector<Layer>& layers) {
  Findings findings;
  for (const Layer& layer : layers)
    for (const std::string& folder : layer.folders)
      if (std::none_of(tree.begin(), tree.end(),
                       [&](const auto& file) { return file.first.starts_with(folder + "/"); }))
        findings.push_back(layer.name + ": no file is in " + folder);
  return findings;
}

Findings include_circles(const SourceTree& tree) {
  std::map<std::string, std::vector<std::string>> edges;
  for (const Include& include : includes_of(tree))
    if (!include.to.empty() && !is_own_declaration(include)) edges[include.from].push_back(include.to);

  Findings findings;
  std::map<std::string, bool> done;  // absent: not seen; false: on the path
  std::vector<std::string> path;
  const std::function<void(const std::string&)> visit = [&](const std::string& file) {
    if (const auto seen = done.find(file); seen != done.end()) {
      if (seen->second) return;
      std::string circle;
      for (auto step = std::find(path.begin(), path.end(), file); step != path.end(); ++step) circle += *step + " -> ";
      findings.push_back(circle + file);
      return;
    }
    done[file] = false;
    path.push_back(file);
    for (const std::string& next : edges[file]) visit(next);
    path.pop_back();
    done[file] = true;
  };
  for (const auto& [file, text] : tree) visit(file);
  return findings;
}
