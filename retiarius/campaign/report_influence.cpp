#include "retiarius/campaign/report_influence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "retiarius/campaign/sobol_indices.hpp"
#include "retiarius/report/chart_svg.hpp"
#include "retiarius/report/panel.hpp"
#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kMostRows = 14, kMostCurves = 5;

// A result of every run by its id, as sobol_indices() takes it.
std::vector<double> by_id(const CampaignTable& table, const CampaignResult& result) {
  if (table.runs.empty()) return {};
  std::vector<double> values(static_cast<std::size_t>(table.runs.back().id) + 1,
                             std::numeric_limits<double>::quiet_NaN());
  for (const CampaignRow& row : table.runs) {
    double& value = values[static_cast<std::size_t>(row.id)];
    if (result.measure != kSuccess)
      value = row.measures[result.measure];
    else if (row.success)
      value = *row.success ? 1.0 : 0.0;
  }
  return values;
}

bool gives_indices(const CampaignTable& table) {
  return table.design == CampaignDesign::saltelli && !table.inputs.empty();
}

std::vector<std::size_t> by_total(const SobolIndices& indices) {
  std::vector<std::size_t> order(indices.inputs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return indices.inputs[a].total > indices.inputs[b].total;
  });
  return order;
}

void draw_index(Panel& panel, std::size_t row, double offset, double value,
                const Interval& interval, const std::string& color) {
  panel.row_bar(row, offset, 10.0, 0.0, value, color, 0.8);
  panel.row_whisker(row, offset, interval.low, interval.high);
}

}  // namespace

CampaignFigure tornado_figure(const ReportColumns& columns, const CampaignResult& result,
                              const std::string& id) {
  const std::vector<Influence> found = influences(columns, result);
  std::vector<std::size_t> order = strongest_first(found);
  order.resize(std::min(order.size(), kMostRows));
  std::vector<std::string> names;
  double reach = 0.2;
  for (std::size_t k : order) {
    names.push_back(found[k].name(columns.table->inputs[columns.ranked[k]]));
    const Interval& i = found[k].correlation.interval;
    reach = std::max({reach, -i.low, i.high});
  }
  Panel panel({-reach, reach}, names, "rank correlation");
  const ChartPaint& paint = page_paint();
  std::string said;
  for (std::size_t row = 0; row < order.size(); ++row) {
    const RankCorrelation& r = found[order[row]].correlation;
    const bool clear = !r.interval.contains(0.0);
    panel.row_bar(row, 0.0, 16.0, 0.0, r.rho, paint.series[r.rho < 0.0 ? 1 : 0],
                  clear ? 0.8 : 0.25);
    panel.row_whisker(row, 0.0, r.interval.low, r.interval.high);
    said += fmt::format("{}{}: {}", row > 0 ? "; " : "", names[row], short_number(r.rho));
  }
  const std::string title = fmt::format("What {} goes with", result.name);
  return {title, panel.svg(title, said, id), ""};
}

std::optional<CampaignFigure> sobol_figure(const ReportColumns& columns,
                                           const CampaignResult& result, const std::string& id) {
  const CampaignTable& table = *columns.table;
  if (!gives_indices(table)) return std::nullopt;
  const SobolIndices indices = sobol_indices(by_id(table, result), table.inputs.size());
  if (indices.blocks < 2 || !(indices.variance > 0.0)) return std::nullopt;
  std::vector<std::size_t> order = by_total(indices);
  order.resize(std::min(order.size(), kMostRows));
  std::vector<std::string> names;
  Extent extent{0.0, 0.1};
  for (std::size_t i : order) {
    names.push_back(table.inputs[i]);
    const SobolIndex& s = indices.inputs[i];
    extent.add({s.first_interval.low, s.first_interval.high, s.total_interval.high}, false);
  }
  Panel panel(extent, names, "share of the variance");
  const ChartPaint& paint = page_paint();
  std::string said;
  for (std::size_t row = 0; row < order.size(); ++row) {
    const SobolIndex& s = indices.inputs[order[row]];
    draw_index(panel, row, -6.0, s.first, s.first_interval, paint.series[0]);
    draw_index(panel, row, 6.0, s.total, s.total_interval, paint.series[1]);
    said += fmt::format("{}{}: first {}, total {}", row > 0 ? "; " : "", names[row],
                        short_number(s.first), short_number(s.total));
  }
  panel.legend("first order: alone", -1, paint.series[0], 0.8);
  panel.legend("total: alone and with others", -1, paint.series[1], 0.8);
  std::string caption = fmt::format("{} blocks; 95 % bootstrap intervals.", indices.blocks);
  if (indices.dropped > 0)
    caption += fmt::format(" {} blocks left out, which lack a value.", indices.dropped);
  const std::string title = fmt::format("Sobol indices of {}", result.name);
  return CampaignFigure{title, panel.svg(title, said, id), caption};
}

std::optional<CampaignFigure> sobol_convergence_figure(const ReportColumns& columns,
                                                       const CampaignResult& result,
                                                       const std::string& id) {
  const CampaignTable& table = *columns.table;
  if (!gives_indices(table)) return std::nullopt;
  const std::vector<double> values = by_id(table, result);
  const std::size_t rows = table.inputs.size() + 2;
  BootstrapOptions options;
  options.replicates = 2;  // intervals are not drawn here
  const SobolIndices all = sobol_indices(values, table.inputs.size(), options);
  if (all.blocks < 16 || !(all.variance > 0.0)) return std::nullopt;
  Chart chart{fmt::format("Total indices of {} against number of blocks", result.name),
              "blocks",
              "total index",
              true,
              false,
              false,
              {},
              "",
              ""};
  const std::vector<std::size_t> order = by_total(all);
  for (std::size_t k = 0; k < std::min(order.size(), kMostCurves); ++k)
    chart.curves.push_back({table.inputs[order[k]], {}, {}, CurveStyle::line});
  const std::size_t whole = values.size() / rows;
  for (double part : {1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 3.0 / 4, 1.0}) {
    const auto blocks = static_cast<std::size_t>(part * static_cast<double>(whole));
    const std::vector<double> first(values.begin(),
                                    values.begin() + static_cast<std::ptrdiff_t>(blocks * rows));
    const SobolIndices found = sobol_indices(first, table.inputs.size(), options);
    if (found.blocks < 2) continue;
    for (std::size_t k = 0; k < chart.curves.size(); ++k) {
      chart.curves[k].x.push_back(static_cast<double>(found.blocks));
      chart.curves[k].y.push_back(found.inputs[order[k]].total);
    }
  }
  return CampaignFigure{chart.title, chart_svg(chart, ChartLook::page, id), ""};
}

}  // namespace retiarius
