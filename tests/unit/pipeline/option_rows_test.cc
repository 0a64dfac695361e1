#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "whittle/pipeline/request.hh"

namespace whittle::test {
namespace {

std::vector<std::string> words_of(const OptionRow& row) {
  std::vector<std::string> words;
  std::istringstream parts(row.access.meta);
  for (std::string word; std::getline(parts, word, '|');) {
    if (std::all_of(word.begin(), word.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; })) {
      words.push_back(word);
    }
  }
  return words;
}

TEST(OptionRows, SayEachThingOnce) {
  Request request;
  std::set<std::string> names;
  std::set<std::string> keys;
  for (const OptionRow& row : option_rows(request)) {
    SCOPED_TRACE(row.names + row.key);
    EXPECT_TRUE(row.names.empty() || names.insert(long_name(row)).second);
    EXPECT_TRUE(row.key.empty() || keys.insert(row.key).second);
    EXPECT_TRUE(!row.names.empty() || !row.key.empty());
    EXPECT_EQ(row.names.empty(), row.help.empty());
    EXPECT_EQ(row.names.empty(), row.group.empty());
  }
}

TEST(OptionRows, TakeTheWordsThatTheyShow) {
  Request request;
  std::size_t n_words = 0;
  for (const OptionRow& row : option_rows(request)) {
    for (const std::string& word : words_of(row)) {
      row.access.set(word);
      EXPECT_EQ(to_string(row.access.get()), word) << row.names;
      ++n_words;
    }
  }
  EXPECT_GT(n_words, 30U);
}

/// A row that lifts a reason takes the value that lifts it, and isn't at it where it refuses.
TEST(OptionRows, LiftReasonsByValuesThatTheyTake) {
  Request request;
  std::set<Refusal> lifted;
  for (const OptionRow& row : option_rows(request)) {
    if (!row.lift) continue;
    SCOPED_TRACE(row.names);
    lifted.insert(row.lift->reason);
    EXPECT_NE(row.lift->value, row.lift->cause);
    if (!row.lift->cause.empty()) {
      row.access.set(row.lift->cause);
      EXPECT_EQ(to_string(row.access.get()), row.lift->cause);
    }
    row.access.set(row.lift->value);
    EXPECT_EQ(to_string(row.access.get()), row.lift->value);
  }
  EXPECT_EQ(lifted.size(), 6U) << "all but the last face of an area, and the error, which is a target";
}

TEST(OptionRows, ReferToTheirRequest) {
  Request request;
  const OptionRows rows = option_rows(request);
  find_row(rows, "--face-ratio")->access.set("25%");
  find_row(rows, "--topology")->access.set("free");
  find_row(rows, "--min-radius-ratio")->access.set("0.1");
  find_row(rows, "--certify")->access.set("on");
  EXPECT_EQ(request.targets.face_ratio, 0.25);
  EXPECT_EQ(request.simplify.decimate.topology, Topology::free);
  EXPECT_EQ(request.simplify.decimate.min_radius_ratio, 0.1);
  EXPECT_TRUE(request.certify);
}

/// Every option that a cost refuses is a conflict of the option's row, for the reason that the traits give.
TEST(OptionRows, RefuseWhatCostsDoNotTake) {
  Request request;
  const OptionRows rows = option_rows(request);
  const auto expect_refused = [&](const std::string& option, const std::string& value, const CostTraits& traits,
                                  std::string_view why) {
    const std::string side = value.empty() ? option : option + ' ' + value;
    const std::string cost = "--cost " + std::string(traits.name);
    const auto is_given = [&](const std::string& given) { return given == side || given == cost; };
    const std::string expected = why.empty() ? "" : side + " doesn't go with " + cost + ": " + std::string(why);
    EXPECT_EQ(find_conflict(rows, is_given), expected);
  };
  for (const CostTraits& traits : all_cost_traits) {
    expect_refused("--weights", "uniform", traits, traits.why_not.weights);
    expect_refused("--weights", "area-angle", traits, traits.why_not.weights);
    expect_refused("--weights", "area", traits, "");
    expect_refused("--placement", "midpoint", traits, traits.why_not.placement);
    expect_refused("--placement", "endpoint", traits, traits.why_not.placement);
    expect_refused("--boundary-weight", "", traits, traits.why_not.boundary_weight);
    expect_refused("--isotropic", "", traits, traits.why_not.isotropy);
    expect_refused("--valence", "", traits, traits.why_not.valence_weight);
    expect_refused("--threshold", "", traits, traits.why_not.threshold);
  }
}

}  // namespace
}  // namespace whittle::test
