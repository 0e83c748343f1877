// A small hand-made run for the tests of record/ and report/: a square net of threads that flies
// at a tumbling box, with every kind of value that observers have to write.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "retiarius/mission/observer.hpp"

namespace retiarius::testing {

// A box of edges 1 m, 0.6 m, 0.4 m; only what files and pictures need of it is defined.
class BoxShape : public Shape {
 public:
  SurfacePoint nearest(const Vec3& point) const override;
  double segment_distance(const Vec3& a, const Vec3& b) const override;
  double bounding_radius() const override { return half_.norm(); }
  SolidProperties solid() const override;
  double surface_area() const override;
  TriangleMesh triangles() const override;

 private:
  Vec3 half_{0.5, 0.3, 0.2};
};

// Mission, network (cells x cells square mesh of side 2 m) and bodies that live together.
struct SampleRun {
  explicit SampleRun(int cells = 4);

  RunModel model() const;
  State state(double time) const;
  HistoryRow row(double time) const;
  Frame frame(const State& state) const;
  RunReport report(Outcome outcome = Outcome::finished) const;

  // Feeds an observer with begin, rows at k * 0.1 s, frames at every second row, no end.
  void feed(Observer& observer, int rows) const;

  Mission mission;
  Network network;
  std::vector<Body> bodies;
};

// An empty folder that is removed at the end of the test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

// The text of the exception that the call throws; fails the test when it throws none of type E.
template <class E, class Call>
std::string error_text(Call&& call) {
  try {
    call();
  } catch (const E& error) {
    return error.what();
  }
  throw std::logic_error("expected an exception, none was thrown");
}

}  // namespace retiarius::testing
