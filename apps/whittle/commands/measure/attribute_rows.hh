#pragma once

#include <span>
#include <string>

#include "files/report.hh"
#include "whittle/metrics/attribute_deviation.hh"

namespace whittle::app {

/// [{"name", "kind", "mean", "max", "forward", "backward"}, …]
Json attributes_json(std::span<const metrics::AttributeDeviation> attributes);

/// A row for each attribute, for people; empty if there is none.
std::string attributes_table(std::span<const metrics::AttributeDeviation> attributes);

}  // namespace whittle::app
