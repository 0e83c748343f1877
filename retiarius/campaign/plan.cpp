#include "retiarius/campaign/plan.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "retiarius/base/random.hpp"
#include "retiarius/campaign/copula.hpp"
#include "retiarius/campaign/permutation.hpp"
#include "retiarius/campaign/variable.hpp"

namespace retiarius {

namespace {

// Streams of the master seed: below kDimensions x 2 they are coordinates.
constexpr std::uint64_t kSeedStream = std::uint64_t{1} << 40;
constexpr std::uint64_t kOrderStream = std::uint64_t{1} << 41;

// Shares never reach 0 or 1, where quantiles may be infinite.
double open_share(double share) { return std::clamp(share, 0x1.0p-53, 1.0 - 0x1.0p-53); }

std::int64_t levels(const VariableSpec& variable) {
  return variable.distribution == Distribution::values
             ? static_cast<std::int64_t>(variable.values.size())
             : variable.levels;
}

std::int64_t count_runs(const CampaignSpec& campaign, int dimensions) {
  switch (campaign.plan.design) {
    case Design::list:
      return static_cast<std::int64_t>(campaign.variables.front().values.size());
    case Design::saltelli:
      return campaign.plan.runs * (dimensions + 2);
    case Design::grid:
      break;
    default:
      return campaign.plan.runs;
  }
  constexpr std::int64_t kMost = 1'000'000'000;
  std::int64_t runs = 1;
  for (const VariableSpec& variable : campaign.variables) {
    runs *= levels(variable);
    if (runs > kMost)
      throw InputError(variable.place, fmt::format("the grid has more than {} runs", kMost));
  }
  return runs;
}

}  // namespace

CampaignPlan::CampaignPlan(const CampaignSpec& campaign) : campaign_(&campaign) {
  std::vector<std::size_t> first;
  for (const VariableSpec& variable : campaign.variables) {
    first.push_back(static_cast<std::size_t>(dimensions_));
    dimensions_ += variable.dimensions();
  }
  runs_ = count_runs(campaign, dimensions_);
  for (const GroupSpec& group : campaign.groups) {
    factors_.push_back(correlation_factor(group));
    std::vector<std::size_t>& cells = group_cells_.emplace_back();
    for (const std::string& name : group.variables)
      for (std::size_t i = 0; i < campaign.variables.size(); ++i)
        if (campaign.variables[i].name == name) cells.push_back(first[i]);
  }
}

double CampaignPlan::share(std::int64_t id, int dimension) const {
  const auto run = static_cast<std::uint64_t>(id);
  const auto stream = static_cast<std::uint64_t>(dimension);
  const std::uint64_t seed = campaign_->plan.seed;
  switch (campaign_->plan.design) {
    case Design::latin_hypercube: {
      const auto count = static_cast<std::uint64_t>(runs_);
      const std::uint64_t stratum = permuted(run, count, seed, kOrderStream + stream);
      const double inside = random_uniform(seed, stream, run);
      return (static_cast<double>(stratum) + inside) / static_cast<double>(count);
    }
    case Design::sobol:
      return sobol_.scrambled(run, dimension, seed);
    case Design::saltelli: {
      const std::int64_t width = dimensions_ + 2;
      const std::int64_t j = id % width;
      const bool from_b = j == 1 || j == 2 + dimension;
      return sobol_.scrambled(static_cast<std::uint64_t>(id / width),
                              from_b ? dimensions_ + dimension : dimension, seed);
    }
    default:
      return random_uniform(seed, stream, run);
  }
}

// The rows of a saltelli block differ by their inputs alone.
std::int64_t CampaignPlan::seed(std::int64_t id) const {
  const bool blocks = campaign_->plan.design == Design::saltelli;
  const std::int64_t drawn = blocks ? id / (dimensions_ + 2) : id;
  return static_cast<std::int64_t>(
      random_bits(campaign_->plan.seed, kSeedStream, static_cast<std::uint64_t>(drawn)) >> 1);
}

// The last variable runs fastest.
std::vector<double> CampaignPlan::grid_shares(std::int64_t id) const {
  std::vector<double> result(campaign_->variables.size());
  for (std::size_t i = result.size(); i-- > 0;) {
    const std::int64_t count = levels(campaign_->variables[i]);
    result[i] = (static_cast<double>(id % count) + 0.5) / static_cast<double>(count);
    id /= count;
  }
  return result;
}

std::vector<double> CampaignPlan::given_values(std::int64_t id) const {
  std::vector<double> result(campaign_->variables.size());
  for (std::size_t i = result.size(); i-- > 0;) {
    const VariableSpec& variable = campaign_->variables[i];
    const std::int64_t count = levels(variable);
    if (variable.distribution == Distribution::values)
      result[i] = variable.values[static_cast<std::size_t>(id % count)];
    if (campaign_->plan.design == Design::grid) id /= count;
  }
  return result;
}

void CampaignPlan::correlate_groups(std::vector<double>& shares) const {
  for (std::size_t g = 0; g < factors_.size(); ++g) {
    std::vector<double> part;
    for (const std::size_t cell : group_cells_[g]) part.push_back(shares[cell]);
    correlate(factors_[g], part);
    for (std::size_t i = 0; i < part.size(); ++i) shares[group_cells_[g][i]] = part[i];
  }
}

std::vector<double> CampaignPlan::shares(std::int64_t id) const {
  if (campaign_->plan.design == Design::grid) return grid_shares(id);
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(dimensions_));
  for (int d = 0; d < dimensions_; ++d) result.push_back(open_share(share(id, d)));
  return result;
}

PlannedRun CampaignPlan::run(std::int64_t id) const {
  if (id < 0 || id >= runs_)
    throw InputError(fmt::format("there is no run {}: ids go from 0 to {}", id, runs_ - 1));
  PlannedRun result;
  result.id = id;
  result.seed = seed(id);
  std::vector<double> cube = shares(id);
  correlate_groups(cube);
  const std::vector<double> given = given_values(id);
  std::size_t at = 0;
  for (std::size_t i = 0; i < campaign_->variables.size(); ++i) {
    const VariableSpec& variable = campaign_->variables[i];
    const auto width = static_cast<std::size_t>(variable.dimensions());
    const std::span<const double> part = std::span(cube).subspan(at, width);
    const std::vector<double> inputs = variable.distribution == Distribution::values
                                           ? std::vector<double>{given[i]}
                                           : variable_inputs(variable, part);
    at += width;
    const std::string value = variable_value(variable, inputs);
    result.inputs.insert(result.inputs.end(), inputs.begin(), inputs.end());
    for (const std::string& path : variable.sets)
      result.overrides.push_back(fmt::format("{}={}", path, value));
  }
  result.overrides.push_back(fmt::format("seed={}", result.seed));
  return result;
}

}  // namespace retiarius
