// From ids to inputs: determinism, designs and distributions.
#include "retiarius/campaign/plan.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "retiarius/campaign/read_campaign.hpp"
#include "retiarius/campaign/variable.hpp"
#include "retiarius/mission/key.hpp"
#include "tests/campaign/texts.hpp"

namespace retiarius {
namespace {

using testing::campaign_text;
using ::testing::ElementsAre;
using testing::uniform_variable;

std::string two_variables() { return uniform_variable("side") + uniform_variable("mesh"); }

TEST(Plan, IsAFunctionOfTheIdAlone) {
  for (const char* design : {"latin-hypercube", "sobol", "monte-carlo", "saltelli"}) {
    const std::string plan = std::string("design = \"") + design + "\"\nruns = 50\nseed = 3";
    const CampaignSpec a = parse_campaign(campaign_text(plan, two_variables()));
    const CampaignSpec b = parse_campaign(campaign_text(plan, two_variables()));
    const CampaignPlan forward(a), backward(b);
    std::set<std::vector<double>> points;
    std::set<std::int64_t> seeds;
    for (std::int64_t id = 0; id < forward.runs(); ++id) {
      const std::int64_t other = forward.runs() - 1 - id;
      EXPECT_EQ(forward.run(other).inputs, backward.run(other).inputs);
      EXPECT_EQ(forward.run(other).seed, backward.run(other).seed);
      points.insert(forward.run(id).inputs);
      seeds.insert(forward.run(id).seed);
    }
    EXPECT_EQ(points.size(), static_cast<std::size_t>(forward.runs())) << design;
    EXPECT_EQ(seeds.size(), 50u) << design;
    const CampaignSpec reseeded =
        parse_campaign(campaign_text(plan.substr(0, plan.size() - 1) + "4", two_variables()));
    EXPECT_NE(CampaignPlan(reseeded).run(0).inputs, forward.run(0).inputs) << design;
  }
}

TEST(Plan, FirstRunsStayWhenMoreAreAdded) {
  for (const char* design : {"sobol", "monte-carlo", "saltelli"}) {
    const std::string head = std::string("design = \"") + design + "\"\nruns = ";
    const CampaignSpec few = parse_campaign(campaign_text(head + "10", two_variables()));
    const CampaignSpec many = parse_campaign(campaign_text(head + "1000", two_variables()));
    const CampaignPlan a(few), b(many);
    for (std::int64_t id = 0; id < a.runs(); ++id) EXPECT_EQ(a.run(id).inputs, b.run(id).inputs);
  }
}

TEST(Plan, GridTakesEveryCombinationTheLastVariableFastest) {
  const CampaignSpec c = parse_campaign(campaign_text(
      "design = \"grid\"",
      "[[variable]]\nset = \"net.side\"\ndistribution = \"values\"\nvalues = [1, 2.5]\n" +
          uniform_variable("mesh") + "levels = 4\n"));
  const CampaignPlan plan(c);
  ASSERT_EQ(plan.runs(), 8);
  EXPECT_THAT(plan.run(0).inputs, ElementsAre(1.0, 0.125));
  EXPECT_THAT(plan.run(3).inputs, ElementsAre(1.0, 0.875));
  EXPECT_THAT(plan.run(4).inputs, ElementsAre(2.5, 0.125));
  EXPECT_EQ(plan.run(0).overrides[0], "net.side=1");
  EXPECT_EQ(plan.run(4).overrides[0], "net.side=2.5");
}

TEST(Plan, ListTakesRowsTogether) {
  const CampaignSpec c = parse_campaign(campaign_text(
      "design = \"list\"",
      "[[variable]]\nset = \"net.side\"\ndistribution = \"values\"\nvalues = [1, 2, 3]\n"
      "[[variable]]\nset = \"net.mesh\"\ndistribution = \"values\"\nvalues = [6, 5, 4]\n"));
  const CampaignPlan plan(c);
  ASSERT_EQ(plan.runs(), 3);
  EXPECT_THAT(plan.run(1).inputs, ElementsAre(2.0, 5.0));
  EXPECT_THROW(plan.run(3), InputError);
  EXPECT_THROW(plan.run(-1), InputError);
}

TEST(Plan, LatinHypercubeHasOneInEachStratum) {
  for (const int runs : {1, 7, 100, 257}) {
    const CampaignSpec c = parse_campaign(campaign_text(
        "design = \"latin-hypercube\"\nruns = " + std::to_string(runs), two_variables()));
    const CampaignPlan plan(c);
    std::set<int> strata[2];
    for (int id = 0; id < runs; ++id) {
      const std::vector<double> shares = plan.shares(id);
      for (std::size_t d = 0; d < 2; ++d) strata[d].insert(static_cast<int>(shares[d] * runs));
    }
    EXPECT_EQ(strata[0].size(), static_cast<std::size_t>(runs));
    EXPECT_EQ(strata[1].size(), static_cast<std::size_t>(runs));
  }
}

TEST(Plan, SaltelliBlocksExchangeOneColumnAtATime) {
  const CampaignSpec c = parse_campaign(campaign_text("design = \"saltelli\"\nruns = 16",
                                                      two_variables() + uniform_variable("scale")));
  const CampaignPlan plan(c);
  ASSERT_EQ(plan.runs(), 16 * 5);
  for (std::int64_t block = 0; block < 16; ++block) {
    const std::vector<double> a = plan.run(block * 5).inputs, b = plan.run(block * 5 + 1).inputs;
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> expected = a;
      expected[i] = b[i];
      EXPECT_NE(a[i], b[i]);
      EXPECT_EQ(plan.run(block * 5 + 2 + static_cast<std::int64_t>(i)).inputs, expected);
      EXPECT_EQ(plan.run(block * 5).seed, plan.run(block * 5 + 2).seed);
    }
  }
}

// Moments of a variable over its quantiles at n equal shares, which have no error of sampling.
struct Moments {
  double mean = 0.0, deviation = 0.0, least = 1e300, largest = -1e300;
};

Moments moments(const VariableSpec& variable, int n = 100'000) {
  Moments m;
  double squares = 0.0;
  for (int i = 0; i < n; ++i) {
    const double share = (i + 0.5) / n;
    const double value = variable_inputs(variable, std::span(&share, 1))[0];
    m.mean += value / n;
    squares += value * value / n;
    m.least = std::min(m.least, value);
    m.largest = std::max(m.largest, value);
  }
  m.deviation = std::sqrt(squares - m.mean * m.mean);
  return m;
}

TEST(Variable, NormalHasItsMoments) {
  VariableSpec v;
  v.distribution = Distribution::normal;
  v.mean = 3.0;
  v.deviation = 2.0;
  EXPECT_NEAR(moments(v).mean, 3.0, 1e-9);
  EXPECT_NEAR(moments(v).deviation, 2.0, 1e-3);
}

// Mean of a normal variable cut at a and b deviations: (phi(a) - phi(b)) / (Phi(b) - Phi(a)).
TEST(Variable, TruncatedNormalHasItsMeanAndKeepsItsBounds) {
  VariableSpec v;
  v.distribution = Distribution::truncated_normal;
  v.deviation = 0.5;
  const std::pair<double, double> bounds[] = {{-1.0, 2.0}, {1.0, 3.0}, {-3.0, -2.0}, {4.0, 5.0}};
  for (const auto& [a, b] : bounds) {
    v.mean = 1.0;
    v.low = 1.0 + 0.5 * a;
    v.high = 1.0 + 0.5 * b;
    const auto density = [](double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * kPi); };
    const auto share = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
    const double inside = a > 0 ? share(-a) - share(-b) : share(b) - share(a);
    const double mean = 1.0 + 0.5 * (density(a) - density(b)) / inside;
    const Moments m = moments(v);
    EXPECT_NEAR(m.mean, mean, 1e-6) << a;
    EXPECT_GE(m.least, v.low);
    EXPECT_LE(m.largest, v.high);
  }
}

