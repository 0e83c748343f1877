#include "retiarius/campaign/report_success.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "retiarius/campaign/statistics_distribution.hpp"
#include "retiarius/report/panel.hpp"
#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kCurvePoints = 300, kMostPoints = 800;
constexpr std::int64_t kFewRuns = 5;

Extent extent_of(const std::vector<double>& values) {
  Extent extent = Extent::none();
  extent.add(values, false);
  return extent;
}

Extent with_edges(const Histogram& h) { return {h.edges.front(), h.edges.back()}; }

// More cells where there are more runs, so that each has some.
std::size_t map_cells(std::size_t runs) {
  const double cells = std::round(0.7 * std::cbrt(static_cast<double>(runs)));
  return static_cast<std::size_t>(std::clamp(cells, 3.0, 8.0));
}

// Blue above one half, orange below, paper between.
const std::string& cell_color(double rate) { return page_paint().series[rate >= 0.5 ? 0 : 1]; }
double cell_opacity(double rate) { return 0.04 + 1.1 * std::abs(rate - 0.5); }

std::string interval_text(const SuccessCount& count) {
  const Interval i = count.interval();
  return fmt::format("{} of {} succeed, 95 % interval {} to {}", count.successes, count.answered,
                     percent_text(i.low), percent_text(i.high));
}

void add(SuccessCount& count, double success) {
  if (std::isnan(success)) {
    ++count.unanswered;
    return;
  }
  ++count.answered;
  if (success > 0.5) ++count.successes;
}

struct Cells {
  Histogram x, y;
  std::vector<SuccessCount> counts;  // row by row of y
  SuccessCount& at(std::size_t i, std::size_t j) { return counts[j * x.counts.size() + i]; }
};

Cells cells_of(const ReportColumns& columns, std::size_t x_input, std::size_t y_input) {
  const std::size_t bins = map_cells(columns.runs.size());
  Cells cells{
      histogram(columns.inputs[x_input], bins), histogram(columns.inputs[y_input], bins), {}};
  cells.counts.resize(cells.x.counts.size() * cells.y.counts.size());
  for (std::size_t k = 0; k < columns.runs.size(); ++k) {
    const std::size_t i = cells.x.bin(columns.inputs[x_input][k]);
    const std::size_t j = cells.y.bin(columns.inputs[y_input][k]);
    if (i < cells.x.counts.size() && j < cells.y.counts.size())
      add(cells.at(i, j), columns.success.values[k]);
  }
  return cells;
}

void draw_cell(Panel& panel, const Cells& cells, std::size_t i, std::size_t j,
               const SuccessCount& count, bool small) {
  const double x0 = cells.x.edges[i], x1 = cells.x.edges[i + 1];
  const double y0 = cells.y.edges[j], y1 = cells.y.edges[j + 1];
  if (count.answered == 0) return;
  const bool few = count.answered < kFewRuns;
  if (!few || small)
    panel.rectangle(x0, y0, x1, y1, cell_color(count.rate()),
                    (few ? 0.5 : 1.0) * cell_opacity(count.rate()), interval_text(count));
  if (small) return;
  const double x = 0.5 * (x0 + x1), y = 0.5 * (y0 + y1);
  const ChartPaint& paint = page_paint();
  if (few) {
    panel.text(x, y, fmt::format("{}/{}", count.successes, count.answered), 11, paint.soft, 4);
    return;
  }
  panel.text(x, y, fmt::format("{:.0f} %", 100.0 * count.rate()), 13, paint.ink, 0);
  panel.text(x, y, fmt::format("of {}", count.answered), 10, paint.ink, 12);
}

}  // namespace

