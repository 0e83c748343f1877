// Which plots a report shows.
#pragma once

#include <vector>

#include "retiarius/report/report_data.hpp"
#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

// The plots for which the history has data, in the order of the page.
std::vector<Plot> report_plots(const ReportData& data);

// A unit as readers write it: "m2" becomes "m" with a superscript two; "1" becomes empty.
std::string printed_unit(const std::string& unit);

}  // namespace retiarius
