// report.html: one self-contained page about one run.
#pragma once

#include <string>

#include "retiarius/report/report_data.hpp"

namespace retiarius {

// The page's text: no scripts, no references to anything outside it.
std::string report_html(const ReportData& data);

// The style sheet, with light and dark colours after the reader's preference.
extern const char* const kReportStyle;

}  // namespace retiarius
