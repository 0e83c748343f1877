#include "retiarius/record/vtk_frames.hpp"

#include <cstring>
#include <map>
#include <regex>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/body_mesh.hpp"
#include "retiarius/record/file.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::error_text;
using ::testing::HasSubstr;
using testing::SampleRun;
using testing::TemporaryFolder;

struct ParsedArray {
  std::string type;
  int components = 0;
  std::string bytes;

  template <class T>
  std::vector<T> as() const {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
};

struct ParsedVtp {
  std::map<std::string, int> counts;          // of NumberOfPoints, ...
  std::map<std::string, ParsedArray> arrays;  // "PointData/radius", "Lines/offsets", ...
};

std::string attribute(const std::string& tag, const std::string& name) {
  std::smatch match;
  if (!std::regex_search(tag, match, std::regex(" " + name + "=\"([^\"]*)\"")))
    throw std::runtime_error("no attribute " + name + " in " + tag);
  return match[1];
}

// A reader of its own, that knows the format from its description: every tag must be closed in
// order, and every appended block must lie inside the section and fill it without gaps.
ParsedVtp parse_vtp(const std::string& text) {
  const std::string marker = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t at = text.find(marker);
  const std::string tail = "\n</AppendedData>\n</VTKFile>\n";
  if (at == std::string::npos || !text.ends_with(tail)) throw std::runtime_error("no data");
  const std::string head = text.substr(0, at);
  const std::string raw =
      text.substr(at + marker.size(), text.size() - tail.size() - at - marker.size());
  ParsedVtp parsed;
  std::vector<std::string> open;
  std::size_t expected_offset = 0;
  const std::regex tag_pattern("<(/?)([A-Za-z]+)([^>]*?)(/?)>");
  for (std::sregex_iterator it(head.begin(), head.end(), tag_pattern), last; it != last; ++it) {
    const std::string name = (*it)[2], attributes = (*it)[3];
    if (!(*it)[1].str().empty()) {
      if (open.empty() || open.back() != name) throw std::runtime_error("unmatched " + name);
      open.pop_back();
      continue;
    }
    if (name == "Piece")
      for (const char* count : {"NumberOfPoints", "NumberOfLines", "NumberOfPolys"})
        parsed.counts[count] = std::stoi(attribute(attributes, count));
    if (name == "DataArray" && attribute(attributes, "format") == "appended") {
      const std::size_t offset = std::stoul(attribute(attributes, "offset"));
      if (offset != expected_offset) throw std::runtime_error("gap before a block");
      std::uint64_t size = 0;
      std::memcpy(&size, raw.data() + offset, 8);
      expected_offset = offset + 8 + size;
      if (expected_offset > raw.size()) throw std::runtime_error("block beyond the data");
      parsed.arrays[open.back() + "/" + attribute(attributes, "Name")] = {
          attribute(attributes, "type"), std::stoi(attribute(attributes, "NumberOfComponents")),
          raw.substr(offset + 8, size)};
    }
    if ((*it)[4].str().empty()) open.push_back(name);
  }
  if (expected_offset != raw.size()) throw std::runtime_error("data after the last block");
  if (open != std::vector<std::string>{"VTKFile"}) throw std::runtime_error("tags left open");
  return parsed;
}

TEST(VtkFrames, NetHoldsPointsSegmentsAndWhatTheThreadsCarry) {
  TemporaryFolder folder;
  const SampleRun run;
  VtkFrames recorder(folder.path());
  run.feed(recorder, 3);
  const ParsedVtp net = parse_vtp(read_whole_file(folder / "frames/frame_000001.vtp"));
  const State state = run.state(0.2);
  EXPECT_EQ(net.counts.at("NumberOfPoints"), 25);
  EXPECT_EQ(net.counts.at("NumberOfLines"), 40);
  EXPECT_EQ(net.counts.at("NumberOfPolys"), 0);
  const auto points = net.arrays.at("Points/Points").as<double>();
  ASSERT_EQ(points.size(), 75u);
  EXPECT_EQ(points[3 * 7 + 2], state.x[7].z());
  const auto lines = net.arrays.at("Lines/connectivity").as<std::int64_t>();
  ASSERT_EQ(lines.size(), 80u);
  EXPECT_EQ(lines[10], run.network.segments[5].a);
  EXPECT_EQ(lines[11], run.network.segments[5].b);
  EXPECT_EQ(net.arrays.at("Lines/offsets").as<std::int64_t>().back(), 80);
  EXPECT_EQ(net.arrays.at("CellData/tension").as<float>()[5],
            static_cast<float>(run.frame(state).tension[5]));
  EXPECT_EQ(net.arrays.at("CellData/strain").as<float>()[39], 39e-4f);
  EXPECT_EQ(net.arrays.at("CellData/thread").as<float>()[39], 9.0f);
  EXPECT_EQ(net.arrays.at("CellData/material").as<float>()[39], 1.0f);
  EXPECT_EQ(net.arrays.at("PointData/curvature").as<float>()[0], 0.7f);
  EXPECT_EQ(net.arrays.at("PointData/velocity").components, 3);
  const auto radius = net.arrays.at("PointData/radius").as<float>();
  EXPECT_EQ(radius[0], 0.002f);   // a corner lies on the thick border
  EXPECT_EQ(radius[12], 0.001f);  // the centre does not
}

TEST(VtkFrames, BodyIsPosedInTheWorld) {
  TemporaryFolder folder;
  const SampleRun run;
  VtkFrames recorder(folder.path());
  run.feed(recorder, 3);
  const ParsedVtp body = parse_vtp(read_whole_file(folder / "frames/body_target_000001.vtp"));
  EXPECT_EQ(body.counts.at("NumberOfPoints"), 8);
  EXPECT_EQ(body.counts.at("NumberOfPolys"), 12);
  const auto points = body.arrays.at("Points/Points").as<double>();
  const BodyState pose = run.state(0.2).bodies[0];
  const Vec3 corner = pose.position + pose.attitude * Vec3(0.5, 0.3, 0.2);
  EXPECT_LT((Vec3(points[21], points[22], points[23]) - corner).norm(), 1e-15);
}

TEST(VtkFrames, PvdIsValidAndCompleteAfterEachOfTheFirstFrames) {
  TemporaryFolder folder;
  const SampleRun run;
  VtkFrames recorder(folder.path());
  recorder.begin(run.model());
  EXPECT_EQ(read_whole_file(folder / "frames.pvd"), pvd_text({}));
  for (int k = 0; k < 3; ++k) {
    const State state = run.state(0.25 * k);
    recorder.frame(run.frame(state));
    const std::string pvd = read_whole_file(folder / "frames.pvd");
    EXPECT_THAT(pvd, HasSubstr("timestep=\"" + std::to_string(0.25 * k).substr(0, k ? 3 : 1)));
    EXPECT_THAT(pvd, HasSubstr("part=\"0\" file=\"frames/frame_00000" + std::to_string(k)));
    EXPECT_THAT(pvd, HasSubstr("part=\"1\" file=\"frames/body_target_00000" + std::to_string(k)));
    EXPECT_THAT(pvd, HasSubstr("</Collection>\n</VTKFile>\n"));
  }
}

TEST(VtkFrames, EndListsEveryFrameOfALongRun) {
  TemporaryFolder folder;
  const SampleRun run(1);
  VtkFrames recorder(folder.path());
  run.feed(recorder, 2 * 300 - 1);
  const auto listed = [&] {
    const std::string pvd = read_whole_file(folder / "frames.pvd");
    std::size_t count = 0;
    for (std::size_t at = pvd.find("frame_"); at != std::string::npos;
         at = pvd.find("frame_", at + 1))
      ++count;
    return count;
  };
  EXPECT_GE(listed(), 295u);
  recorder.end(run.report());
  EXPECT_EQ(listed(), 300u);
}

TEST(Vtp, RefusesArraysThatDoNotFit) {
  const std::vector<Vec3> points(3, Vec3::Zero());
  PolyData data;
  data.points = &points;
  data.point_data = {{"radius", 1, {1.0f, 2.0f}}};
  EXPECT_EQ(error_text<Error>([&] { vtp_text(data); }),
            "PointData array radius has 2 values for 3 elements of 1 components");
}

TEST(DrawnMesh, ShowsAPlaneAsASquareTwiceAsWideAsTheNet) {
  const SampleRun run;
  Body plane;
  plane.kind = ShapeKind::plane;
  const TriangleMesh mesh = drawn_mesh(plane, run.network);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_DOUBLE_EQ((mesh.vertices[1] - mesh.vertices[0]).norm(), 4.0);
  const auto [a, b, c] = mesh.triangles[0];
  const auto at = [&](Index k) { return mesh.vertices[static_cast<std::size_t>(k)]; };
  EXPECT_GT((at(b) - at(a)).cross(at(c) - at(a)).z(), 0.0);  // faces along +z
}

TEST(FileNameOf, ReplacesWhatFileSystemsOrXmlDislike) {
  EXPECT_EQ(file_name_of("a/b<c>\"&d e-1.5_"), "a_b_c___d_e-1.5_");
}

}  // namespace
}  // namespace retiarius
