#include "whittle/pipeline/option.hh"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace whittle::test {
namespace {

enum class Fruit { apple, pear };
constexpr std::array<Choice<Fruit>, 2> fruits{{{"apple", Fruit::apple}, {"pear", Fruit::pear}}};

std::string told_after(const OptionAccess& access, const std::string& text) {
  access.set(text);
  return to_string(access.get());
}

TEST(OptionAccess, TellsWhatWasSet) {
  double x = 1;
  std::optional<double> maybe;
  std::optional<std::uint32_t> n;
  Fruit fruit = Fruit::apple;
  AutomaticLength automatic;
  std::optional<std::vector<std::string>> list;
  EXPECT_EQ(told_after(number(x, {0}, "X"), "0.25"), "0.25");
  EXPECT_EQ(x, 0.25);
  EXPECT_EQ(to_string(number_or_off(maybe, {0, 180}, "X", 180).get()), "180");
  EXPECT_EQ(told_after(number_or_off(maybe, {0, 180}, "X", 180), "40"), "40");
  EXPECT_EQ(told_after(number_or_off(maybe, {0, 180}, "X", 180), "180"), "180");
  EXPECT_FALSE(maybe);
  EXPECT_EQ(to_string(count(n).get()), "off");
  EXPECT_EQ(told_after(count(n), "7"), "7");
  EXPECT_EQ(told_after(choice(fruit, fruits), "pear"), "pear");
  EXPECT_EQ(told_after(automatic_length(automatic), "2%"), "2%");
  EXPECT_EQ(told_after(automatic_length(automatic), "auto"), "auto");
  EXPECT_EQ(told_after(names(list), "a,b"), "a,b");
  EXPECT_EQ(told_after(names(list), "none"), "none");
  EXPECT_EQ(told_after(names(list), "auto"), "auto");
  EXPECT_FALSE(list);
}

TEST(OptionAccess, TurnsFlagsOnAndOff) {
  bool strict = false;
  bool welds = true;
  EXPECT_EQ(told_after(flag(strict), "on"), "on");
  EXPECT_TRUE(strict);
  EXPECT_EQ(told_after(flag(strict), "off"), "off");
  EXPECT_FALSE(strict);
  EXPECT_EQ(to_string(flag(welds, false).get()), "off") << "--no-weld isn't given";
  EXPECT_EQ(told_after(flag(welds, false), "on"), "on");
  EXPECT_FALSE(welds);
  EXPECT_EQ(told_after(flag(welds, false), "off"), "off");
  EXPECT_TRUE(welds);
}

TEST(OptionAccess, LeavesAValueThatIsRefused) {
  double x = 0.5;
  Fruit fruit = Fruit::pear;
  std::optional<Length> length;
  EXPECT_THROW(number(x, {0, 1}, "X").set("1.5"), std::invalid_argument);
  EXPECT_THROW(choice(fruit, fruits).set("plum"), std::invalid_argument);
  EXPECT_THROW(length_above_zero(length).set("0"), std::invalid_argument);
  EXPECT_EQ(x, 0.5);
  EXPECT_EQ(fruit, Fruit::pear);
  EXPECT_FALSE(length);
}

IsGiven given(const std::set<std::string>& sides) {
  return [sides](const std::string& side) { return sides.contains(side); };
}

TEST(FindConflict, NamesBothSidesAndTheReason) {
  const OptionRows rows{{.names = "-a,--apple", .conflicts = {{"red", "--pear", "one fruit alone"}}},
                        {.names = "--pear", .conflicts = {{.other = "--plum", .why = "neither"}}}};
  EXPECT_EQ(find_conflict(rows, given({"--apple", "--apple red"})), "");
  EXPECT_EQ(find_conflict(rows, given({"--apple", "--apple green", "--pear"})), "");
  EXPECT_EQ(find_conflict(rows, given({"--apple", "--apple red", "--pear"})),
            "--apple red doesn't go with --pear: one fruit alone");
  EXPECT_EQ(find_conflict(rows, given({"--pear", "--plum"})), "--pear doesn't go with --plum: neither");
}

TEST(FindIdle, SaysWhatAnOptionNeedsOrWhatStopsIt) {
  const OptionRows rows{{.names = "--every", .idle = {{.without = {"--frames", "--animate"}}}},
                        {.names = "--boundary", .idle = {{.value = "free", .with = "--cost midpoint"}}}};
  EXPECT_TRUE(find_idle(rows, given({})).empty());
  EXPECT_TRUE(find_idle(rows, given({"--every", "--animate"})).empty());
  EXPECT_EQ(find_idle(rows, given({"--every"})), std::vector<std::string>{"'--every' does nothing without '--frames'"});
  EXPECT_TRUE(find_idle(rows, given({"--boundary", "--boundary locked", "--cost midpoint"})).empty());
  EXPECT_EQ(find_idle(rows, given({"--boundary", "--boundary free", "--cost midpoint"})),
            std::vector<std::string>{"'--boundary free' does nothing with '--cost midpoint'"});
}

}  // namespace
}  // namespace whittle::test
