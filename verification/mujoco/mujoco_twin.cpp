#include "verification/mujoco/mujoco_twin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius::verification {

namespace {

std::string node_xml(Index i, const Vec3& x, double mass, double damping, bool held) {
  const std::string site = fmt::format("<site name=\"s{}\" size=\"0.001\"/>", i);
  std::string xml = fmt::format("<body pos=\"{:.17g} {:.17g} {:.17g}\">", x.x(), x.y(), x.z());
  if (!held) {
    for (const char* axis : {"1 0 0", "0 1 0", "0 0 1"})
      xml += fmt::format("<joint type=\"slide\" axis=\"{}\" damping=\"{:.17g}\"/>", axis,
                         damping * mass);
    // It does not turn, so its inertia does not matter; MuJoCo wants one.
    xml += fmt::format(
        "<inertial pos=\"0 0 0\" mass=\"{0:.17g}\" "
        "diaginertia=\"{0:.17g} {0:.17g} {0:.17g}\"/>",
        mass);
  }
  return xml + site + "</body>";
}

std::string model_xml(const Network& net, const std::vector<Index>& held,
                      const TwinOptions& options) {
  const Vec3& g = options.gravity;
  std::string xml = fmt::format(
      "<mujoco><option timestep=\"{:.17g}\" gravity=\"{:.17g} {:.17g} {:.17g}\" "
      "integrator=\"{}\" jacobian=\"sparse\"><flag contact=\"disable\" constraint=\"disable\"/>"
      "</option><worldbody>",
      options.step, g.x(), g.y(), g.z(), options.runge_kutta ? "RK4" : "Euler");
  for (Index i = 0; i < net.node_count(); ++i)
    xml += node_xml(i, net.initial[i], net.mass[i], options.damping,
                    std::find(held.begin(), held.end(), i) != held.end());
  xml += "</worldbody><tendon>";
  for (const Segment& e : net.segments)
    xml += fmt::format(
        "<spatial stiffness=\"{:.17g}\" springlength=\"{:.17g}\"><site site=\"s{}\"/>"
        "<site site=\"s{}\"/></spatial>",
        net.materials[e.material].axial_stiffness / e.rest_length, e.rest_length, e.a, e.b);
  return xml + "</tendon></mujoco>";
}

mjModel* load(const std::string& xml) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "twin.xml", static_cast<int>(xml.size()));
  std::memcpy(files->filedata[0], xml.data(), xml.size());
  std::array<char, 500> message{};
  mjModel* model = mj_loadXML("twin.xml", files.get(), message.data(), message.size());
  mj_deleteVFS(files.get());
  if (!model) throw Error(fmt::format("MuJoCo refuses the model: {}", message.data()));
  return model;
}

}  // namespace

MujocoTwin::MujocoTwin(const Network& network, const std::vector<Index>& held,
                       const TwinOptions& options)
    : start_(network.initial), model_(load(model_xml(network, held, options))) {
  data_.reset(mj_makeData(model_.get()));
  int next = 0;
  for (Index i = 0; i < network.node_count(); ++i) {
    const bool fixed = std::find(held.begin(), held.end(), i) != held.end();
    coordinate_.push_back(fixed ? -1 : next);
    if (!fixed) next += 3;
  }
  if (next != model_->nv) throw Error("MuJoCo has another number of unknowns than the network");
}

void MujocoTwin::step() { mj_step(model_.get(), data_.get()); }

Vec3 MujocoTwin::position(Index node) const {
  const int k = coordinate_[node];
  if (k < 0) return start_[node];
  return start_[node] + Vec3(data_->qpos[k], data_->qpos[k + 1], data_->qpos[k + 2]);
}

double MujocoTwin::largest_speed() const {
  double largest = 0.0;
  for (int k = 0; k < model_->nv; ++k) largest = std::max(largest, std::abs(data_->qvel[k]));
  return largest;
}

}  // namespace retiarius::verification
