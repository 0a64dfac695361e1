#include "options/parse_problems.hh"

#include <algorithm>
#include <numeric>

namespace whittle::app {
namespace {

/// How many characters must be put in, taken out or replaced to make one word of the other (Levenshtein).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);  // from the beginning of a to each beginning of b
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + static_cast<std::size_t>(a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, diagonal + 1, replaced});
    }
  }
  return row.back();
}

std::vector<std::string> long_names(const CLI::App& sub) {
  std::vector<std::string> names;
  for (const CLI::Option* option : sub.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Of the arguments that no option takes, the first that looks like one, else the first.
std::string unexpected_argument(const CLI::App& sub) {
  const std::vector<std::string> rest = sub.remaining();
  if (rest.empty()) return {};
  const auto looks_like_option = [](const std::string& argument) { return argument.size() > 1 && argument[0] == '-'; };
  const auto option = std::find_if(rest.begin(), rest.end(), looks_like_option);
  return option != rest.end() ? *option : rest.front();
}

std::string unexpected(const CLI::App& sub) {
  const std::string argument = unexpected_argument(sub);
  if (argument.empty() || argument[0] != '-') return "one argument too many: '" + argument + "'";
  const std::string name = argument.substr(0, argument.find('='));
  return name + " is not an option of '" + sub.get_name() + "'" + did_you_mean(name, long_names(sub));
}

std::string given_twice(const CLI::App& sub) {
  for (const CLI::Option* option : sub.get_options()) {
    if (option->get_items_expected_max() == 1 && option->count() > 1) {
      return option->get_name() + " is given " + std::to_string(option->count()) + " times";
    }
  }
  return {};
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const auto distance = [&word](const std::string& candidate) { return edit_distance(word, candidate); };
  const auto best = std::min_element(candidates.begin(), candidates.end(),
                                     [&](const auto& x, const auto& y) { return distance(x) < distance(y); });
  if (best == candidates.end() || distance(*best) > std::max<std::size_t>(1, word.size() / 3)) return {};
  return "; did you mean '" + *best + "'?";
}

std::string problem_of(const CLI::App& sub, const CLI::ParseError& error) {
  std::string said = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return unexpected(sub);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return said;
  if (std::string twice = given_twice(sub); !twice.empty()) return twice;
  return said.substr(0, said.find(':')) + " needs a value";
}

}  // namespace whittle::app
