// The quick form of every case passes, its bounds mean something, and every case notices when a law
// that it guards is wrong by a factor of two.
#include "verification/framework/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/parallel.hpp"

namespace retiarius::verification {
namespace {

std::string identifier(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

class QuickForm : public ::testing::TestWithParam<const Case*> {};

void expect_meaningful(const Comparison& c) {
  SCOPED_TRACE(c.quantity);
  EXPECT_FALSE(c.quantity.empty());
  EXPECT_FALSE(c.source.empty());
  EXPECT_FALSE(c.argument.empty());
  EXPECT_GE(c.bound, 0.0);  // 0: exactly
  // A bound that would pass a wrong factor of two is none: half of the reference is the limit.
  if (c.kind == ErrorKind::relative) {
    EXPECT_LE(c.bound, 0.2);
  } else if (c.reference != 0.0) {
    EXPECT_LT(c.bound, 0.5 * std::abs(c.reference));
  }
}

void expect_legible(const Chart& chart) {
  SCOPED_TRACE(chart.title);
  EXPECT_FALSE(chart.title.empty());
  EXPECT_FALSE(chart.caption.empty());
  EXPECT_FALSE(chart.source.empty());
  EXPECT_FALSE(chart.x_label.empty());
  EXPECT_FALSE(chart.y_label.empty());
  EXPECT_FALSE(chart.curves.empty());
  for (const Curve& curve : chart.curves) {
    EXPECT_EQ(curve.x.size(), curve.y.size()) << curve.name;
    EXPECT_FALSE(curve.x.empty()) << curve.name;
  }
}

TEST_P(QuickForm, Passes) {
  const Case& of = *GetParam();
  const CaseResult result = run_case(of, true);
  EXPECT_EQ(result.failure, "");
  EXPECT_FALSE(result.charts.empty());
  for (const Comparison& c : result.comparisons) {
    EXPECT_TRUE(c.passes()) << c.quantity << ": ours " << c.ours << ", reference " << c.reference
                            << ", error " << c.error() << ", bound " << c.bound;
    expect_meaningful(c);
  }
  for (const Chart& chart : result.charts) expect_legible(chart);
  RecordProperty("wall_time", std::to_string(result.wall_time));
}

INSTANTIATE_TEST_SUITE_P(Ladder, QuickForm, ::testing::ValuesIn(chosen_cases({})),
                         [](const auto& p) { return identifier(p.param->name); });

struct Guard {
  const Case* of;
  std::string law;
};

std::vector<Guard> guards() {
  std::vector<Guard> all;
  for (const Case& c : all_cases())
    for (const std::string& law : c.guards) all.push_back({&c, law});
  return all;
}

void PrintTo(const Guard& guard, std::ostream* out) { *out << guard.of->name << ", " << guard.law; }

class Faulty : public ::testing::TestWithParam<Guard> {};

TEST_P(Faulty, LawIsNoticed) {
  const Guard& guard = GetParam();
  const CaseResult result = run_case(*guard.of, true, {guard.law, 2.0});
  // A run that breaks off would be noticed too, but tells nothing of the bounds.
  EXPECT_EQ(result.failure, "");
  EXPECT_TRUE(std::any_of(result.comparisons.begin(), result.comparisons.end(),
                          [](const Comparison& c) { return !c.passes(); }))
      << guard.of->name << " passes with " << guard.law << " doubled";
}

INSTANTIATE_TEST_SUITE_P(Ladder, Faulty, ::testing::ValuesIn(guards()), [](const auto& p) {
  return identifier(p.param.of->name + "_" + p.param.law);
});

TEST(Ladder, GuardsEveryLawAtLeastTwice) {
  std::map<std::string, int> count;
  for (const Guard& guard : guards()) {
    EXPECT_THAT(fault_names(), ::testing::Contains(guard.law)) << guard.of->name;
    ++count[guard.law];
  }
  for (const std::string& name : fault_names()) EXPECT_GE(count[name], 2) << name;
}

TEST(Ladder, CasesHaveNamesOfTheirOwn) {
  std::map<std::string, int> count;
  for (const Case& c : all_cases()) {
    EXPECT_EQ(++count[c.name], 1) << c.name;
    EXPECT_FALSE(c.title.empty()) << c.name;
    EXPECT_FALSE(c.about.empty()) << c.name;
    EXPECT_FALSE(c.source.empty()) << c.name;
  }
}

TEST(Ladder, NamesWhatIsUnknown) {
  try {
    chosen_cases({"hexagon-gravty"});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("hexagon-gravty"));
    EXPECT_THAT(e.what(), ::testing::HasSubstr("hexagon-gravity"));
  }
}

bool same(const CaseResult& a, const CaseResult& b) {
  return std::equal(a.comparisons.begin(), a.comparisons.end(), b.comparisons.begin(),
                    b.comparisons.end(),
                    [](const Comparison& p, const Comparison& q) { return p.ours == q.ours; });
}

// Cases share the process; none may disturb another.
TEST(Ladder, GivesTheSameSideBySide) {
  const std::vector<const Case*> twice(4, chosen_cases({"hexagon-gravity"}).front());
  const std::vector<Rung> together = climb(twice, true, 3);
  const CaseResult alone = run_case(*twice.front(), true);
  for (const Rung& rung : together) EXPECT_TRUE(same(rung.result, alone));
}

TEST(Ladder, ACaseThatThrowsFails) {
  Case broken = *chosen_cases({"hexagon-gravity"}).front();
  broken.run = [](Context& context) { context.mission("nowhere"); };
  const CaseResult result = run_case(broken, true);
  EXPECT_FALSE(result.passes());
  EXPECT_THAT(result.failure, ::testing::HasSubstr("nowhere"));
}

}  // namespace
}  // namespace retiarius::verification
