// A campaign that is ready to run: its file, its mission, its plan, and what tells it from others.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "retiarius/campaign/plan.hpp"
#include "retiarius/campaign/spec.hpp"
#include "retiarius/mission/mission.hpp"

namespace retiarius {

// What results depend on, as hashes; results of another identity are never mixed with these.
struct CampaignIdentity {
  std::string campaign;  // the campaign file without comments and layout
  std::string mission;   // the mission with the overrides of all runs, and the files that it names
  std::string program;   // version, revision, compiler and kernels, as text

  std::string text() const;  // all three as one line
  bool operator==(const CampaignIdentity&) const = default;
};

class Campaign {
 public:
  // Reads the campaign and its mission, and chooses the kernels of this process. Throws InputError
  // where either is wrong, or where a variable sets what the mission does not have.
  explicit Campaign(const std::string& path);
  Campaign(const Campaign&) = delete;
  Campaign& operator=(const Campaign&) = delete;

  const CampaignSpec& spec() const { return spec_; }
  const CampaignPlan& plan() const { return *plan_; }
  const CampaignIdentity& identity() const { return identity_; }

  // The mission of one run. Throws InputError where its inputs do not make one.
  Mission mission(const PlannedRun& run) const;

  // What a shell is told to repeat a run alone.
  std::string command(std::int64_t id) const;

 private:
  void check_variables() const;

  CampaignSpec spec_;
  std::unique_ptr<CampaignPlan> plan_;
  std::string mission_file_, mission_text_, mission_folder_;
  CampaignIdentity identity_;
};

}  // namespace retiarius
