// The runs of a campaign: from a run's id to its inputs, computed when asked for and never stored.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "retiarius/campaign/sobol_sequence.hpp"
#include "retiarius/campaign/spec.hpp"

namespace retiarius {

struct PlannedRun {
  std::int64_t id = 0;
  std::int64_t seed = 0;               // of the mission
  std::vector<double> inputs;          // in the order of CampaignSpec::input_names()
  std::vector<std::string> overrides;  // of the mission, "path=value", numbers in full precision
};

// A pure function of campaign and id: neither the order in which runs are asked for nor who asks
// matters.
class CampaignPlan {
 public:
  explicit CampaignPlan(const CampaignSpec& campaign);

  // How many runs there are. Design saltelli: id = block (k + 2) + j for k inputs; j = 0 is a row
  // of A, j = 1 the same row of B, j = 2 + i the row of A with column i taken from B. A and B are
  // the halves of a scrambled Sobol' sequence of 2 k dimensions.
  std::int64_t runs() const { return runs_; }

  // Throws InputError where there is no run of this id.
  PlannedRun run(std::int64_t id) const;

  // The coordinates of a run in the open unit cube, before correlation.
  std::vector<double> shares(std::int64_t id) const;

 private:
  double share(std::int64_t id, int dimension) const;
  std::int64_t seed(std::int64_t id) const;
  std::vector<double> grid_shares(std::int64_t id) const;
  void correlate_groups(std::vector<double>& shares) const;
  std::vector<double> given_values(std::int64_t id) const;

  const CampaignSpec* campaign_;
  int dimensions_ = 0;
  std::int64_t runs_ = 0;
  SobolSequence sobol_;
  std::vector<Eigen::MatrixXd> factors_;               // of the groups
  std::vector<std::vector<std::size_t>> group_cells_;  // the coordinates of each group
};

}  // namespace retiarius
