// Recorded runs with faults planted in them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

#include "retiarius/check/check_contact.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/record/run_h5.hpp"

namespace retiarius::testing {

// A square net of 3 x 3 nodes, 1 m wide, with threads of radius 1 mm, over a target.
inline std::string mission_with(const std::string& target) {
  return R"([net]
pattern = "square"
side = 1.0
mesh = 0.5
segments = 1
[net.thread]
young_modulus = 1.0e9
density = 1000.0
radius = 0.001
[[phase]]
kind = "free"
until = "time >= 1.0"
[target]
motion = "fixed"
)" + target;
}

inline std::string replaced_once(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

// Writes run.h5 state by state, without simulating anything.
class PlantedRun {
 public:
  // `recorded` (default: the same) is the text of the mission that the run keeps.
  explicit PlantedRun(const std::string& mission_text, const std::string& recorded = "")
      : folder_(
            std::filesystem::temp_directory_path() /
            ("retiarius-planted-" + std::to_string(::getpid()) + "-" + std::to_string(count()++))),
        mission_(parse_mission(mission_text)),
        model_(mission_) {
    std::filesystem::create_directories(folder_);
    file_ = std::make_unique<RunH5>(folder_, recorded.empty() ? mission_text : recorded, "test");
    RunModel run;
    run.mission = &mission_;
    run.network = &model_.network;
    run.bodies = &model_.bodies;
    file_->begin(run);
    for (const Body& body : model_.bodies) poses.push_back(body.initial);
    x = model_.network.design;
  }
  ~PlantedRun() { std::filesystem::remove_all(folder_); }
  PlantedRun(const PlantedRun&) = delete;
  PlantedRun& operator=(const PlantedRun&) = delete;

  std::vector<Vec3> x;           // of the next state
  std::vector<BodyState> poses;  // of the next state
  const Network& network() const { return model_.network; }

  void lift(double z) {
    for (Vec3& p : x) p.z() = z;
  }

  void save(double time) {
    State state;
    state.time = time;
    state.x = x;
    state.v.assign(x.size(), Vec3::Zero());
    state.bodies = poses;
    const std::vector<double> none(model_.network.segments.size(), 0.0);
    file_->frame({0, &state, none, none, std::vector<double>(x.size(), 0.0), {}});
  }

  ContactCheck check(const ContactCheckOptions& options = {}) {
    if (file_) file_->end({});
    file_.reset();
    return check_contact(folder_, options);
  }

 private:
  static int& count() {
    static int value = 0;
    return value;
  }

  std::filesystem::path folder_;
  Mission mission_;
  MissionModel model_;
  std::unique_ptr<RunH5> file_;
};

}  // namespace retiarius::testing