TEST(Variable, LognormalHasItsMedianAndMean) {
  VariableSpec v;
  v.distribution = Distribution::lognormal;
  v.median = 2.0;
  v.deviation = 0.4;
  const double half = 0.5;
  EXPECT_NEAR(variable_inputs(v, std::span(&half, 1))[0], 2.0, 1e-12);
  EXPECT_NEAR(moments(v).mean, 2.0 * std::exp(0.08), 1e-3);
}

std::vector<double> list_of(const std::string& text) {
  std::vector<double> list;
  for (std::size_t at = 1; at < text.size(); at = text.find_first_of(",]", at) + 1)
    list.push_back(std::stod(text.substr(at)));
  return list;
}

// Uniform over the solid angle: the mean of the direction is the axis times (1 + cos)/2, and the
// cosine of the angle is spread evenly.
TEST(Variable, ConeIsUniformOverItsSolidAngle) {
  VariableSpec v;
  v.distribution = Distribution::cone;
  v.axis = Vec3(1.0, -2.0, 2.0);
  v.half_angle_deg = 60.0;
  v.length = 3.0;
  Vec3 sum = Vec3::Zero();
  constexpr int kSide = 100;
  int first_half = 0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double shares[] = {(i + 0.5) / kSide, (j + 0.5) / kSide};
      const std::vector<double> inputs = variable_inputs(v, shares);
      const std::vector<double> list = list_of(variable_value(v, inputs));
      const Vec3 direction(list[0], list[1], list[2]);
      EXPECT_NEAR(direction.norm(), 3.0, 1e-12);
      const double cosine = direction.dot(v.axis.normalized()) / 3.0;
      EXPECT_NEAR(cosine, std::cos(inputs[0] * kPi / 180.0), 1e-12);
      if (cosine > 0.75) ++first_half;
      sum += direction;
    }
  }
  EXPECT_LT((sum / (kSide * kSide) - 3.0 * 0.75 * v.axis.normalized()).norm(), 1e-3);
  EXPECT_EQ(first_half, kSide * kSide / 2);
}

