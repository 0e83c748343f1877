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

// How a result goes with an input. What is best in the middle of an input, as with an error of aim
// to either side, has no rank correlation with the input itself but one with the distance from its
// median; the stronger of the two is taken.
struct Influence {
  RankCorrelation correlation;
  bool off_median = false;  // of the distance from the median
  double strength() const;  // |rho|, 0 where there is none
  std::string name(const std::string& input) const;
};
Influence influence(const std::vector<double>& input, const std::vector<double>& result);

// Of each input of `ranked`, in its order.
std::vector<Influence> influences(const ReportColumns& columns, const CampaignResult& result);

// Indices of `found` with a correlation, the strongest first.
std::vector<std::size_t> strongest_first(const std::vector<Influence>& found);

// A number as a reader wants it, four digits.
std::string short_number(double value);
// A share in per cent, one digit after the point.
std::string percent_text(double share);

}  // namespace retiarius
