// Each option of a request stands in the JSON report of `simplify`, with the value that was given.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "cli/report_keys/option_runs.hh"
#include "program/program.hh"
#include "whittle/core/text/text.hh"
#include "whittle/pipeline/request.hh"

namespace whittle::test {
namespace {

/// A value of a report, as the command line has it.
std::string text_of(const nlohmann::json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_number_float()) return shortest(value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

TEST(ReportKeys, OfSimplifyHaveTheValuesOfItsOptions) {
  const TemporaryFolder folder;
  Request request;
  const OptionRows rows = option_rows(request);
  std::set<std::string> shown;
  for (OptionRun& run : runs_with_options(folder)) {
    const OptionRow& row = *find_row(rows, run.name);
    if (row.key.empty()) continue;
    run.arguments.insert(run.arguments.begin(), "simplify");
    run.arguments.insert(run.arguments.end(), {"--json", "-"});
    const Outcome outcome = whittle(run.arguments);
    const std::string found = text_of(parse_json(outcome.out)["options"][row.key]);
    const std::string given = run.value.empty() ? "on" : run.value;
    EXPECT_TRUE(found == given || found.starts_with(given + ',')) << row.key << " is " << found << '\n' << outcome;
    shown.insert(run.name);
  }
  for (const OptionRow& row : rows) {
    const bool is_reported = !row.names.empty() && !row.key.empty();
    EXPECT_TRUE(!is_reported || shown.contains(long_name(row))) << "no run takes " << row.names;
  }
}

}  // namespace
}  // namespace whittle::test
