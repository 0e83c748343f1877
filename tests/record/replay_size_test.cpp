// How large recordings are: 10,000 nodes and 1,000 frames shall make a page below 60 MB, 1,000
// nodes and 600 frames one below 8 MB.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "retiarius/record/replay_codec.hpp"
#include "retiarius/record/replay_header.hpp"

namespace retiarius {
namespace {

constexpr double kSize = 20.0;        // m, of the net
constexpr double kStiffness = 5.5e4;  // N
constexpr double kPage = 0.9e6;       // bytes of the viewer, tables and history

ReplayScales scales() {
  return {2.0 * kReplayError * kSize,
          {1e-7 * kStiffness, 128},
          {1e-7, 64},
          {1e-3 / kSize, 32},
          {1e-5 * kSize, 64}};
}

// A square net with two segments a piece that flies and waves, in which from frame to frame every
// node jumps by a normal deviate of a twenty-thousandth of the net's size along each axis, and
// speeds, curvatures and slack threads' strains vary accordingly; every tension is drawn anew
// around its mean by a third of it, and a third of the threads, drawn anew, is slack. That is far
// worse than what threads do, whose neighbours move alike.
class NoisyNet {
 public:
  explicit NoisyNet(std::size_t knots) : knots_(knots) {
    for (std::size_t j = 0; j < knots; ++j)
      for (std::size_t i = 0; i < knots; ++i)
        at_.emplace_back(mesh() * static_cast<double>(i), mesh() * static_cast<double>(j));
    for (std::size_t k = 0; k < knots * knots; ++k) {
      if (k % knots + 1 < knots) add_piece(k, k + 1);
      if (k + knots < knots * knots) add_piece(k, k + knots);
    }
  }

  ReplayShape shape() const {
    return {at_.size(), 0, std::vector<double>(ends_.size(), kStiffness), ends_,
            std::vector<double>(ends_.size(), rest_length())};
  }

  ReplayFrame frame(int number) {
    ReplayFrame f;
    f.time = 0.02 * number;
    for (const Eigen::Vector2d& p : at_) {
      const double wave =
          5.0 * f.time + std::sin(0.5 * p.x() + 3.0 * f.time) * std::cos(0.3 * p.y());
      f.x.push_back(Vec3(p.x(), p.y(), wave) + 5e-5 * kSize * Vec3(normal(), normal(), normal()));
      f.speed.push_back(6.0 * (1.0 + 0.015 * normal()));
      f.curvature.push_back(2.0 * std::exp(0.025 * normal()));
      f.touch.push_back(0);
    }
    for (const auto& [a, b] : ends_) {
      const bool slack = normal() < -0.43;
      f.tension.push_back(slack ? 0.0 : 20.0 * std::exp(0.33 * normal()));
      const Vec3 line = f.x[static_cast<std::size_t>(b)] - f.x[static_cast<std::size_t>(a)];
      f.strain.push_back(slack ? line.norm() / (rest_length()) - 1.0
                               : f.tension.back() / kStiffness);
    }
    return f;
  }

 private:
  double mesh() const { return kSize / static_cast<double>(knots_ - 1); }
  double rest_length() const { return 0.51 * mesh(); }
  double normal() { return distribution_(generator_); }
  void add_piece(std::size_t a, std::size_t b) {
    const auto middle = static_cast<Index>(at_.size());
    at_.push_back(0.5 * (at_[a] + at_[b]));
    ends_.push_back({static_cast<Index>(a), middle});
    ends_.push_back({middle, static_cast<Index>(b)});
  }

  std::size_t knots_;
  std::vector<Eigen::Vector2d> at_;  // of each node in the flat net
  std::vector<std::array<Index, 2>> ends_;
  std::mt19937 generator_{7};
  std::normal_distribution<double> distribution_;
};

double page_size(std::size_t knots, int frames) {
  NoisyNet net(knots);
  ReplayCodec codec(net.shape(), scales());
  constexpr int kSample = 68;  // a whole key interval and a little
  double bytes = 0.0;
  for (int k = 0; k < kSample; ++k) bytes += static_cast<double>(codec.encode(net.frame(k)).size());
  return kPage + 4.0 / 3.0 * bytes / kSample * frames;
}

TEST(ReplaySize, OfALargeNoisyNetIsBelowSixtyMegabytes) {
  const double bytes = page_size(58, 1000);  // 9,976 nodes, 13,224 segments
  RecordProperty("bytes", static_cast<int>(bytes));
  EXPECT_LT(bytes, 60e6);
}

TEST(ReplaySize, OfASmallNoisyNetIsBelowEightMegabytes) {
  const double bytes = page_size(19, 600);  // 1,045 nodes, 1,368 segments
  RecordProperty("bytes", static_cast<int>(bytes));
  EXPECT_LT(bytes, 8e6);
}

}  // namespace
}  // namespace retiarius
