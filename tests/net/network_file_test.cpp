#include "retiarius/net/network_file.hpp"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "nets.hpp"

namespace retiarius {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class NetworkFile : public ::testing::Test {
 protected:
  NetworkFile() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = ::testing::TempDir() + "retiarius_" + test->name() + ".net";
  }
  ~NetworkFile() override { std::filesystem::remove(path_); }

  std::string write(const std::string& text) const {
    std::ofstream(path_, std::ios::binary) << text;
    return path_;
  }

  // The error of a file with this text, without the path in front of line and column.
  std::string refusal(const std::string& text) const {
    write(text);
    const std::string message = error_of<InputError>([&] { read_network_file(path_); });
    return message.starts_with(path_ + ":") ? message.substr(path_.size() + 1) : message;
  }

  std::string path_;
};

TEST_F(NetworkFile, Example) {
  const Network net = build_network(file_of(data_file("kite.net")));
  EXPECT_NO_THROW(validate(net));
  EXPECT_EQ(net.node_count(), 6);
  EXPECT_EQ(net.segment_count(), 9);
  EXPECT_EQ(net.threads.size(), 6u);
  EXPECT_THAT(net.threads[0].nodes, ElementsAre(0, 5, 4, 2));
  EXPECT_FALSE(net.threads[0].perimeter);
  EXPECT_TRUE(net.threads[2].perimeter);
  EXPECT_THAT(net.knots, ElementsAre(0, 1, 2, 3, 4)) << "node 5 is inside one thread";
  EXPECT_THAT(net.corners, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(net.perimeter, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(net.center, 4);
  EXPECT_EQ(net.joints.size(), 3u);
  EXPECT_EQ(net.segments[4].rest_length, 1.9);
  const double line = net.materials[0].line_density;
  EXPECT_NEAR(net.mass[4], 0.25 + line * (1.0 + 0.5 + 1.0 + 1.9) / 2.0, 1e-14);
}

TEST_F(NetworkFile, PiecesAreDividedAndHingesKeepJointsOutsideKnots) {
  NetSpec spec = file_of(data_file("kite.net"), 3);
  spec.knots = Knots::hinged;
  spec.border.radius = 0.02;
  const Network net = build_network(spec);
  EXPECT_EQ(net.node_count(), 6 + 9 * 2);
  EXPECT_EQ(net.joints.size(), 9u * 2u + 1u) << "node 5 keeps its joint";
  EXPECT_DOUBLE_EQ(net.segments[3 * 4].rest_length, 1.9 / 3.0);
  EXPECT_EQ(net.perimeter.size(), 12u);
  EXPECT_EQ(net.segments.back().material, 1);
  EXPECT_EQ(net.segments.front().material, 0);
}

// A built net written to a file and read again is the same net, also where the file's digits bend
// straight sides a little (which may decide between centres that are equally near).
TEST_F(NetworkFile, RoundTripOfAPattern) {
  for (const auto& [name, spec] : all_patterns(1.0, 0.25, 1)) {
    if (name == "polygon 101") continue;
    for (const int digits : {6, 17}) {
      SCOPED_TRACE(name);
      const Network net = build_network(spec);
      std::string text;
      for (const Vec3& x : net.design) {
        text += fmt::format("node {1:.{0}f} {2:.{0}f} {3}\n", digits, x.x(), x.y(), x.z());
      }
      for (const Segment& s : net.segments) text += fmt::format("segment {} {}\n", s.a, s.b);
      for (const Thread& t : net.threads) {
        text += fmt::format("thread {}\n", fmt::join(t.nodes, " "));
      }
      const Network copy = build_network(file_of(write(text)));
      EXPECT_EQ(copy.corners, net.corners);
      EXPECT_EQ(copy.perimeter, net.perimeter);
      EXPECT_EQ(copy.knots, net.knots);
      EXPECT_EQ(copy.joints.size(), net.joints.size());
      if (digits == 17) {
        EXPECT_EQ(copy.center, net.center);
      }
    }
  }
}

TEST_F(NetworkFile, ClosedThreadBendsThroughItsStart) {
  const Network net = build_network(
      file_of(write("node 0 -1 0\nnode 1 -1 0\nnode 1 1 0\nnode -1 1 0\nnode -1 -1 0\n"
                    "segment 0 1\nsegment 1 2\nsegment 2 3\nsegment 3 4\nsegment 4 0\n"
                    "thread 0 1 2 3 4 0\n")));
  ASSERT_EQ(net.joints.size(), 1u);
  EXPECT_EQ(net.joints[0].a, 4);
  EXPECT_EQ(net.joints[0].b, 0);
  EXPECT_EQ(net.joints[0].c, 1);
  EXPECT_THAT(net.knots, IsEmpty());
  EXPECT_THAT(net.corners, ElementsAre(2, 3, 4, 1));
  EXPECT_THAT(net.perimeter, ElementsAre(2, 3, 4, 0, 1));
  EXPECT_NO_THROW(validate(net));
}

TEST_F(NetworkFile, ASingleLineHasNoMouth) {
  const std::string line = "node 0 0 0\nnode 1 0 0\nnode 2 0 0\nsegment 0 1\nsegment 1 2\n";
  const Network net = build_network(file_of(write(line + "thread 0 1 2\n")));
  EXPECT_EQ(net.joints.size(), 1u);
  EXPECT_THAT(net.corners, IsEmpty());
  EXPECT_THAT(net.perimeter, IsEmpty());
  NetSpec loaded = file_of(path_);
  loaded.corner_mass.mass = 2.0;
  EXPECT_EQ(error_of<InputError>([&] { build_network(loaded); }),
            "net.corner_mass.mass = 2: the net has no corners; name them in its file with "
            "`corner N`");
  write(line + "corner 2\n");
  EXPECT_GT(build_network(loaded).mass[2], 2.0);
  write(line + "corner 0\n");
  loaded.corner_mass.bridle = 0.5;
  EXPECT_EQ(error_of<InputError>([&] { build_network(loaded); }),
            "net.corner_mass.bridle = 0.5: corner node 0 lies in the net's centre");
}

TEST_F(NetworkFile, WithoutThreadsThereAreNoJoints) {
  const Network net = build_network(file_of(
      write("segment 0 1\r\nsegment 1 2\r\n\tnode 0 0 0\r\nnode 1 0 0\r\nnode 2 0 0 # end")));
  EXPECT_THAT(net.joints, IsEmpty());
  EXPECT_EQ(net.threads.size(), 2u);
}

TEST_F(NetworkFile, WrongWords) {
  EXPECT_EQ(refusal("node 0 0 0\n  knoten 1 2 3\n"),
            "2:3: unknown statement \"knoten\"; allowed: node, segment, thread, corner");
  EXPECT_EQ(refusal("node 0 1,5 0\n"), "1:8: \"1,5\" is not a number");
  EXPECT_EQ(refusal("node 0 nan 0\n"), "1:8: \"nan\" is not a number");
  EXPECT_EQ(refusal("node 0 0\n"), "1:1: expected: node X Y Z [MASS]");
  EXPECT_EQ(refusal("node 0 0 0 1 2\n"), "1:14: too many words; expected: node X Y Z [MASS]");
  EXPECT_EQ(refusal("node 0 0 0 -1\n"), "1:12: mass -1 must be at least 0 (kg)");
  EXPECT_EQ(refusal("corner\n"), "1:1: expected: corner N");
  EXPECT_EQ(refusal("thread 1\n"), "1:1: expected: thread N0 N1 N2 ...");
  EXPECT_EQ(refusal("segment 1 2 0.5 red\n"),
            "1:17: too many words; expected: segment A B [REST_LENGTH] [border]");
  EXPECT_EQ(refusal("segment 1 2 0\n"), "1:13: rest length 0 must be greater than 0 (m)");
  EXPECT_THAT(refusal(std::string("\x7f"
                                  "ELF\0\1\2\n",
                                  8)),
              HasSubstr("1:1: unknown statement \"?ELF???\""));
}

TEST_F(NetworkFile, WrongNumbers) {
  const std::string two = "node 0 0 0\nnode 1 0 0\n";
  EXPECT_EQ(refusal(two + "segment 0 2\n"), "3:11: \"2\" is not a node; the file has nodes 0 to 1");
  EXPECT_EQ(refusal(two + "segment -1 0\n"),
            "3:9: \"-1\" is not a node; the file has nodes 0 to 1");
  EXPECT_EQ(refusal(two + "segment 1 1\n"), "3:11: segment joins node 1 to itself");
  EXPECT_EQ(refusal(two + "node 1 0 0\nsegment 1 2\n"),
            "4:9: segment 1 2 has both nodes at one place");
  EXPECT_EQ(refusal(two + "segment 0 1\nsegment 1 0\n"), "4:9: segment 1 0 appears twice");
  const std::string line = two + "node 2 0 0\nsegment 0 1\nsegment 1 2\n";
  EXPECT_EQ(refusal(line + "thread 0 2\n"), "6:10: no segment joins 0 and 2");
  EXPECT_EQ(refusal(line + "thread 0 1\nthread 2 1 0\n"),
            "7:12: segment 1 0 already belongs to a thread");
  EXPECT_EQ(refusal(line + "corner 7\n"), "6:8: \"7\" is not a node; the file has nodes 0 to 2");
  EXPECT_EQ(refusal(line + "corner 1\ncorner 1\n"), "7:8: corner 1 appears twice");
  EXPECT_EQ(refusal(line + "node 0 1 0\ncorner 0\ncorner 3\ncorner 1\nsegment 0 3\n"),
            "7:8: corners must run counter-clockwise seen from +z");
  EXPECT_EQ(refusal(line + "node 5 5 5\n"), " node 3 has neither a segment nor a mass");
}

TEST_F(NetworkFile, FilesThatAreNone) {
  EXPECT_EQ(error_of<InputError>([] { read_network_file("/no/such.net"); }),
            "net.file = \"/no/such.net\": cannot be read (No such file or directory)");
  EXPECT_EQ(error_of<InputError>([] { read_network_file("/"); }),
            "net.file = \"/\": is a directory, not a network file");
  EXPECT_EQ(refusal(""), "net.file = \"" + path_ + "\": holds no segment");
  EXPECT_EQ(refusal("# nothing\nnode 0 0 0\n"), "net.file = \"" + path_ + "\": holds no segment");
}

TEST_F(NetworkFile, TextReadsAsItsFile) {
  const std::string text = "node 0 0 0\nnode 1 0 0\nsegment 0 1 0.5\ncorner 0\n";
  const Layout from_file = read_network_file(write(text));
  const Layout from_text = parse_network(text, "n.net");
  ASSERT_EQ(from_text.pieces.size(), 1u);
  EXPECT_EQ(from_text.pieces[0].rest_length, 0.5);
  EXPECT_EQ(from_text.nodes, from_file.nodes);
  EXPECT_EQ(error_of<InputError>([] { parse_network("node 0 0 x", "n.net"); }),
            "n.net:1:10: \"x\" is not a number");
}

}  // namespace
}  // namespace retiarius
