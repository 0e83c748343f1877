#include "retiarius/render/quantity.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius::render {

namespace {

constexpr std::size_t kSampledFrames = 16;

double node_value(Quantity quantity, const FrameData& frame, Index node) {
  const auto k = static_cast<std::size_t>(node);
  if (quantity == Quantity::curvature) return frame.curvature.at(k);
  if (quantity == Quantity::speed) return frame.v.at(k).norm();
  return frame.contact.at(k);
}

}  // namespace

const std::vector<std::string>& quantity_names() {
  static const std::vector<std::string> names = {"tension", "strain",  "curvature",
                                                 "speed",   "contact", "none"};
  return names;
}

Quantity quantity_named(const std::string& name) {
  const auto& names = quantity_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError(
        fmt::format("there is no colour {}; there are {}", name, fmt::join(names, ", ")));
  return static_cast<Quantity>(found - names.begin());
}

std::string quantity_title(Quantity quantity) {
  switch (quantity) {
    case Quantity::tension:
      return "Tension (N)";
    case Quantity::strain:
      return "Strain (1)";
    case Quantity::curvature:
      return "Curvature (1/m)";
    case Quantity::speed:
      return "Speed (m/s)";
    case Quantity::contact:
      return "Contact";
    case Quantity::none:
      break;
  }
  return "";
}

std::vector<double> segment_values(Quantity quantity, const NetDrawing& net,
                                   const FrameData& frame) {
  if (quantity == Quantity::none) return {};
  if (quantity == Quantity::tension) return frame.tension;
  if (quantity == Quantity::strain) return frame.strain;
  if (quantity == Quantity::contact && frame.contact.empty())
    throw InputError("this run's recording has no contact; choose another colour");
  std::vector<double> values;
  values.reserve(net.segments.size());
  for (const auto& [a, b] : net.segments) {
    const double x = node_value(quantity, frame, a), y = node_value(quantity, frame, b);
    values.push_back(quantity == Quantity::contact ? std::max(x, y) : 0.5 * (x + y));
  }
  return values;
}

double rounded_up(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (step * power >= value * (1.0 - 1e-9)) return step * power;
  return 10.0 * power;
}

double usual_range(Quantity quantity, const NetDrawing& net, const RunFile& run) {
  if (quantity == Quantity::none || quantity == Quantity::contact) return 2.0;
  std::vector<double> values;
  const std::size_t count = run.frame_count(), samples = std::min(count, kSampledFrames);
  for (std::size_t k = 0; k < samples; ++k) {
    const FrameData frame = run.frame(samples < 2 ? 0 : k * (count - 1) / (samples - 1));
    for (double value : segment_values(quantity, net, frame))
      if (value > 0.0) values.push_back(value);
  }
  if (values.empty()) return 1.0;
  const auto place = static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return rounded_up(values[static_cast<std::size_t>(place)]);
}

Colour value_colour(Quantity quantity, double value, double high) {
  if (quantity == Quantity::none) return kThread;
  if (quantity == Quantity::contact) return contact_colour(static_cast<int>(value));
  return scale_colour(value / high);
}

}  // namespace retiarius::render
