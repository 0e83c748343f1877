// Pictures of how inputs and results are spread, and how results answer to inputs.
#pragma once

#include "retiarius/campaign/report_data.hpp"

namespace retiarius {

// How the values are spread, with runs that succeeded apart from the others. `values` belong to
// columns.runs.
CampaignFigure histogram_figure(const ReportColumns& columns, const std::string& name,
                                const std::vector<double>& values, const std::string& id);

// A result over an input: runs as points, and mean with its 95 % interval in classes of the input.
CampaignFigure response_figure(const ReportColumns& columns, const CampaignResult& result,
                               std::size_t input, const std::string& id);

}  // namespace retiarius
