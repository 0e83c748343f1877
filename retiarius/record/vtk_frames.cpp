#include "retiarius/record/vtk_frames.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/body_mesh.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius {

namespace {

VtpArray scalar_array(const char* name, const std::vector<double>& values) {
  return {name, 1, {values.begin(), values.end()}};
}

VtpArray vector_array(const char* name, const std::vector<Vec3>& values) {
  VtpArray array{name, 3, {}};
  array.values.reserve(3 * values.size());
  for (const Vec3& v : values)
    for (double c : v) array.values.push_back(static_cast<float>(c));
  return array;
}

void create_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RunError(fmt::format("cannot create {}: {}", folder.string(), error.message()));
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.close();
}

}  // namespace

NetDrawing net_drawing(const Network& network) {
  NetDrawing drawing;
  drawing.radius.assign(network.design.size(), 0.0f);
  for (const Segment& s : network.segments) {
    drawing.segments.push_back({s.a, s.b});
    drawing.material.push_back(static_cast<float>(s.material));
    drawing.thread.push_back(static_cast<float>(s.thread));
    const auto radius =
        static_cast<float>(network.materials[static_cast<std::size_t>(s.material)].radius);
    for (Index node : {s.a, s.b}) {
      float& r = drawing.radius[static_cast<std::size_t>(node)];
      r = std::max(r, radius);
    }
  }
  return drawing;
}

std::vector<BodyDrawing> body_drawings(const RunModel& model) {
  std::vector<BodyDrawing> drawings;
  for (const Body& body : *model.bodies)
    drawings.push_back({body.name, drawn_mesh(body, *model.network)});
  return drawings;
}

std::vector<Index> contact_of_nodes(const State& state) {
  std::vector<Index> contact(state.x.size(), 0);
  for (const Touch& touch : state.touches)
    contact.at(static_cast<std::size_t>(touch.node)) = touch.sticks ? 2 : 1;
  return contact;
}

FrameData frame_data(const Frame& frame) {
  const State& s = *frame.state;
  return {s.time,
          frame.phase,
          s.x,
          s.v,
          frame.tension,
          frame.strain,
          frame.curvature,
          s.bodies,
          contact_of_nodes(s),
          frame.contacts};
}

VtkSeries::VtkSeries(std::filesystem::path folder, NetDrawing net, std::vector<BodyDrawing> bodies)
    : folder_(std::move(folder)), net_(std::move(net)), bodies_(std::move(bodies)) {
  create_folder(folder_ / "frames");
  write_atomically(folder_ / "frames.pvd", pvd_text({}));
}

void VtkSeries::add(const FrameData& frame) {
  const int number = frames_++;
  write_net(frame, number);
  for (std::size_t k = 0; k < bodies_.size(); ++k) write_body(frame, k, number);
  if (frames_ - listed_ >= std::max(1, frames_ / 64)) finish();
}

void VtkSeries::finish() {
  if (listed_ == frames_) return;
  write_atomically(folder_ / "frames.pvd", pvd_text(entries_));
  listed_ = frames_;
}

void VtkSeries::write_net(const FrameData& frame, int number) {
  PolyData data;
  data.time = frame.time;
  data.points = &frame.x;
  data.lines = net_.segments;
  data.point_data = {{"radius", 1, net_.radius},
                     vector_array("velocity", frame.v),
                     scalar_array("curvature", frame.curvature)};
  data.cell_data = {scalar_array("tension", frame.tension), scalar_array("strain", frame.strain),
                    VtpArray{"material", 1, net_.material}, VtpArray{"thread", 1, net_.thread}};
  const std::string name = fmt::format("frames/frame_{:06}.vtp", number);
  write_file(folder_ / name, vtp_text(data));
  entries_.push_back({frame.time, 0, name});
}

void VtkSeries::write_body(const FrameData& frame, std::size_t body, int number) {
  const BodyDrawing& drawing = bodies_[body];
  std::vector<Vec3> posed;
  for (const Vec3& x : drawing.mesh.vertices) posed.push_back(to_world(frame.bodies.at(body), x));
  PolyData data;
  data.time = frame.time;
  data.points = &posed;
  data.triangles = drawing.mesh.triangles;
  const std::string name =
      fmt::format("frames/body_{}_{:06}.vtp", file_name_of(drawing.name), number);
  write_file(folder_ / name, vtp_text(data));
  entries_.push_back({frame.time, static_cast<int>(body) + 1, name});
}

void VtkFrames::begin(const RunModel& model) {
  series_.clear();
  series_.emplace_back(folder_, net_drawing(*model.network), body_drawings(model));
}

void VtkFrames::frame(const Frame& frame) { series_.at(0).add(frame_data(frame)); }

void VtkSeries::remove_later_frames() {
  constexpr std::size_t kTail = 10;  // "000000.vtp"
  std::vector<std::filesystem::path> later;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "frames")) {
    const std::string name = entry.path().filename().string();
    int number = -1;
    if (name.size() <= kTail) continue;
    const char* digits = name.data() + name.size() - kTail;
    if (std::from_chars(digits, digits + 6, number).ptr == digits + 6 && number >= frames_)
      later.push_back(entry.path());
  }
  std::error_code ignored;
  for (const auto& path : later) std::filesystem::remove(path, ignored);
}

void VtkFrames::resumed() { series_.at(0).remove_later_frames(); }

void VtkFrames::end(const RunReport&) {
  if (!series_.empty()) series_[0].finish();
}

}  // namespace retiarius
