#include "fuzz/decode/command_line_bytes.hh"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "fuzz/check/promise.hh"

namespace whittle::test {
namespace {

constexpr std::array<std::string_view, 6> subcommands{"simplify", "measure", "info", "polish", "compare", "help"};

constexpr std::array<std::string_view, 53> options{"--faces",
                                                   "--vertices",
                                                   "-r",
                                                   "--ratio",
                                                   "--face-ratio",
                                                   "--max-cost",
                                                   "--strict",
                                                   "-o",
                                                   "--output",
                                                   "--format",
                                                   "--no-weld",
                                                   "--map",
                                                   "-t",
                                                   "--threshold",
                                                   "--max-pairs",
                                                   "--across-walls",
                                                   "--topology",
                                                   "--prune",
                                                   "--effort",
                                                   "--cost",
                                                   "--weights",
                                                   "--placement",
                                                   "--valence",
                                                   "--isotropic",
                                                   "--order",
                                                   "--polish",
                                                   "--engine",
                                                   "--boundary",
                                                   "--samples",
                                                   "--seed",
                                                   "--feature-angle",
                                                   "--feature-tolerance",
                                                   "--max-normal-flip",
                                                   "--boundary-weight",
                                                   "--json",
                                                   "-q",
                                                   "--quiet",
                                                   "-v",
                                                   "--verbose",
                                                   "--force",
                                                   "--threads",
                                                   "-h",
                                                   "--help",
                                                   "-V",
                                                   "--version",
                                                   "--min-radius-ratio",
                                                   "--passes",
                                                   "--flips",
                                                   "--weld",
                                                   "--ascii",
                                                   "--",
                                                   "-",
                                                   "--normals"};

constexpr std::array<std::string_view, 52> values{"in.ply",     "out.obj",
                                                  "a.stl",      "b.off",
                                                  "1",          "0",
                                                  "2",          "-1",
                                                  "3.5",        "10%",
                                                  "0%",         "100%",
                                                  "1e3",        "1e-300",
                                                  "1e999",      "nan",
                                                  "inf",        "-inf",
                                                  "0x10",       "4294967296",
                                                  "keep",       "free",
                                                  "fast",       "normal",
                                                  "best",       "quadric",
                                                  "memoryless", "lindstrom-turk",
                                                  "midpoint",   "area",
                                                  "uniform",    "area-angle",
                                                  "optimal",    "endpoint",
                                                  "exact",      "approximate",
                                                  "flat",       "openmesh",
                                                  "weighted",   "locked",
                                                  "auto",       "ply",
                                                  "obj",        "stl",
                                                  "off",        "180",
                                                  "45",         "",
                                                  " ",          "18446744073709551616",
                                                  "%",          "recompute"};

std::string any_word(ByteSource& source) {
  std::string word;
  for (int n = source.below(12); n > 0; --n) {
    const auto c = static_cast<char>(source.byte());
    word += c == 0 || c == '/' ? '?' : c;
  }
  return word;
}

std::string pick(std::span<const std::string_view> words, ByteSource& source) {
  return std::string(words[source.below(static_cast<unsigned>(words.size()))]);
}

/// A word with one character changed.
std::string misspelt(std::string word, ByteSource& source) {
  if (word.empty()) return word;
  const std::size_t at = source.below(static_cast<unsigned>(word.size()));
  if (source.one_in(2)) return word.erase(at, 1);
  word[at] = static_cast<char>('a' + source.below(26));
  return word;
}

std::string decode_word(ByteSource& source) {
  switch (source.below(8)) {
    case 0:
      return any_word(source);
    case 1:
      return misspelt(pick(options, source), source);
    case 2:
      return pick(options, source) + '=' + pick(values, source);
    case 3:
    case 4:
      return pick(values, source);
    default:
      return pick(options, source);
  }
}

bool is_one_line(const std::string& text) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  return !text.empty() && text.back() == '\n' && std::none_of(text.begin(), text.end() - 1, is_control);
}

}  // namespace

std::vector<std::string> decode_command_line(ByteSource& source) {
  std::vector<std::string> arguments;
  const unsigned first = source.below(20);
  if (first < 18) arguments.emplace_back(subcommands[first % subcommands.size()]);
  if (first == 18) arguments.push_back(misspelt(pick(subcommands, source), source));
  if (source.one_in(2)) arguments.insert(arguments.end(), {"in.ply", "-o", "out.ply", "--faces", "10"});
  while (!source.is_empty() && arguments.size() < 24) arguments.push_back(decode_word(source));
  return arguments;
}

void check_ending(const std::vector<std::string>& arguments, const Ending& ending) {
  const auto& [exit_code, out, err] = ending;
  if (exit_code == 0) {
    require(err.empty() && !out.empty(), "help and version go to standard output");
    const auto asks = [](const std::string& word) {
      return word.starts_with("-h") || word.starts_with("--help") || word.starts_with("-V") ||
             word.starts_with("--version") || word == "help" || (word.starts_with('-') && !word.starts_with("--"));
    };
    require(std::any_of(arguments.begin(), arguments.end(), asks), "without an input nothing is done");
    return;
  }
  require(exit_code == 2 || exit_code == 4, "the command line is wrong, or the input can't be read");
  require(out.empty(), "errors go to standard error");
  require(is_one_line(err), "an error is one line");
  require(err.starts_with("whittle: ") && err.size() > 12, "an error names the program");
  require(exit_code == 4 || err.ends_with("--help'\n"), "a usage error names the help");
  require(err.find("required but received") == std::string::npos, "messages are in plain words");
}

}  // namespace whittle::test
