#include "retiarius/report/report_plots.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius {

namespace {

constexpr const char* kContacts = "Nodes in contact";

bool is_zero(const PlotSeries& series) {
  return std::all_of(series.y.begin(), series.y.end(), [](double y) { return y == 0.0; });
}

bool is_zero(const Plot& plot) {
  return std::all_of(plot.series.begin(), plot.series.end(),
                     [](const PlotSeries& series) { return is_zero(series); });
}

// The history by columns, with the instants at which phases start.
class Columns {
 public:
  explicit Columns(const ReportData& data) : data_(data) {
    for (std::size_t k = 1; k < data.run.phases.size(); ++k)
      marks_.push_back(data.run.phases[k].start);
    time_ = values("time");
  }

  // Empty when there is no such column.
  std::vector<double> values(const std::string& name) const {
    const auto at = std::find(data_.columns.begin(), data_.columns.end(), name);
    std::vector<double> column;
    if (at == data_.columns.end()) return column;
    const auto k = static_cast<std::size_t>(at - data_.columns.begin());
    for (const auto& row : data_.rows) column.push_back(row[k]);
    return column;
  }

  // `names` pairs columns with what the legend calls them; columns that are zero throughout are
  // left out where others are not.
  Plot plot(const std::string& title, const std::string& unit,
            const std::vector<std::pair<std::string, std::string>>& names) const {
    Plot plot;
    plot.title = title;
    plot.unit = printed_unit(unit);
    plot.x = time_;
    plot.marks = marks_;
    int color = 0;  // kept by the series that remain, so that x, y, z look the same everywhere
    for (const auto& [column, label] : names) {
      PlotSeries series{label, values(column), color++};
      if (!series.y.empty()) plot.series.push_back(std::move(series));
    }
    if (!is_zero(plot))
      std::erase_if(plot.series, [](const PlotSeries& series) { return is_zero(series); });
    return plot;
  }

  // What has changed since the first row.
  Plot change(Plot plot) const {
    for (PlotSeries& series : plot.series) {
      const double first = series.y.empty() ? 0.0 : series.y.front();
      for (double& y : series.y) y -= first;
    }
    return plot;
  }

  Plot newton() const {
    Plot plot = this->plot("Newton iterations per step", "1", {});
    const std::vector<double> total = values("newton_iterations"), steps = values("step");
    PlotSeries series{"iterations", std::vector<double>(total.size(), NAN), 0};
    for (std::size_t k = 1; k < total.size(); ++k)
      if (steps[k] > steps[k - 1])
        series.y[k] = (total[k] - total[k - 1]) / (steps[k] - steps[k - 1]);
    plot.series = {series};
    plot.zero_based = true;
    return plot;
  }

  const ReportData& data_;

 private:
  std::vector<double> time_, marks_;
};

Plot zero_based(Plot plot) {
  plot.zero_based = true;
  return plot;
}

void add_probes(const Columns& columns, std::vector<Plot>& plots) {
  for (const std::string& name : columns.data_.columns) {
    if (!name.ends_with(".x")) continue;
    const std::string probe = name.substr(0, name.size() - 2);
    plots.push_back(columns.plot("Probe " + probe + ": position", "m",
                                 {{probe + ".x", "x"}, {probe + ".y", "y"}, {probe + ".z", "z"}}));
    Plot force = columns.plot("Probe " + probe + ": support force", "N",
                              {{probe + ".fx", "x"}, {probe + ".fy", "y"}, {probe + ".fz", "z"}});
    if (!is_zero(force)) plots.push_back(std::move(force));
  }
}

}  // namespace

std::string printed_unit(const std::string& unit) {
  if (unit == "1") return "";
  std::string text;
  for (std::size_t k = 0; k < unit.size(); ++k) {
    if (k > 0 && unit[k] == '2')
      text += "\u00b2";
    else if (k > 0 && unit[k] == '3')
      text += "\u00b3";
    else
      text += unit[k];
  }
  return text;
}

std::vector<Plot> report_plots(const ReportData& data) {
  const Columns columns(data);
  std::vector<Plot> plots = {
      zero_based(columns.plot("Mouth area", "m2",
                              {{"mouth_area", "projected"},
                               {"mouth_vector_area", "vector area"},
                               {"perimeter_area", "perimeter"}})),
      zero_based(columns.plot("Peak tension", "N", {{"peak_tension", "peak tension"}})),
      columns.plot("Energies", "J",
                   {{"kinetic_energy", "kinetic"},
                    {"stretching_energy", "stretching"},
                    {"bending_energy", "bending"},
                    {"gravity_energy", "gravity"}}),
      columns.plot("Energy account since the start", "J",
                   {{"prescribed_work", "prescribed work"},
                    {"material_loss", "material loss"},
                    {"environment_loss", "environment loss"},
                    {"friction_loss", "friction loss"},
                    {"impact_loss", "impact loss"},
                    {"integrator_loss", "integrator loss"}}),
      columns.change(columns.plot("Change of linear momentum", "kg m/s",
                                  {{"momentum_x", "x"}, {"momentum_y", "y"}, {"momentum_z", "z"}})),
      columns.change(columns.plot(
          "Change of angular momentum", "kg m2/s",
          {{"angular_momentum_x", "x"}, {"angular_momentum_y", "y"}, {"angular_momentum_z", "z"}})),
      columns.plot("Smallest distance to a body", "m", {{"smallest_distance", "distance"}}),
      zero_based(columns.plot(kContacts, "1", {{"contacts", "contacts"}})),
      columns.newton(),
  };
  add_probes(columns, plots);
  std::erase_if(plots, [](const Plot& plot) {
    return !has_data(plot) || (plot.title == kContacts && is_zero(plot));
  });
  return plots;
}

}  // namespace retiarius
