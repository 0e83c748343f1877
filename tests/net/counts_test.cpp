#include "nets.hpp"

namespace retiarius {
namespace {

using namespace test;

void expect_counts_of_build(const NetSpec& spec) {
  const NetworkCounts counts = count_network(spec);
  const Network net = build_network(spec);
  EXPECT_EQ(counts.nodes, double(net.design.size()));
  EXPECT_EQ(counts.segments, double(net.segments.size()));
  EXPECT_EQ(counts.joints, double(net.joints.size()));
  EXPECT_EQ(counts.knots, double(net.knots.size()));
}

// The published counts of the hexagon: n pieces a side, s inner nodes a piece.
TEST(Counts, HexagonMeetsFormulasAndTable) {
  struct Row {
    double side;
    int n, s;
    double nodes, segments, joints, length;
  };
  for (const Row& row : {Row{1, 5, 3, 631, 720, 663, 36}, Row{8, 32, 2, 15841, 19008, 18627, 1584},
                         Row{20, 21, 2, 6931, 8316, 8067, 2640}}) {
    const Network net =
        build_network(net_of(Pattern::hexagon, row.side, row.side / row.n, row.s + 1));
    EXPECT_EQ(net.node_count(), row.nodes);
    EXPECT_EQ(net.segment_count(), row.segments);
    EXPECT_EQ(net.joints.size(), row.joints);
    const int n = row.n, s = row.s, pieces = 6 * n * n + 6 * n;
    EXPECT_EQ(net.knots.size(), std::size_t(1 + 3 * n * (n + 1)));
    EXPECT_EQ(net.node_count(), 1 + 3 * n * (n + 1) + s * pieces);
    EXPECT_EQ(net.segment_count(), (s + 1) * pieces);
    EXPECT_EQ(net.joints.size(),
              std::size_t(s * pieces + 3 + 12 * (n - 1) + 6 * (n - 1) * (n - 2)));
    double length = 0.0;
    for (const Segment& segment : net.segments) length += segment.rest_length;
    EXPECT_NEAR(length, row.length, 1e-9 * row.length);
  }
}

TEST(Counts, SquareOfTheStiffCapture) {
  const NetworkCounts counts = count_network(net_of(Pattern::square, 5.0, 0.2, 2));
  EXPECT_EQ(counts.nodes, 1976);
  EXPECT_EQ(counts.segments, 2600);
  EXPECT_EQ(counts.knots, 26 * 26);
}

TEST(Counts, EqualBuildsOfAllPatterns) {
  for (const double mesh : {1.0, 0.5, 0.2, 0.125}) {
    for (const int segments : {1, 3}) {
      for (auto& [name, spec] : all_patterns(1.0, mesh, segments)) {
        SCOPED_TRACE(name + " with mesh " + std::to_string(mesh));
        expect_counts_of_build(spec);
        spec.knots = Knots::hinged;
        spec.corner_mass.bridle = 0.5;
        spec.corner_mass.bridle_segments = 3;
        expect_counts_of_build(spec);
      }
    }
  }
}

TEST(Counts, EqualBuildOfFile) {
  expect_counts_of_build(file_of(data_file("kite.net")));
  expect_counts_of_build(file_of(data_file("kite.net"), 3));
  NetSpec hinged = file_of(data_file("kite.net"), 2);
  hinged.knots = Knots::hinged;
  expect_counts_of_build(hinged);
}

TEST(Counts, HugeNetsAreCountedButNotBuilt) {
  const NetSpec spec = net_of(Pattern::square, 1e5, 1.0);
  EXPECT_EQ(count_network(spec).nodes, 100001.0 * 100001.0);
  EXPECT_EQ(error_of<InputError>([&] { build_network(spec); }),
            "net.mesh = 1 with net.segments = 1: gives 1e+10 nodes and 2e+10 segments, more than "
            "the 2147483647 that can be numbered; choose a coarser mesh or fewer segments");
}

TEST(Counts, FilesCutTooFineAreRefused) {
  EXPECT_EQ(error_of<InputError>([] { build_network(file_of(data_file("kite.net"), 300000000)); }),
            "net.segments = 300000000: gives 2.7e+09 nodes and 2.7e+09 segments, more than the "
            "2147483647 that can be numbered; choose a coarser mesh or fewer segments");
}

TEST(Counts, MillionNodesBuildAndValidate) {
  const Network net = build_network(net_of(Pattern::square, 999.0, 1.0));
  EXPECT_EQ(net.node_count(), 1000000);
  EXPECT_NO_THROW(validate(net));
}

}  // namespace
}  // namespace retiarius
