// The style of pages that show charts and tables of comparisons.
#pragma once

namespace retiarius {

// Light or dark after the reader's preference; tables become lists on a phone (cells name their
// column in data-l). Parts: .verdict (good or bad) with .big, nav, article, .charts with figures,
// .table, rows .missed, .badge (ok, miss, drawn), .note, .soft.
extern const char* const kChartPageStyle;

}  // namespace retiarius
