// Reading run.h5 back.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "retiarius/record/vtk_frames.hpp"

namespace retiarius {

// A corner mass as it is drawn.
struct Ball {
  Index node = kNone;
  double radius = 0.0;  // m
};

// An open run.h5: of a finished run, of one that died, or of one that goes on. Every member
// function throws InputError that names the file and what is wrong with it.
class RunFile {
 public:
  explicit RunFile(const std::filesystem::path& path);
  ~RunFile();
  RunFile(RunFile&&) noexcept;

  std::string title() const;     // of the mission
  std::string resolved() const;  // the mission with all defaults
  NetDrawing net() const;
  std::vector<Index> corners() const;
  std::vector<Index> perimeter() const;
  std::vector<Index> bullets() const;          // nodes of the corner masses; empty: not recorded
  std::vector<double> mass() const;            // of each node, kg
  std::vector<double> segment_radius() const;  // m
  std::vector<double> rest_length() const;     // of each segment, m
  // The corner masses that weigh more than twice the usual node.
  std::vector<Ball> balls() const;
  std::vector<BodyDrawing> bodies() const;

  std::vector<std::string> history_names() const;  // in the order of history.csv
  // One column; as many rows as are complete in all columns.
  std::vector<double> history(const std::string& name) const;

  std::size_t frame_count() const;          // complete frames
  std::vector<double> frame_times() const;  // of each of them, s
  std::vector<Index> frame_phases() const;  // of each of them, index from 0
  FrameData frame(std::size_t number) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace retiarius
