#pragma once

#include <optional>
#include <string>
#include <vector>

// Comma-separated values, and numbers as text.

namespace whittle::bench {

/// \param format as printf takes it for a double
std::string formatted(const char* format, double value);
/// "-" without a value.
std::string text_or_dash(const std::optional<double>& value, const char* format);

/// The cells with commas between them and the end of the line; quoted where it has to be.
std::string csv_line(const std::vector<std::string>& cells);

/// Six digits that count; empty without a value.
std::string csv_number(const std::optional<double>& value);

}  // namespace whittle::bench
