#include "retiarius/report/report_recorder.hpp"

#include <algorithm>

#include "retiarius/record/file.hpp"
#include "retiarius/record/history_csv.hpp"
#include "retiarius/report/report_page.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kPictures = 6;

// Of the pictures not yet taken, the one farthest in time from all that are.
std::size_t loneliest(const std::vector<Picture>& pictures, const std::vector<bool>& taken) {
  std::size_t best = pictures.size();
  double best_gap = -1.0;
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    if (taken[k]) continue;
    double gap = kInfinity;
    for (std::size_t j = 0; j < pictures.size(); ++j)
      if (taken[j]) gap = std::min(gap, std::abs(pictures[j].time - pictures[k].time));
    if (gap > best_gap) {
      best = k;
      best_gap = gap;
    }
  }
  return best;
}

}  // namespace

std::vector<Picture> chosen_pictures(std::vector<Picture> pictures, std::size_t count) {
  std::stable_sort(pictures.begin(), pictures.end(),
                   [](const Picture& a, const Picture& b) { return a.time < b.time; });
  if (pictures.size() <= count || count == 0) return pictures;
  std::vector<bool> taken(pictures.size(), false);
  std::size_t left = count;
  const auto take = [&](std::size_t k) {
    if (taken[k] || left == 0) return;
    taken[k] = true;
    --left;
  };
  take(0);
  take(pictures.size() - 1);
  for (std::size_t k = 0; k + 1 < pictures.size(); ++k)
    if (pictures[k].phase != pictures[k + 1].phase) take(k);
  while (left > 0) take(loneliest(pictures, taken));
  std::vector<Picture> chosen;
  for (std::size_t k = 0; k < pictures.size(); ++k)
    if (taken[k]) chosen.push_back(std::move(pictures[k]));
  return chosen;
}

void Pictures::add(Picture picture) {
  if (phase_ends_.empty() || phase_ends_.back().phase != picture.phase)
    phase_ends_.push_back(picture);
  else
    phase_ends_.back() = picture;
  thinned_.add(std::move(picture));
}

std::vector<Picture> Pictures::chosen() const {
  std::vector<Picture> all = thinned_.items();
  for (const Picture& end : phase_ends_)
    if (std::none_of(all.begin(), all.end(), [&](const Picture& p) { return p.time == end.time; }))
      all.push_back(end);
  return chosen_pictures(std::move(all), kPictures);
}

ReportRecorder::ReportRecorder(const std::filesystem::path& folder, std::string resolved,
                               BuildInfo build)
    : path_(folder / "report.html") {
  data_.resolved = std::move(resolved);
  data_.build = std::move(build);
}

void ReportRecorder::begin(const RunModel& model) {
  data_.title = model.mission->title;
  data_.seed = model.mission->seed;
  data_.start_report = model.start_report;
  data_.columns = history_header(*model.mission);
  data_.scene =
      make_scene(net_drawing(*model.network), model.network->perimeter, body_drawings(model));
}

void ReportRecorder::history(const HistoryRow& row) {
  last_row_ = history_values(row);
  rows_.add(last_row_);
}

void ReportRecorder::frame(const Frame& frame) {
  const State& s = *frame.state;
  pictures_.add(make_picture(data_.scene, s.time, frame.phase, s.x, s.bodies));
}

void ReportRecorder::end(const RunReport& report) {
  data_.run = report;
  data_.rows = rows_.items();
  if (!data_.rows.empty() && data_.rows.back()[0] != last_row_[0]) data_.rows.push_back(last_row_);
  data_.pictures = pictures_.chosen();
  write_atomically(path_, report_page(path_.parent_path(), data_));
}

}  // namespace retiarius
