// What of a run stays the same in all its pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "retiarius/mission/observer.hpp"
#include "retiarius/record/run_file.hpp"

namespace retiarius::render {

class DrawnRun {
 public:
  // Opens DIR/run.h5, and DIR/summary.json where it is there. Throws InputError that names the file
  // and what is wrong with it, and where nothing was recorded.
  explicit DrawnRun(const std::filesystem::path& folder);

  RunFile file;
  NetDrawing net;
  std::vector<bool> border;  // of each segment: on the net's outline
  std::vector<BodyDrawing> bodies;
  std::vector<Ball> balls;
  std::string title;
  RunReport report;           // phases; empty where there is no summary
  std::vector<double> times;  // of the frames, s

  // The frame nearest to the time. Throws InputError where the time lies outside the recording by
  // more than half an interval between frames.
  std::size_t frame_at(double time) const;

  // Name of the phase with this index: of the summary, else "phase 3" and so on.
  std::string phase_name(Index phase) const;
};

// Whether a picture of this phase shows the bodies: a net is folded on the ground, far from them.
bool shows_bodies(const DrawnRun& run, Index phase);

// Every point that a picture of the frame has to hold.
void add_points(const DrawnRun& run, const FrameData& frame, bool bodies,
                std::vector<Vec3>& points);

}  // namespace retiarius::render
