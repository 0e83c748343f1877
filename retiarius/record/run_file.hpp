// Reading run.h5 back.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "retiarius/record/vtk_frames.hpp"

namespace retiarius {

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
  std::vector<BodyDrawing> bodies() const;

  std::vector<std::string> history_names() const;  // in the order of history.csv
  // One column; as many rows as are complete in all columns.
  std::vector<double> history(const std::string& name) const;

  std::size_t frame_count() const;  // complete frames
  FrameData frame(std::size_t number) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace retiarius
