#pragma once

#include <string>

#include "structure/layers.hh"

/// "path: word" for words that only some compilers have, in files under `folder`. \param but the one file that may
Findings words_of_some_compilers(const SourceTree& tree, const std::string& folder, const std::string& but);

/// "path: word" for functions of <cmath> that each system rounds in its own way, in files under `folder`.
Findings functions_rounded_anyhow(const SourceTree& tree, const std::string& folder);
