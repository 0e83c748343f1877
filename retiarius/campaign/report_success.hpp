// Pictures of success: its rate, how that came to rest, and where among the inputs it lies.
#pragma once

#include <cstdint>
#include <vector>

#include "retiarius/campaign/report_data.hpp"

namespace retiarius {

struct SuccessCount {
  std::int64_t successes = 0, answered = 0;  // runs that came to an answer
  std::int64_t unanswered = 0;               // runs that did not
  double rate() const;                       // NaN without answers
  Interval interval() const;                 // Wilson, 95 %
};
SuccessCount count_success(const ReportColumns& columns);

// The rate and its interval after the first n runs, for all n.
CampaignFigure convergence_figure(const ReportColumns& columns);

// Rate and count in the cells of a grid over two inputs. A cell of few runs (below 5) shows its
// count as "2/3" without colour. `small` leaves out the texts.
CampaignFigure success_map(const ReportColumns& columns, std::size_t x_input, std::size_t y_input,
                           const std::string& id, bool small = false);

// The runs themselves over the same two inputs.
CampaignFigure success_points(const ReportColumns& columns, std::size_t x_input,
                              std::size_t y_input, const std::string& id);

// The rate in classes of one input, with Wilson intervals.
CampaignFigure success_along(const ReportColumns& columns, std::size_t input,
                             const std::string& id);

}  // namespace retiarius
