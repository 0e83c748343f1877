#include "retiarius/render/painter.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "retiarius/record/run_h5.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius::render {
namespace {

using testing::SampleRun;
using testing::TemporaryFolder;

constexpr Area kArea{0.0, 0.0, 800.0, 600.0};

// The sample's net, laid as a vertical sheet at a chosen place before or behind its box.
class Painter : public ::testing::Test {
 protected:
  Painter() {
    RunH5 recorder(folder_.path(), "", "0.1.0");
    sample_.feed(recorder, 1);
    recorder.end(sample_.report());
    run_ = std::make_unique<DrawnRun>(folder_.path());
    frame_ = run_->file.frame(0);
    frame_.bodies[0].position = Vec3::Zero();
    frame_.bodies[0].attitude = Quat::Identity();
    run_->balls.clear();
  }

  void lay_sheet(double y) {
    for (std::size_t k = 0; k < frame_.x.size(); ++k)
      frame_.x[k] = Vec3(sample_.network.design[k].x(), y, sample_.network.design[k].y());
  }

  Camera front() const {
    return {View::front, {Vec3(-1.5, -1.5, -1.5), Vec3(1.5, 1.5, 1.5)}, kArea};
  }

  // Pieces, with the bodies' surface drawn into the map.
  std::vector<ThreadPiece> pieces() const {
    DepthMap depths(kArea);
    surface_pieces(*run_, frame_, front(), true, depths);
    return thread_pieces(*run_, frame_, front(), depths, {});
  }

  static double length(const ThreadPiece& p) {
    return std::hypot(p.to.x - p.from.x, p.to.y - p.from.y);
  }

  SampleRun sample_;
  TemporaryFolder folder_;
  std::unique_ptr<DrawnRun> run_;
  FrameData frame_;
};

TEST_F(Painter, ThreadsInFrontOfABodyAreNotHidden) {
  lay_sheet(-0.6);
  for (const ThreadPiece& piece : pieces()) EXPECT_FALSE(piece.hidden);
}

// The box shows 1 m by 0.4 m: of a thread through its middle behind it, what its outline covers.
TEST_F(Painter, ThreadsBehindABodyAreHiddenExactlyUpToItsOutline) {
  lay_sheet(0.6);
  const Camera camera = front();
  const double left = camera.place(Vec3(-0.5, -0.3, 0)).x;
  const double right = camera.place(Vec3(0.5, -0.3, 0)).x;
  const double middle = camera.place(Vec3(0, 0.6, 0)).y;
  double hidden = 0.0, shown = 0.0;
  for (const ThreadPiece& piece : pieces()) {
    if (std::abs(piece.from.y - middle) > 0.5 || std::abs(piece.to.y - middle) > 0.5) continue;
    (piece.hidden ? hidden : shown) += length(piece);
  }
  EXPECT_NEAR(hidden, right - left, 8.0);
  EXPECT_GT(shown, 50.0);
}

TEST_F(Painter, HiddenPiecesComeFirstThenFarBeforeNear) {
  lay_sheet(0.6);
  const auto list = pieces();
  for (std::size_t k = 1; k < list.size(); ++k) {
    EXPECT_GE(list[k - 1].hidden, list[k].hidden);
    if (list[k - 1].hidden != list[k].hidden) continue;
    EXPECT_GE(list[k - 1].depth, list[k].depth);
  }
}

TEST_F(Painter, CuttingAThreadKeepsItsLength) {
  lay_sheet(0.6);
  double cut = 0.0, whole = 0.0;
  for (const ThreadPiece& piece : pieces()) cut += length(piece);
  for (const auto& [a, b] : run_->net.segments) {
    const Place p = front().place(frame_.x[static_cast<std::size_t>(a)]);
    const Place q = front().place(frame_.x[static_cast<std::size_t>(b)]);
    whole += std::hypot(p.x - q.x, p.y - q.y);
  }
  EXPECT_NEAR(cut, whole, 1e-6 * whole);
}

TEST_F(Painter, ShowsTheSidesOfABodyThatFaceTheCamera) {
  DepthMap depths(kArea);
  double area = 0.0;
  const Camera camera = front();
  for (const SurfacePiece& piece : surface_pieces(*run_, frame_, camera, true, depths)) {
    if (piece.count != 3) continue;
    const auto& [a, b, c] = piece.corner;
    area += 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  }
  const double scale = camera.place(Vec3(0, -0.3, 0)).scale;
  EXPECT_NEAR(area, 1.0 * 0.4 * scale * scale, 1e-3 * area);  // its front and nothing else
  EXPECT_TRUE(surface_pieces(*run_, frame_, camera, false, depths).empty());
}

TEST_F(Painter, ABallHidesOrShowsAsAWhole) {
  lay_sheet(0.6);
  run_->balls = {{run_->file.corners()[0], 0.05}, {12, 0.05}};  // a corner, and the middle
  int balls = 0, hidden = 0;
  for (const ThreadPiece& piece : pieces()) {
    if (!piece.ball) continue;
    ++balls;
    hidden += piece.hidden ? 1 : 0;
  }
  EXPECT_EQ(balls, 2);
  EXPECT_EQ(hidden, 1);
}

}  // namespace
}  // namespace retiarius::render
