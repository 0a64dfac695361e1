#pragma once

#include <cstdint>
#include <string>
#include <vector>

// Numbers and names in messages.

namespace whittle {

/// The shortest decimal text that reads back as x: "75", "0.3", "1e-09".
std::string shortest(double x);
/// Four significant digits: "0.01234", "1.234e-05".
std::string significant(double x);
/// A share in [0, 1] with four significant digits: "1.234 %".
std::string percent(double share);
/// A length and its share of the diagonal: "1.234 (0.5 %)".
std::string length_text(double length, double diagonal);
/// The same, each with four significant digits, but rounded up: "at most".
std::string length_text_rounded_up(double length, double diagonal);
/// "0.034 s"
std::string seconds_text(double seconds);

/// "1 part", "7 parts"
std::string counted(std::uint64_t n, const std::string& singular, const std::string& plural);
std::string faces_text(std::uint64_t n);     ///< "1 face", "7 faces"
std::string vertices_text(std::uint64_t n);  ///< "1 vertex", "7 vertices"
/// "a, b, c"
std::string listed(const std::vector<std::string>& names);
/// "NAME: TEXT": a line about a file.
std::string about(const std::string& name, const std::string& text);

}  // namespace whittle
