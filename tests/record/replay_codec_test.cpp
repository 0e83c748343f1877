#include "retiarius/record/replay_codec.hpp"

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::error_text;
using ::testing::HasSubstr;

constexpr std::size_t kNodes = 40, kSegments = 60;
constexpr double kStiffness = 5e4;

ReplayShape shape() {
  ReplayShape shape{kNodes, 1, std::vector<double>(kSegments, kStiffness), {}, {}};
  for (std::size_t k = 0; k < kSegments; ++k) {
    const auto a = static_cast<Index>(k % kNodes);
    shape.ends.push_back({a, (a + 1) % static_cast<Index>(kNodes)});
    shape.rest_length.push_back(0.3);
  }
  return shape;
}

ReplayScales scales() {
  return {1e-4, {1e-7 * kStiffness, 128}, {1e-7, 128}, {1e-3, 64}, {1e-4, 64}};
}

// A waving sheet with some threads slack, some taut, and a jump in the middle.
ReplayFrame frame(int number) {
  ReplayFrame f;
  f.time = 0.05 * number;
  f.phase = number / 50;
  for (std::size_t k = 0; k < kNodes; ++k) {
    const double s = 0.3 * static_cast<double>(k);
    const double jump = number > 30 ? 100.0 : 0.0;
    f.x.emplace_back(std::sin(s + 3.0 * f.time), s - 2.0 * f.time, jump + 0.5 * f.time * f.time);
    f.curvature.push_back(1.0 + std::sin(s) * std::cos(f.time));
    f.speed.push_back(std::hypot(3.0 * std::cos(s + 3.0 * f.time), 2.0, f.time));
    f.touch.push_back(static_cast<std::uint8_t>((k + static_cast<std::size_t>(number) / 7) % 3));
  }
  for (std::size_t k = 0; k < kSegments; ++k) {
    const double strain = 1e-3 * std::sin(0.7 * static_cast<double>(k) + 5.0 * f.time);
    f.strain.push_back(strain < 0.0 ? 100.0 * strain : strain);
    f.tension.push_back(std::max(0.0, kStiffness * strain * 1.02));
  }
  BodyState body;
  body.position = Vec3(1.0, f.time, -3.0);
  body.attitude = Quat(Eigen::AngleAxisd(f.time, Vec3(1, 2, 3).normalized()));
  f.bodies.push_back(body);
  return f;
}

void expect_near(const Minifloat& scale, const std::vector<double>& read,
                 const std::vector<double>& written) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t k = 0; k < read.size(); ++k)
    EXPECT_LE(std::abs(read[k] - written[k]),
              std::max(0.5 * scale.quantum, std::abs(written[k]) / (2 * scale.steps)) * 1.000001);
}

void expect_near(const ReplayFrame& read, const ReplayFrame& written) {
  const ReplayScales s = scales();
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.phase, written.phase);
  EXPECT_EQ(read.touch, written.touch);
  for (std::size_t k = 0; k < kNodes; ++k)
    EXPECT_LE((read.x[k] - written.x[k]).cwiseAbs().maxCoeff(), 0.5 * s.quantum * 1.000001);
  expect_near(s.tension, read.tension, written.tension);
  expect_near(s.strain, read.strain, written.strain);
  expect_near(s.curvature, read.curvature, written.curvature);
  expect_near(s.speed, read.speed, written.speed);
  EXPECT_LT((read.bodies[0].position - written.bodies[0].position).norm(), 1e-6);
  EXPECT_LT(read.bodies[0].attitude.angularDistance(written.bodies[0].attitude), 1e-6);
}

TEST(ReplayCodec, KeepsEveryFrameWithinTheStatedErrors) {
  ReplayCodec writer(shape(), scales()), reader(shape(), scales());
  for (int k = 0; k < 150; ++k) expect_near(reader.decode(writer.encode(frame(k))), frame(k));
}

TEST(ReplayCodec, StartsAgainAtEveryKeyFrame) {
  ReplayCodec writer(shape(), scales());
  std::vector<std::string> file;
  file.reserve(140);
  for (int k = 0; k < 140; ++k) file.push_back(writer.encode(frame(k)));
  ReplayCodec reader(shape(), scales());
  for (int k = 128; k < 140; ++k)
    expect_near(reader.decode(file[static_cast<std::size_t>(k)]), frame(k));
  expect_near(reader.decode(file[64]), frame(64));
  EXPECT_THAT(error_text<InputError>([&] { reader.decode(file[66]); }),
              HasSubstr("frame 66 does not follow frame 65"));
  ReplayCodec fresh(shape(), scales());
  EXPECT_THROW(fresh.decode(file[1]), InputError);
}

TEST(ReplayCodec, NeedsFewBytesForWhatMovesSmoothly) {
  ReplayCodec writer(shape(), scales());
  std::size_t steady = 0;
  ReplayFrame f = frame(0);
  for (int k = 0; k < 20; ++k) {
    f.time += 0.1;
    for (Vec3& x : f.x) x += Vec3(0.37, 0.0, 0.01);
    const std::size_t bytes = writer.encode(f).size();
    if (k >= 3) steady = std::max(steady, bytes);
  }
  EXPECT_LT(steady, 20 + 28 + 150u);  // 40 nodes and 60 segments
}

TEST(ReplayCodec, RefusesWhatItCannotKeep) {
  ReplayCodec writer(shape(), scales());
  ReplayFrame far = frame(0);
  far.x[7].y() = 3e5;
  EXPECT_THAT(error_text<RunError>([&] { writer.encode(far); }),
              HasSubstr("node 7 is at 300000 m, which a recording of steps of 0.0001 m"));
  ReplayFrame broken = frame(0);
  broken.tension[3] = kInfinity;
  EXPECT_THAT(error_text<RunError>([&] { writer.encode(broken); }),
              HasSubstr("the tension of number 3 is inf"));
  ReplayFrame shorter = frame(0);
  shorter.strain.pop_back();
  EXPECT_THROW(writer.encode(shorter), Error);
}

TEST(Minifloat, HoldsAnyNumberAndReadsAnyCode) {
  const Minifloat coarse{1.0, 1}, fine{1e-5, 1 << 20};
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(fine.code(kInfinity), kMost);
  EXPECT_EQ(fine.code(-kInfinity), -kMost);
  EXPECT_EQ(fine.code(1e308), kMost);
  EXPECT_EQ(coarse.code(std::nan("")), kMost);
  EXPECT_EQ(coarse.code(4.0), 3);
  EXPECT_EQ(coarse.value(3), 4.0);
  EXPECT_EQ(coarse.value(std::numeric_limits<std::int32_t>::min()), -kInfinity);
}

TEST(ReplayCodec, TakesNoMemoryForNodesThatAFrameDoesNotHave) {
  ReplayCodec writer(shape(), scales());
  const std::string content = writer.encode(frame(0));
  ReplayShape huge = shape();
  huge.nodes = std::size_t{1} << 60;
  ReplayCodec reader(huge, scales());
  EXPECT_THAT(error_text<InputError>([&] { reader.decode(content); }),
              HasSubstr("a frame is too short"));
}

TEST(ReplayCodec, NamesDamage) {
  ReplayCodec writer(shape(), scales());
  const std::string content = writer.encode(frame(0));
  for (std::size_t size : {std::size_t{0}, std::size_t{19}, std::size_t{40}, content.size() - 5}) {
    ReplayCodec reader(shape(), scales());
    EXPECT_THROW(reader.decode(std::string_view(content).substr(0, size)), InputError) << size;
  }
}

}  // namespace
}  // namespace retiarius
