#pragma once

#include "structure/layers.hh"

/// Tests that aren't built: files `…_test.cc` that the nearest CMakeLists.txt above them neither names nor globs.
/// \param scripts CMakeLists.txt files
Findings unbuilt_tests(const SourceTree& tree, const SourceTree& scripts);
