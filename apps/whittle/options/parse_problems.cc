#include "options/parse_problems.hh"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

namespace whittle::app {
namespace {

/// Number of characters to insert, remove or replace to turn one word into the other (Levenshtein).
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

bool looks_like_option(const std::string& argument) { return argument.size() > 1 && argument[0] == '-'; }

/// The unused arguments, first those before the subcommand, without "--".
std::vector<std::string> left_over(const CLI::App& sub) {
  std::vector<std::string> arguments = sub.get_parent()->remaining(true);
  arguments.erase(std::remove(arguments.begin(), arguments.end(), "--"), arguments.end());
  return arguments;
}

/// An option of an older program, and its counterpart here.
struct OlderOption {
  std::string_view name;
  std::string_view needs;  ///< the argument or option that does the same
  std::string_view advice;
};
constexpr std::array<OlderOption, 3> older_options{{
    {"-i", "IN", "IN is an argument without an option: 'simplify IN -o OUT'"},
    {"-p", "--ratio", "the share of the vertices to keep is '--ratio'"},
    {"-isotropic", "--isotropic", "edges of even length are '--isotropic W', with 0 <= W <= 1"},
}};

/// ": COUNTERPART", if the subcommand has it. Older programs have no subcommands, but all of them simplify.
std::string advice_on_older(const CLI::App& sub, const std::string& argument) {
  for (const OlderOption& older : older_options) {
    if (argument != older.name || sub.get_option_no_throw(std::string(older.needs)) == nullptr) continue;
    std::string advice = ": " + std::string(older.advice);
    const std::size_t place = advice.find("simplify");
    return place == std::string::npos ? advice : advice.replace(place, 8, sub.get_name());
  }
  return {};
}

/// The problem with the first unknown argument that looks like an option, or empty.
std::string unknown_option(const CLI::App& sub) {
  const std::vector<std::string> arguments = left_over(sub);
  const auto argument = std::find_if(arguments.begin(), arguments.end(), looks_like_option);
  if (argument == arguments.end()) return {};
  const std::string name = argument->substr(0, argument->find('='));
  if (name == "-") return "a short option takes no '=': '" + argument->substr(1) + "'";
  if (sub.get_option_no_throw(name) != nullptr) return name + " must come after '" + sub.get_name() + "'";
  const bool is_output = name == "-o" || name == "--output";
  if (is_output && sub.get_option_no_throw("OUT") != nullptr) {
    return name + " is not an option of '" + sub.get_name() + "': OUT is its second argument, '" + sub.get_name() +
           " IN OUT'";
  }
  const std::string older = advice_on_older(sub, name);
  return name + " is not an option of '" + sub.get_name() + "'" +
         (older.empty() ? did_you_mean(name, long_names(sub)) : older);
}

std::string unexpected(const CLI::App& sub) {
  if (std::string unknown = unknown_option(sub); !unknown.empty()) return unknown;
  const std::vector<std::string> arguments = left_over(sub);
  return "one argument too many: '" + (arguments.empty() ? "" : arguments.front()) + "'";
}

std::string given_twice(const CLI::App& sub) {
  for (const CLI::Option* option : sub.get_options()) {
    if (option->get_items_expected_max() == 1 && option->count() > 1) {
      return option->get_name() + " is given " + std::to_string(option->count()) + " times";
    }
  }
  return {};
}

/// The problem of an option with too many or too few values.
/// \param said CLI11's words, which begin with the option's name
std::string mismatch(const CLI::App& sub, const std::string& said) {
  if (std::string twice = given_twice(sub); !twice.empty()) return twice;
  const std::string name = said.substr(0, said.find_first_of(": "));
  if (name.starts_with('-')) return name + " needs a value";
  return "--" + name + " takes no value";
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
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) return mismatch(sub, said);
  if (dynamic_cast<const CLI::RequiredError*>(&error) == nullptr) return said;
  // A mistyped name is why the option seems to be missing.
  std::string unknown = unknown_option(sub);
  return unknown.empty() ? said : unknown;
}

}  // namespace whittle::app
