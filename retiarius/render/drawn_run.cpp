#include "retiarius/render/drawn_run.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/report/read_report.hpp"

namespace retiarius::render {

namespace {

std::vector<bool> border_of(const NetDrawing& net, const std::vector<Index>& perimeter) {
  std::set<std::pair<Index, Index>> pairs;
  for (std::size_t k = 0; k < perimeter.size(); ++k) {
    const Index a = perimeter[k], b = perimeter[(k + 1) % perimeter.size()];
    pairs.insert(std::minmax(a, b));
  }
  std::vector<bool> border;
  for (const auto& [a, b] : net.segments) border.push_back(pairs.count(std::minmax(a, b)) > 0);
  return border;
}

}  // namespace

DrawnRun::DrawnRun(const std::filesystem::path& folder)
    : file(folder / "run.h5"),
      net(file.net()),
      border(border_of(net, file.perimeter())),
      bodies(file.bodies()),
      balls(file.balls()),
      title(file.title()),
      times(file.frame_times()) {
  if (times.empty())
    throw InputError(
        fmt::format("{} holds no frame: there is nothing to draw", (folder / "run.h5").string()));
  if (std::filesystem::exists(folder / "summary.json")) report = read_outcome(folder).run;
}

std::size_t DrawnRun::frame_at(double time) const {
  std::size_t best = 0;
  for (std::size_t k = 1; k < times.size(); ++k)
    if (std::abs(times[k] - time) < std::abs(times[best] - time)) best = k;
  const double interval =
      times.size() < 2 ? 1.0 : (times.back() - times.front()) / static_cast<double>(times.size());
  if (!(std::abs(times[best] - time) <= std::max(interval, 1e-9)))
    throw InputError(
        fmt::format("there is no frame at {:g} s: the recording has {} from {:g} to "
                    "{:g} s",
                    time, times.size() == 1 ? "one" : "frames", times.front(), times.back()));
  return best;
}

std::string DrawnRun::phase_name(Index phase) const {
  const auto k = static_cast<std::size_t>(phase);
  if (k < report.phases.size()) return report.phases[k].name;
  return fmt::format("phase {}", k + 1);
}

bool shows_bodies(const DrawnRun& run, Index phase) {
  const auto k = static_cast<std::size_t>(phase);
  return k >= run.report.phases.size() || run.report.phases[k].kind != PhaseKind::fold;
}

void add_points(const DrawnRun& run, const FrameData& frame, bool bodies,
                std::vector<Vec3>& points) {
  points.insert(points.end(), frame.x.begin(), frame.x.end());
  for (std::size_t k = 0; k < run.bodies.size() && bodies; ++k)
    for (const Vec3& x : run.bodies[k].mesh.vertices)
      points.push_back(to_world(frame.bodies.at(k), x));
}

}  // namespace retiarius::render
