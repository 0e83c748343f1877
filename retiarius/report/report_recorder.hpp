// The observer that writes report.html when a run ends.
#pragma once

#include <filesystem>

#include "retiarius/mission/observer.hpp"
#include "retiarius/report/report_data.hpp"

namespace retiarius {

// Rows and pictures kept while a run goes on, in bounded memory: when there are too many, every
// second is dropped and from then on only every second is kept, and so on.
template <class T>
class Thinned {
 public:
  explicit Thinned(std::size_t limit) : limit_(limit) {}

  void add(T item) {
    if (count_++ % stride_ != 0) return;
    items_.push_back(std::move(item));
    if (items_.size() <= limit_) return;
    for (std::size_t k = 1; 2 * k < items_.size(); ++k) items_[k] = std::move(items_[2 * k]);
    items_.resize((items_.size() + 1) / 2);
    stride_ *= 2;
  }
  const std::vector<T>& items() const { return items_; }

 private:
  std::size_t limit_, stride_ = 1, count_ = 0;
  std::vector<T> items_;
};

// Up to `count` of the pictures, in order of time: the first and the last, the last of each phase,
// then whatever fills the largest gap in time.
std::vector<Picture> chosen_pictures(std::vector<Picture> pictures, std::size_t count);

// Pictures of a whole run in bounded memory, of which a few are chosen in the end.
class Pictures {
 public:
  void add(Picture picture);
  std::vector<Picture> chosen() const;  // six, or fewer in a short run

 private:
  Thinned<Picture> thinned_{32};
  std::vector<Picture> phase_ends_;  // the latest picture of each phase
};

// Gathers what the report shows and writes the page at the end, whatever the outcome: with the 3D
// replay where the viewer is built in and the folder has a recording.
class ReportRecorder : public Observer {
 public:
  ReportRecorder(const std::filesystem::path& folder, std::string resolved, BuildInfo build);

  void begin(const RunModel& model) override;
  void history(const HistoryRow& row) override;
  void frame(const Frame& frame) override;
  void end(const RunReport& report) override;

 private:
  std::filesystem::path path_;
  ReportData data_;
  Thinned<std::vector<double>> rows_{8192};
  std::vector<double> last_row_;
  Pictures pictures_;
};

}  // namespace retiarius
