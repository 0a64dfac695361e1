#include "fuzz/mutate.hh"

#include <array>
#include <cctype>
#include <cstring>
#include <string_view>

namespace whittle::test {

namespace {

constexpr std::array<std::string_view, 22> nasty_words = {
    "-1",    "0",          "1",          "2",          "3",          "255",
    "65536", "2147483647", "2147483648", "4294967295", "4294967296", "99999999999999999999",
    "nan",   "-inf",       "1e999",      "1e-320",     "-0",         "1.5",
    "x",     "\\\n",       "#",          "//"};
constexpr std::array<std::uint32_t, 8> nasty_integers = {0,          1,          3,          0x7FFFFFFF,
                                                         0x80000000, 0xFFFFFFFF, 0x7FC00000, 0x00010000};

// A part of the file, of at most 40 bytes.
struct Stretch {
  std::size_t begin;
  std::size_t length;
};

Stretch any_stretch(const std::string& file, Random& random) {
  const std::size_t begin = random.below(file.size());
  return {begin, std::min<std::size_t>(1 + random.below(40), file.size() - begin)};
}

void replace_number(std::string& file, Random& random) {
  std::size_t begin = random.below(file.size());
  while (begin < file.size() && std::isdigit(static_cast<unsigned char>(file[begin])) == 0) ++begin;
  std::size_t end = begin;
  while (end < file.size() && std::isdigit(static_cast<unsigned char>(file[end])) != 0) ++end;
  file.replace(begin, end - begin, nasty_words[random.below(nasty_words.size())]);
}

void damage(std::string& file, Random& random) {
  if (file.empty()) return;
  const Stretch part = any_stretch(file, random);
  switch (random.below(8)) {
    case 0:
      file[part.begin] = static_cast<char>(file[part.begin] ^ (1 << random.below(8)));
      break;
    case 1:
      file[part.begin] = static_cast<char>(random.below(256));
      break;
    case 2:
      file.erase(part.begin, part.length);
      break;
    case 3:
      file.insert(part.begin, file.substr(part.begin, part.length));
      break;
    case 4:
      file.insert(random.below(file.size()), file.substr(part.begin, part.length));
      break;
    case 5:
      file.resize(part.begin);
      break;
    case 6: {
      const std::uint32_t value = nasty_integers[random.below(nasty_integers.size())];
      std::memcpy(file.data() + part.begin, &value, std::min(part.length, sizeof(value)));
      break;
    }
    default:
      replace_number(file, random);
      break;
  }
}

}  // namespace

std::string mutated(std::string file, Random& random) {
  const std::uint64_t damages = 1 + random.below(4);
  for (std::uint64_t i = 0; i < damages; ++i) damage(file, random);
  return file;
}

}  // namespace whittle::test
