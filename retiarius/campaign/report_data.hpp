// A campaign's table by columns, and which of them a report shows first.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "retiarius/campaign/statistics_rank.hpp"
#include "retiarius/campaign/table.hpp"

namespace retiarius {

// A picture of the report.
struct CampaignFigure {
  std::string title, svg, caption;  // caption: HTML
};

// What a run came to: success, or a measure.
struct CampaignResult {
  std::string name;
  std::vector<double> values;  // of each run in ReportColumns::runs; NaN: missing
  std::size_t measure = 0;     // its column; kSuccess for success
};
inline constexpr std::size_t kSuccess = static_cast<std::size_t>(-1);

// Columns over the runs that are independent draws of the inputs: all, but of design saltelli only
// the rows of A and B, for the others repeat inputs of these.
struct ReportColumns {
  const CampaignTable* table = nullptr;
  std::vector<const CampaignRow*> runs;
  std::vector<std::vector<double>> inputs;  // one a column of the table
  CampaignResult success;                   // 1, 0 or NaN
  std::vector<CampaignResult> results;      // measures that differ among runs, telling ones first
  // Inputs that vary, by how strongly success depends on them (where all runs end alike: the first
  // result), strongest first.
  std::vector<std::size_t> ranked;
};

// Throws InputError where a row has another number of values than the table has names, or where
// ids do not ascend.
ReportColumns report_columns(const CampaignTable& table);

// The result's rank correlation with each input of `ranked`, in its order.
std::vector<RankCorrelation> rank_correlations(const ReportColumns& columns,
                                               const CampaignResult& result);

// A number as a reader wants it, four digits.
std::string short_number(double value);
// A share in per cent, one digit after the point.
std::string percent_text(double share);

}  // namespace retiarius
