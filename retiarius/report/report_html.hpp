// report.html: one self-contained page about one run.
#pragma once

#include <string>

#include "retiarius/report/report_data.hpp"

namespace retiarius {

// The page's text: no scripts, no references to anything outside it. `note` is told below the
// outcome.
std::string report_html(const ReportData& data, const std::string& note = "");

// The style sheet, with light and dark colours after the reader's preference.
extern const char* const kReportStyle;

}  // namespace retiarius
