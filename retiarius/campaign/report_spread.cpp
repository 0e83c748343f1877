#include "retiarius/campaign/report_spread.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/campaign/statistics_distribution.hpp"
#include "retiarius/report/panel.hpp"
#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kMostPoints = 400, kClasses = 10;

struct Stack {
  std::vector<double> succeeded, all;
};

Stack stacked(const ReportColumns& columns, const std::vector<double>& values,
              const Histogram& bins) {
  Stack stack{std::vector<double>(bins.counts.size(), 0.0),
              std::vector<double>(bins.counts.size(), 0.0)};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t bin = bins.bin(values[k]);
    if (bin >= bins.counts.size()) continue;
    stack.all[bin] += 1.0;
    if (columns.success.values[k] > 0.5) stack.succeeded[bin] += 1.0;
  }
  return stack;
}

std::string spread_text(const SampleDistribution& d) {
  std::string text = fmt::format("Mean {}, deviation {}; median {}, 5 to 95 %: {} to {}",
                                 short_number(d.mean), short_number(d.deviation),
                                 short_number(d.median), short_number(d.q05), short_number(d.q95));
  if (d.missing > 0) text += fmt::format("; missing in {} runs", d.missing);
  return text + ".";
}

// The range that holds all but the outermost values, so that one wild run does not hide the rest.
Extent usual_range(const std::vector<double>& values, std::size_t& outside) {
  std::vector<double> sorted;
  for (double v : values)
    if (std::isfinite(v)) sorted.push_back(v);
  std::sort(sorted.begin(), sorted.end());
  outside = 0;
  if (sorted.empty()) return Extent::none();
  const double low = quantile(sorted, 0.005), high = quantile(sorted, 0.995);
  const double margin = 1.0 * (high - low);
  Extent extent = Extent::none();
  for (double v : sorted) {
    if (v < low - margin || v > high + margin)
      ++outside;
    else
      extent.add({v}, false);
  }
  return extent;
}

}  // namespace

CampaignFigure histogram_figure(const ReportColumns& columns, const std::string& name,
                                const std::vector<double>& values, const std::string& id) {
  std::size_t outside = 0;
  const Extent range = usual_range(values, outside);
  std::vector<double> shown;
  shown.reserve(values.size());
  for (double v : values) shown.push_back(v >= range.low && v <= range.high ? v : NAN);
  const Histogram bins = histogram(shown);
  const Stack stack = stacked(columns, shown, bins);
  double most = 1.0;
  for (double n : stack.all) most = std::max(most, n);
  Panel panel({bins.edges.front(), bins.edges.back()}, {0.0, most}, name, "runs", true, 170.0);
  const ChartPaint& paint = page_paint();
  for (std::size_t b = 0; b < bins.counts.size(); ++b) {
    const double gap = 0.04 * (bins.edges[b + 1] - bins.edges[b]);
    const double x0 = bins.edges[b] + gap, x1 = bins.edges[b + 1] - gap;
    panel.rectangle(x0, 0.0, x1, stack.succeeded[b], paint.series[0], 0.75);
    panel.rectangle(x0, stack.succeeded[b], x1, stack.all[b], paint.series[1], 0.75);
  }
  panel.legend("succeeded", -1, paint.series[0], 0.75);
  panel.legend("did not, or no answer", -1, paint.series[1], 0.75);
  std::string said = spread_text(distribution(values));
  if (outside > 0) said += fmt::format(" {} runs lie far outside and are not drawn.", outside);
  return {name, panel.svg("Distribution of " + name, said, id), escape_html(said)};
}

CampaignFigure response_figure(const ReportColumns& columns, const CampaignResult& result,
                               std::size_t input, const std::string& id) {
  const std::vector<double>& x = columns.inputs[input];
  const std::vector<double>& y = result.values;
  const std::string& x_name = columns.table->inputs[input];
  std::size_t outside = 0;
  const Extent range = usual_range(y, outside);
  const Histogram classes = histogram(x, kClasses);
  Panel panel({classes.edges.front(), classes.edges.back()}, range, x_name, result.name, true,
              210.0);
  const ChartPaint& paint = page_paint();
  const std::size_t every = x.size() / kMostPoints + 1;
  for (std::size_t k = 0; k < x.size(); k += every) {
    if (!(y[k] >= range.low && y[k] <= range.high)) continue;
    const bool good = columns.success.values[k] > 0.5;
    panel.marker(good ? 0 : 6, x[k], y[k], good ? 1.6 : 2.0, paint.series[good ? 0 : 1], good,
                 0.45);
  }
  std::vector<std::vector<double>> in_class(classes.counts.size()), places(classes.counts.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t bin = classes.bin(x[k]);
    if (bin >= in_class.size() || !std::isfinite(y[k])) continue;
    in_class[bin].push_back(y[k]);
    places[bin].push_back(x[k]);
  }
  std::vector<double> at, means;
  for (std::size_t b = 0; b < in_class.size(); ++b) {
    if (in_class[b].size() < 3) continue;
    const SampleDistribution d = distribution(in_class[b]);
    const double half = 1.96 * d.deviation / std::sqrt(static_cast<double>(d.count));
    at.push_back(distribution(places[b]).mean);
    means.push_back(d.mean);
    panel.whisker(at.back(), std::max(d.mean - half, panel.frame().y.low),
                  std::min(d.mean + half, panel.frame().y.high), paint.ink);
  }
  panel.line(at, means, paint.ink);
  for (std::size_t k = 0; k < at.size(); ++k)
    panel.marker(1, at[k], means[k], 2.6, paint.ink, true);
  const Influence found = influence(x, y);
  const RankCorrelation& r = found.correlation;
  std::string said = fmt::format("Rank correlation {}{}",
                                 found.off_median ? "with the distance from the median " : "",
                                 short_number(r.rho));
  if (!std::isnan(r.rho))
    said += fmt::format(" ({} to {})", short_number(r.interval.low), short_number(r.interval.high));
  said += ".";
  if (outside > 0) said += fmt::format(" {} runs lie far outside and are not drawn.", outside);
  const std::string title = fmt::format("{} over {}", result.name, x_name);
  return {title, panel.svg(title, said, id), escape_html(said)};
}

}  // namespace retiarius
