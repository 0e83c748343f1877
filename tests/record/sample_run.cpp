#include "tests/record/sample_run.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace retiarius::testing {

SurfacePoint BoxShape::nearest(const Vec3&) const { throw std::logic_error("not needed here"); }

double BoxShape::segment_distance(const Vec3&, const Vec3&) const {
  throw std::logic_error("not needed here");
}

SolidProperties BoxShape::solid() const {
  return {8.0 * half_.prod(), Vec3::Zero(), Mat3::Identity()};
}

double BoxShape::surface_area() const {
  return 8.0 * (half_.x() * half_.y() + half_.y() * half_.z() + half_.z() * half_.x());
}

TriangleMesh BoxShape::triangles() const {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.emplace_back((k & 1 ? 1 : -1) * half_.x(), (k & 2 ? 1 : -1) * half_.y(),
                               (k & 4 ? 1 : -1) * half_.z());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

namespace {

Network square_network(int cells) {
  Network net;
  const int side = cells + 1;
  const double mesh = 2.0 / cells;
  const auto node = [side](int i, int j) { return static_cast<Index>(j * side + i); };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) net.design.emplace_back(i * mesh - 1.0, j * mesh - 1.0, 0.0);
  net.initial = net.design;
  net.velocity.assign(net.design.size(), Vec3::Zero());
  net.mass.assign(net.design.size(), 0.01);
  net.materials.resize(2);
  net.materials[0].radius = 0.001;
  net.materials[1].radius = 0.002;
  const auto add_thread = [&](auto&& node_at, bool perimeter) {
    Thread thread;
    thread.perimeter = perimeter;
    for (int k = 0; k < side; ++k) {
      thread.nodes.push_back(node_at(k));
      if (k == 0) continue;
      thread.segments.push_back(net.segment_count());
      net.segments.push_back({node_at(k - 1), node_at(k), mesh, perimeter ? 1 : 0,
                              static_cast<Index>(net.threads.size())});
    }
    net.threads.push_back(thread);
  };
  for (int j = 0; j < side; ++j)
    add_thread([&](int k) { return node(k, j); }, j == 0 || j == cells);
  for (int i = 0; i < side; ++i)
    add_thread([&](int k) { return node(i, k); }, i == 0 || i == cells);
  net.corners = {node(cells, cells), node(0, cells), node(0, 0), node(cells, 0)};
  net.bullets = net.corners;
  for (int k = 0; k < cells; ++k) net.perimeter.push_back(node(cells - k, cells));
  for (int k = 0; k < cells; ++k) net.perimeter.push_back(node(0, cells - k));
  for (int k = 0; k < cells; ++k) net.perimeter.push_back(node(k, 0));
  for (int k = 0; k < cells; ++k) net.perimeter.push_back(node(cells, k));
  net.center = node(cells / 2, cells / 2);
  return net;
}

}  // namespace

SampleRun::SampleRun(int cells) : network(square_network(cells)) {
  mission.title = "Sample <net> & box";
  mission.seed = 7;
  mission.phases.resize(2);
  mission.phases[0].kind = PhaseKind::shoot;
  mission.phases[0].name = "shoot";
  mission.phases[1].kind = PhaseKind::spread;
  mission.phases[1].name = "spread";
  mission.probes = {{"center", "center", {}}, {"corner0", "corner0", {}}};
  Body box;
  box.name = "target";
  box.shape = std::make_shared<BoxShape>();
  box.kind = ShapeKind::box;
  box.mass = 10.0;
  box.inertia = Mat3::Identity();
  box.initial.position = Vec3(0.1, 0.0, 1.5);
  bodies.push_back(box);
}

RunModel SampleRun::model() const { return {&mission, &network, &bodies, {}, "chose nothing\n"}; }

