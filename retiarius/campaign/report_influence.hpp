// Pictures of which inputs matter: rank correlations and Sobol indices.
#pragma once

#include <optional>
#include <vector>

#include "retiarius/campaign/report_data.hpp"

namespace retiarius {

// Rank correlations of a result with each input, the strongest at the top.
CampaignFigure tornado_figure(const ReportColumns& columns, const CampaignResult& result,
                              const std::string& id);

// First and total Sobol indices of a result; absent where the design gives none, where nothing
// varies, or where fewer than two blocks are whole.
std::optional<CampaignFigure> sobol_figure(const ReportColumns& columns,
                                           const CampaignResult& result, const std::string& id);

// Total indices from the first part of the blocks, against how many these are; absent likewise.
std::optional<CampaignFigure> sobol_convergence_figure(const ReportColumns& columns,
                                                       const CampaignResult& result,
                                                       const std::string& id);

}  // namespace retiarius
