#include <cstring>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "retiarius/base/error.hpp"
#include "retiarius/record/export_run.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/run_h5.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using Json = nlohmann::json;
using testing::SampleRun;
using testing::TemporaryFolder;

std::uint32_t number_at(const std::string& bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

class Glb : public ::testing::Test {
 protected:
  // Six frames, at 0, 0.2 ... 1 s, with heavy corners.
  GlbReport write(std::size_t most_bytes = 0) {
    for (Index corner : sample_.network.corners)
      sample_.network.mass[static_cast<std::size_t>(corner)] = 0.3;
    RunH5 recorder(folder_.path(), "", "0.1.0");
    sample_.feed(recorder, 11);
    recorder.end(sample_.report());
    const GlbReport report = export_glb(folder_.path(), folder_ / "run.glb", most_bytes);
    bytes_ = read_whole_file(folder_ / "run.glb");
    const std::uint32_t length = number_at(bytes_, 12);
    json_ = Json::parse(bytes_.substr(20, length));
    data_ = bytes_.substr(28 + length);
    return report;
  }

  std::vector<float> floats(const Json& accessor_number) const {
    const Json& accessor = json_["accessors"][accessor_number.get<std::size_t>()];
    EXPECT_EQ(accessor["componentType"], 5126);
    const Json& view = json_["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::vector<float> numbers(view["byteLength"].get<std::size_t>() / 4);
    std::memcpy(numbers.data(), data_.data() + view["byteOffset"].get<std::size_t>(),
                4 * numbers.size());
    return numbers;
  }

  // The animation of a node's "translation" or "rotation".
  std::vector<float> motion(int node, const std::string& path) const {
    for (const Json& channel : json_["animations"][0]["channels"])
      if (channel["target"]["node"] == node && channel["target"]["path"] == path)
        return floats(
            json_["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()]["output"]);
    return {};
  }

  SampleRun sample_;
  TemporaryFolder folder_;
  std::string bytes_, data_;
  Json json_;
};

TEST_F(Glb, IsOneFileWithTwoChunks) {
  write();
  EXPECT_EQ(bytes_.substr(0, 4), "glTF");
  EXPECT_EQ(number_at(bytes_, 4), 2u);
  EXPECT_EQ(number_at(bytes_, 8), bytes_.size());
  EXPECT_EQ(bytes_.substr(16, 4), "JSON");
  EXPECT_EQ(json_["asset"]["version"], "2.0");
  EXPECT_EQ(json_["buffers"][0]["byteLength"], data_.size());
  EXPECT_EQ(data_.size() % 4, 0u);
}

TEST_F(Glb, JointsMoveAsTheNodesDid) {
  const GlbReport report = write();
  EXPECT_EQ(report.written, 6u);
  EXPECT_EQ(report.recorded, 6u);
  const Json& joints = json_["skins"][0]["joints"];
  ASSERT_EQ(joints.size(), sample_.network.design.size());
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const std::vector<float> moved = motion(joints[k].get<int>(), "translation");
    ASSERT_EQ(moved.size(), 18u);
    for (std::size_t f = 0; f < 6; ++f) {
      const Vec3 x = sample_.state(0.2 * static_cast<double>(f)).x[k];
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(moved[3 * f + static_cast<std::size_t>(c)], x[c], 1e-6);
    }
  }
}

TEST_F(Glb, BodiesMoveAndTurn) {
  write();
  int node = -1;
  for (std::size_t k = 0; k < json_["nodes"].size(); ++k)
    if (json_["nodes"][k].value("name", "") == "target") node = static_cast<int>(k);
  const std::vector<float> turns = motion(node, "rotation"), places = motion(node, "translation");
  ASSERT_EQ(turns.size(), 24u);
  const Quat q = sample_.state(1.0).bodies[0].attitude;
  for (int c = 0; c < 4; ++c)
    EXPECT_NEAR(turns[20 + static_cast<std::size_t>(c)], q.coeffs()[c], 1e-6);
  EXPECT_NEAR(places[17], 1.5, 1e-6);
}

TEST_F(Glb, TheMeshLiesInTheFirstFrameAndHasAllSegments) {
  write();
  Json net;
  for (const Json& mesh : json_["meshes"])
    if (mesh["name"] == "net") net = mesh["primitives"][0];
  const std::vector<float> positions = floats(net["attributes"]["POSITION"]);
  ASSERT_EQ(positions.size(), 3 * 6 * sample_.network.design.size());
  for (std::size_t k = 0; k < sample_.network.design.size(); ++k) {
    Vec3 middle = Vec3::Zero();
    for (std::size_t p = 0; p < 6; ++p)
      middle += Vec3(positions[18 * k + 3 * p], positions[18 * k + 3 * p + 1],
                     positions[18 * k + 3 * p + 2]) /
                6.0;
    EXPECT_LT((middle - sample_.state(0.0).x[k]).norm(), 1e-6);
  }
  // Twelve edges of an octahedron, two triangles each, for every segment.
  EXPECT_EQ(json_["accessors"][net["indices"].get<std::size_t>()]["count"],
            sample_.network.segments.size() * 12 * 6);
}

TEST_F(Glb, CornerMassesHangOnTheirJoints) {
  write();
  for (Index corner : sample_.network.corners) {
    const Json& joint =
        json_["nodes"]
             [json_["skins"][0]["joints"][static_cast<std::size_t>(corner)].get<std::size_t>()];
    ASSERT_EQ(joint["children"].size(), 1u);
    EXPECT_EQ(json_["nodes"][joint["children"][0].get<std::size_t>()]["name"], "corner mass");
  }
}

TEST_F(Glb, LongRunsAreThinnedOutToABoundedSize) {
  const GlbReport report = write(25 * 12 * 3);  // room for three frames of 25 nodes
  EXPECT_EQ(report.written, 4u);                // every second one, and the last
  EXPECT_EQ(report.recorded, 6u);
  const std::vector<float> times = floats(json_["animations"][0]["samplers"][0]["input"]);
  EXPECT_THAT(times, ::testing::Pointwise(::testing::FloatNear(1e-6f), {0.0f, 0.4f, 0.8f, 1.0f}));
}

TEST_F(Glb, RefusesWhatIsNoRun) {
  EXPECT_THROW(export_glb(folder_ / "no", folder_ / "run.glb"), InputError);
}

}  // namespace
}  // namespace retiarius
