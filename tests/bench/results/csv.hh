#pragma once

#include <optional>
#include <string>
#include <vector>

// Comma-separated values, and numbers as text.

namespace whittle::bench {

/// \param format printf format for a double
std::string formatted(const char* format, double value);
/// "-" without a value.
std::string text_or_dash(const std::optional<double>& value, const char* format);

/// The cells with commas between them, quoted if needed, and the end of the line.
std::string csv_line(const std::vector<std::string>& cells);

/// Six significant digits; empty without a value.
std::string csv_number(const std::optional<double>& value);

}  // namespace whittle::bench