State SampleRun::state(double time) const {
  State s;
  s.time = time;
  s.step = std::lround(time * 100);
  s.x = network.initial;
  s.v.assign(s.x.size(), Vec3(0.0, 0.0, 1.0));
  for (Vec3& x : s.x) {
    const double r2 = x.head<2>().squaredNorm();
    x.head<2>() *= 0.6 + 0.4 * std::sin(2.0 * time);
    x.z() = time * (1.0 + 0.15 * r2) + 0.05 * std::sin(7.0 * x.x() + 5.0 * time);
  }
  for (const Body& body : bodies) {
    s.bodies.push_back(body.initial);
    s.bodies.back().attitude = Quat(Eigen::AngleAxisd(0.4 * time, Vec3(1, 2, 3).normalized()));
    s.bodies.back().angular_momentum = Vec3(0.1, 0.2, 0.3);
  }
  s.touches.push_back({3, 0, true, Vec3(1.0 / 3.0, -2.0, 0.5)});
  s.support.assign(s.x.size(), Vec3(0.0, 0.125, -1.0 / 7.0));
  s.account.material_loss = 0.1 * time;
  s.account.outside_impulse = Vec3(1, 2, 3) * time;
  return s;
}

HistoryRow SampleRun::row(double time) const {
  HistoryRow r;
  r.time = time;
  r.step = std::lround(time * 100);
  r.phase = time < 0.5 ? 0 : 1;
  const double width = 0.6 + 0.4 * std::sin(2.0 * time);
  r.mouth_area = 4.0 * width * width;
  r.mouth_vector_area = r.mouth_area * 1.01;
  r.mouth_width = std::sqrt(8.0) * width;
  r.perimeter_area = r.mouth_area * 0.97;
  r.kinetic_energy = 50.0 - 3.0 * time;
  r.stretching_energy = 2.0 * std::pow(std::sin(3.0 * time), 2);
  r.bending_energy = 0.1 * time;
  r.material_loss = 0.4 * time;
  r.integrator_loss = 0.2 * time;
  r.momentum = Vec3(1e-13 * time, -2e-13 * time, 12.5);
  r.angular_momentum = Vec3(0.1, 0.2 + 1e-12 * time, 0.3);
  r.peak_tension = 120.0 * std::exp(-time) + 4.0;
  r.peak_strain = 1e-3 * std::exp(-time);
  if (time > 0.25) r.smallest_distance = 1.2 - time / 3.0;
  r.newton_iterations = 4 * r.step;
  r.step_size = 0.01;
  r.probes = {{Vec3(0.1, 1.0 / 3.0, time), Vec3(0, 0, 0)}, {Vec3(1, 1, time), Vec3(-1, 0, 2.5)}};
  return r;
}

Frame SampleRun::frame(const State& state) const {
  Frame f;
  f.phase = state.time < 0.5 ? 0 : 1;
  f.state = &state;
  for (Index k = 0; k < network.segment_count(); ++k) {
    f.tension.push_back(10.0 + k * state.time);
    f.strain.push_back(1e-4 * k);
  }
  f.curvature.assign(network.design.size(), 0.5 + state.time);
  return f;
}

RunReport SampleRun::report(Outcome outcome) const {
  RunReport r;
  r.outcome = outcome;
  if (outcome != Outcome::finished) r.reason = "step at t = 0.3 s does not converge";
  const Measure area{"mouth_area_max", "m2", 4.0};
  r.phases = {{"shoot", PhaseKind::shoot, 0.0, 0.5, "time >= 0.5", {area}},
              {"spread", PhaseKind::spread, 0.5, 2.0, "widest", {}}};
  r.measures = {area,
                {"first_contact_time", "s", {}},
                {"peak_strain", "1", std::nan("")},
                {"closed", "", false},
                {"steps", "1", std::int64_t{200}},
                {"wall_time", "s", 1.5}};
  return r;
}

void SampleRun::feed(Observer& observer, int rows) const {
  observer.begin(model());
  for (int k = 0; k < rows; ++k) {
    observer.history(row(0.1 * k));
    if (k % 2 != 0) continue;
    const State s = state(0.1 * k);
    observer.frame(frame(s));
    Checkpoint saved;
    saved.state = s;
    saved.rows = k + 1;
    saved.frames = k / 2 + 1;
    observer.save(saved, true);
  }
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "retiarius-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("cannot create a temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace retiarius::testing