// Every rotation alike: body axes point everywhere alike (second moments 1/3), and the angle of
// rotation has the mean pi/2 + 2/pi.
TEST(Variable, UniformAttitudeMakesAllAttitudesAlike) {
  VariableSpec v;
  v.distribution = Distribution::uniform_attitude;
  constexpr int kSide = 24;
  Mat3 squares = Mat3::Zero();
  double angle = 0.0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      for (int k = 0; k < kSide; ++k) {
        const double shares[] = {(i + 0.5) / kSide, (j + 0.5) / kSide, (k + 0.5) / kSide};
        const std::vector<double> list = list_of(variable_value(v, variable_inputs(v, shares)));
        const Vec3 vector = Vec3(list[0], list[1], list[2]) * (kPi / 180.0);
        const Mat3 turn = Eigen::AngleAxisd(vector.norm(), vector.normalized()).toRotationMatrix();
        squares += turn.cwiseProduct(turn);
        angle += vector.norm();
      }
    }
  }
  constexpr double kCount = 1.0 * kSide * kSide * kSide;
  EXPECT_LT((squares / kCount - Mat3::Constant(1.0 / 3.0)).cwiseAbs().maxCoeff(), 2e-3);
  EXPECT_NEAR(angle / kCount, kPi / 2.0 + 2.0 / kPi, 2e-3);
}

// The correlation of the normal scores is the one asked for; each variable keeps its distribution.
TEST(Plan, GroupsAreCorrelated) {
  const CampaignSpec c = parse_campaign(campaign_text(
      "design = \"sobol\"\nruns = 4096",
      "[[variable]]\nset = \"net.side\"\ndistribution = \"normal\"\nmean = 5\ndeviation = 2\n"
      "[[variable]]\nset = \"net.mesh\"\ndistribution = \"normal\"\nmean = 1\ndeviation = 1\n" +
          uniform_variable("scale") +
          "[[group]]\nvariables = [\"side\", \"mesh\"]\ncorrelation = [1, -0.6, -0.6, 1]\n"));
  const CampaignPlan plan(c);
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0, ac = 0;
  const auto n = static_cast<double>(plan.runs());
  for (std::int64_t id = 0; id < plan.runs(); ++id) {
    const std::vector<double> x = plan.run(id).inputs;
    const double u = (x[0] - 5.0) / 2.0, w = x[1] - 1.0;
    a += u / n;
    b += w / n;
    aa += u * u / n;
    bb += w * w / n;
    ab += u * w / n;
    ac += u * (x[2] - 0.5) / n;
  }
  EXPECT_NEAR(a, 0.0, 5e-3);
  EXPECT_NEAR(b, 0.0, 5e-3);
  EXPECT_NEAR(aa, 1.0, 0.01);
  EXPECT_NEAR(bb, 1.0, 0.01);
  EXPECT_NEAR(ab, -0.6, 0.01);
  EXPECT_NEAR(ac, 0.0, 0.01);
}

TEST(Plan, NumbersReachTheMissionInFullPrecision) {
  const CampaignSpec c = parse_campaign(
      campaign_text("design = \"monte-carlo\"\nruns = 20", uniform_variable("side")));
  const CampaignPlan plan(c);
  for (std::int64_t id = 0; id < 20; ++id) {
    const PlannedRun run = plan.run(id);
    EXPECT_EQ(std::stod(run.overrides[0].substr(9)), run.inputs[0]);
    EXPECT_EQ(run.overrides.back(), "seed=" + std::to_string(run.seed));
    EXPECT_GE(run.seed, 0);
  }
}

}  // namespace
}  // namespace retiarius
