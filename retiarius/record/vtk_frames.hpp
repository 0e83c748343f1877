// frames/ and frames.pvd: what ParaView opens.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "retiarius/mission/observer.hpp"
#include "retiarius/record/vtp.hpp"

namespace retiarius {

// What stays the same in all frames of a run.
struct NetDrawing {
  std::vector<std::array<Index, 2>> segments;
  std::vector<float> radius;    // of each node: the thickest of its segments, m
  std::vector<float> material;  // of each segment
  std::vector<float> thread;    // of each segment, -1 where none
};
NetDrawing net_drawing(const Network& network);

struct BodyDrawing {
  std::string name;
  TriangleMesh mesh;  // body axes
};

// What one frame shows: positions, velocities, what the threads carry, poses of the bodies.
struct FrameData {
  double time = 0.0;
  Index phase = 0;
  std::vector<Vec3> x, v;
  std::vector<double> tension, strain, curvature;
  std::vector<BodyState> bodies;
  std::vector<Index> contact;  // of each node: 0 free, 1 slides, 2 sticks; empty: not recorded
  std::vector<ContactMark> contacts;
};

// Writes frames one by one below a folder: frames/frame_000000.vtp, frames/body_NAME_000000.vtp,
// and frames.pvd that lists them. frames.pvd is replaced atomically, at each frame at first and
// then each time the number of frames has grown by a sixty-fourth, so it is valid at any time.
class VtkSeries {
 public:
  VtkSeries(std::filesystem::path folder, NetDrawing net, std::vector<BodyDrawing> bodies);

  void add(const FrameData& frame);
  void finish();  // brings frames.pvd up to date
  // Removes frames beyond those that were added, which an earlier run left.
  void remove_later_frames();

 private:
  void write_net(const FrameData& frame, int number);
  void write_body(const FrameData& frame, std::size_t body, int number);

  std::filesystem::path folder_;
  NetDrawing net_;
  std::vector<BodyDrawing> bodies_;
  std::vector<PvdEntry> entries_;
  int frames_ = 0;
  int listed_ = 0;  // frames in frames.pvd on disk
};

class VtkFrames : public Observer {
 public:
  explicit VtkFrames(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void begin(const RunModel& model) override;
  void frame(const Frame& frame) override;
  void resumed() override;
  void end(const RunReport& report) override;

 private:
  std::filesystem::path folder_;
  std::vector<VtkSeries> series_;  // one, from begin() on
};

// The bodies of a run as they are drawn.
std::vector<BodyDrawing> body_drawings(const RunModel& model);

// Of each node: 0 free, 1 slides along a body, 2 sticks to one.
std::vector<Index> contact_of_nodes(const State& state);

// A frame's data copied, to be kept beyond the call.
FrameData frame_data(const Frame& frame);

}  // namespace retiarius