double SuccessCount::rate() const {
  if (answered == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(successes) / static_cast<double>(answered);
}

Interval SuccessCount::interval() const { return wilson_interval(successes, answered); }

SuccessCount count_success(const ReportColumns& columns) {
  SuccessCount count;
  for (double v : columns.success.values) add(count, v);
  return count;
}

CampaignFigure convergence_figure(const ReportColumns& columns) {
  std::vector<double> n, rate, low, high;
  const SuccessCount all = count_success(columns);
  const std::int64_t every =
      std::max<std::int64_t>(1, all.answered / static_cast<std::int64_t>(kCurvePoints));
  SuccessCount count;
  for (double v : columns.success.values) {
    add(count, v);
    if (std::isnan(v)) continue;
    if (count.answered > 20 && count.answered % every != 0 && count.answered != all.answered)
      continue;
    n.push_back(static_cast<double>(count.answered));
    rate.push_back(100.0 * count.rate());
    low.push_back(100.0 * count.interval().low);
    high.push_back(100.0 * count.interval().high);
  }
  Panel panel({0.0, static_cast<double>(std::max<std::int64_t>(1, all.answered))}, {0.0, 100.0},
              "runs, in the order of their ids", "success rate / %");
  const ChartPaint& paint = page_paint();
  panel.band(n, low, high, paint.series[0], 0.22);
  panel.line(n, rate, paint.series[0]);
  if (!rate.empty()) panel.line({0.0, n.back()}, {rate.back(), rate.back()}, paint.soft, "2 3");
  panel.legend("rate so far", -1, paint.series[0]);
  panel.legend("95 % interval (Wilson)", -1, paint.series[0], 0.22);
  const std::string said = fmt::format("{}.", interval_text(all));
  return {"Success rate against number of runs",
          panel.svg("Success rate against number of runs", said, "convergence"),
          escape_html(said) +
              " An estimate that has come to rest stays within the band of its "
              "last runs."};
}

CampaignFigure success_map(const ReportColumns& columns, std::size_t x_input, std::size_t y_input,
                           const std::string& id, bool small) {
  const std::string& x_name = columns.table->inputs[x_input];
  const std::string& y_name = columns.table->inputs[y_input];
  Cells cells = cells_of(columns, x_input, y_input);
  Panel panel(with_edges(cells.x), with_edges(cells.y), x_name, y_name, false,
              small ? 280.0 : 340.0);
  for (std::size_t j = 0; j < cells.y.counts.size(); ++j)
    for (std::size_t i = 0; i < cells.x.counts.size(); ++i)
      draw_cell(panel, cells, i, j, cells.at(i, j), small);
  const ChartPaint& paint = page_paint();
  if (!small) {
    panel.legend("all succeed", -1, paint.series[0], cell_opacity(1.0));
    panel.legend("half succeed", -1, paint.series[0], cell_opacity(0.5));
    panel.legend("none succeeds", -1, paint.series[1], cell_opacity(0.0));
  }
  const std::string title = fmt::format("Success over {} and {}", x_name, y_name);
  return {small ? fmt::format("{} and {}", x_name, y_name) : title,
          panel.svg(title, "Success rate and number of runs in each cell.", id),
          small ? ""
                : "Rate and number of runs in each cell; cells of fewer than five runs show only "
                  "how many of them succeeded."};
}

CampaignFigure success_points(const ReportColumns& columns, std::size_t x_input,
                              std::size_t y_input, const std::string& id) {
  const std::string& x_name = columns.table->inputs[x_input];
  const std::string& y_name = columns.table->inputs[y_input];
  const Cells cells = cells_of(columns, x_input, y_input);
  Panel panel(with_edges(cells.x), with_edges(cells.y), x_name, y_name, false, 340.0);
  const ChartPaint& paint = page_paint();
  const std::size_t runs = columns.runs.size();
  const std::size_t every = runs / kMostPoints + 1;
  bool unanswered = false;
  for (std::size_t k = 0; k < runs; k += every) {
    const double x = columns.inputs[x_input][k], y = columns.inputs[y_input][k];
    const double success = columns.success.values[k];
    if (std::isnan(success)) {
      unanswered = true;
      panel.marker(5, x, y, 3.2, paint.ink, false, 0.8);
    } else if (success > 0.5) {
      panel.marker(0, x, y, 2.1, paint.series[0], true, 0.55);
    } else {
      panel.marker(6, x, y, 2.6, paint.series[1], false, 0.9);
    }
  }
  panel.legend("succeeded", 0, paint.series[0]);
  panel.legend("did not", 6, paint.series[1]);
  if (unanswered) panel.legend("no answer", 5, paint.ink);
  const std::string title = fmt::format("Runs over {} and {}", x_name, y_name);
  return {title, panel.svg(title, "One marker a run.", id),
          every == 1
              ? "One marker a run."
              : fmt::format("One marker a run; one in {} of {} runs is drawn.", every, runs)};
}

CampaignFigure success_along(const ReportColumns& columns, std::size_t input,
                             const std::string& id) {
  const std::vector<double>& values = columns.inputs[input];
  const std::string& name = columns.table->inputs[input];
  const Histogram classes = histogram(values, map_cells(columns.runs.size()) + 2);
  std::vector<SuccessCount> counts(classes.counts.size());
  std::vector<double> sums(classes.counts.size(), 0.0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t bin = classes.bin(values[k]);
    if (bin >= counts.size()) continue;
    add(counts[bin], columns.success.values[k]);
    if (!std::isnan(columns.success.values[k])) sums[bin] += values[k];
  }
  Panel panel(extent_of(classes.edges), {0.0, 100.0}, name, "success rate / %", true, 200.0);
  const std::string& color = page_paint().series[0];
  std::vector<double> x, y;
  for (std::size_t b = 0; b < counts.size(); ++b) {
    if (counts[b].answered == 0) continue;
    x.push_back(sums[b] / static_cast<double>(counts[b].answered));
    y.push_back(100.0 * counts[b].rate());
    panel.whisker(x.back(), 100.0 * counts[b].interval().low, 100.0 * counts[b].interval().high,
                  color);
  }
  panel.line(x, y, color);
  for (std::size_t k = 0; k < x.size(); ++k) panel.marker(0, x[k], y[k], 3.2, color, true);
  const std::string title = fmt::format("Success along {}", name);
  return {title, panel.svg(title, "Success rate in classes of the input.", id), ""};
}

}  // namespace retiarius
