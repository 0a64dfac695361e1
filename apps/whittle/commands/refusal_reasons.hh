#pragma once

#include <cstdint>

#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// A reason for which pairs are refused, in words that follow a number of them.
struct RefusalReason {
  std::uint64_t Rejections::*count;
  const char* text;
};

inline constexpr RefusalReason refusal_reasons[] = {{&Rejections::link, "by topology"},
                                                    {&Rejections::flip, "by turning a face"},
                                                    {&Rejections::shape, "by shape"},
                                                    {&Rejections::feature, "by features or seams"},
                                                    {&Rejections::area, "by the last face of a chart or region"},
                                                    {&Rejections::locked, "locked"},
                                                    {&Rejections::intersection, "by intersecting"},
                                                    {&Rejections::error, "by error"}};

}  // namespace whittle::app
