// Tables of the report: how runs ended, and the worst of them.
#pragma once

#include <string>

#include "retiarius/campaign/report_data.hpp"

namespace retiarius {

// Outcomes with counts, and reasons that differ only in their numbers taken together.
std::string endings_html(const ReportColumns& columns);

// Runs that came to no answer first, then those that did not succeed, the worst capture quality at
// the top (where that is measured): inputs that matter, measures, reason, the command that repeats
// the run, and a link to its replay where that is kept.
std::string worst_html(const ReportColumns& columns);

// A reason with its numbers replaced by "#", by which runs that failed alike are taken together.
std::string without_numbers(const std::string& reason);

}  // namespace retiarius
