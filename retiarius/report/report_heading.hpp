// What every page about a run begins with: title and outcome, for people who cannot see pictures
// too.
#pragma once

#include <string>

#include "retiarius/report/report_data.hpp"

namespace retiarius {

// "mouth_area" as "Mouth area".
std::string spaced(std::string name);

// Value and unit as HTML; a dash where the measure does not apply.
std::string measure_html(const Measure& measure);

// How the run ended, in one paragraph.
std::string outcome_html(const ReportData& data);

// The measures a reader looks for first, as far as the run has them.
std::string cards_html(const Measures& measures);

// The heading of a page that shows one run in 3D, or compares several.
std::string heading_html(const ReportData& data);
struct ComparedRun {
  std::string label;
  ReportData data;
};
std::string comparison_heading_html(const std::vector<ComparedRun>& runs);

}  // namespace retiarius
