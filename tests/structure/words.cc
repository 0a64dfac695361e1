#include "structure/words.hh"

#include <regex>

namespace {

Findings matches(const SourceTree& tree, const std::string& folder, const std::string& but, const char* pattern) {
  const std::regex word(pattern);
  Findings findings;
  for (const auto& [path, text] : tree) {
    if (!path.starts_with(folder + "/") || path == but) continue;
    for (std::sregex_iterator found(text.begin(), text.end(), word); found != std::sregex_iterator(); ++found) {
      findings.push_back(path + ": " + found->str());
    }
  }
  return findings;
}

}  // namespace

Findings words_of_some_compilers(const SourceTree& tree, const std::string& folder, const std::string& but) {
  return matches(tree, folder, but,
                 R"(\b(__attribute__|__builtin_\w+|__extension__|__restrict\w*|__declspec|__forceinline|__int128)\b)"
                 R"(|\b(gnu|clang|msvc)::\w+|\basm\b|\b_mm\d*_\w+)");
}

Findings functions_rounded_anyhow(const SourceTree& tree, const std::string& folder) {
  return matches(tree, folder, "",
                 R"(std::(a?(sin|cos|tan)h?|atan2|exp2?|expm1|log(2|10|1p)?|pow|cbrt|hypot|[lt]gamma|erfc?)\()");
}
