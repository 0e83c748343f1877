// The net is one mesh with a skin whose joints are the nodes, each with an animated translation and
// nothing else; segments are the hulls that an octahedron sweeps from one node to the other, so no
// turning has to be recorded. That takes 12 bytes a node and frame and one draw call. Morph targets
// would take as much for bare lines, six times that for tubes, and viewers bound their number;
// a glTF node for each segment would take 40 bytes a segment and frame and thousands of draw calls.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/export_run.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/glb.hpp"
#include "retiarius/record/run_file.hpp"

namespace retiarius {

namespace {

using Json = GlbBuffer::Json;

constexpr std::size_t kMostNodes = 65535;                // a skin's joints have 16-bit numbers
constexpr double kMotionBytes = 64.0 * 1024.0 * 1024.0;  // of the net's motion at most
constexpr double kThinnest = 1.0 / 2400.0;               // radius of threads, in sizes of the net

const std::array<Vec3, 6> kOctahedron = {Vec3(1, 0, 0),  Vec3(-1, 0, 0), Vec3(0, 1, 0),
                                         Vec3(0, -1, 0), Vec3(0, 0, 1),  Vec3(0, 0, -1)};

void put(std::vector<float>& numbers, const Vec3& v) {
  for (double c : v) numbers.push_back(static_cast<float>(c));
}

class Scene {
 public:
  Scene(const RunFile& run, std::size_t most_bytes) : run_(run), net_(run.net()) {
    choose_frames(most_bytes);
    nodes_.push_back({{"name", run.title().empty() ? "run" : run.title()},
                      // z is up in the run, y in glTF.
                      {"rotation", {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}},
                      {"children", Json::array()}});
    add_materials();
    add_net();
    add_balls();
    add_bodies();
  }

  std::size_t frames() const { return frames_.size(); }

  std::string file() {
    Json document = {
        {"asset", {{"version", "2.0"}, {"generator", "retiarius"}}},
        {"scene", 0},
        {"scenes", Json::array({{{"nodes", Json::array({0, net_node_})}}})},
        {"nodes", nodes_},
        {"meshes", meshes_},
        {"materials", materials_},
        {"skins", skins_},
        {"animations",
         Json::array({{{"name", "run"}, {"channels", channels_}, {"samplers", samplers_}}})}};
    return buffer_.file(std::move(document));
  }

 private:
  void choose_frames(std::size_t most_bytes) {
    const std::vector<double> times = run_.frame_times();
    if (times.empty()) throw InputError("the run holds no frame: there is nothing to export");
    const std::size_t nodes = net_.radius.size();
    if (nodes > kMostNodes)
      throw InputError(
          fmt::format("a .glb holds nets of at most {} nodes, this one has {}; "
                      "export --to vtk",
                      kMostNodes, nodes));
    const double all = 12.0 * static_cast<double>(nodes) * static_cast<double>(times.size());
    const auto stride =
        static_cast<std::size_t>(std::max(1.0, std::ceil(all / static_cast<double>(most_bytes))));
    std::vector<float> seconds;
    for (std::size_t k = 0; k < times.size(); ++k) {
      if (k % stride != 0 && k + 1 != times.size()) continue;
      const auto time = static_cast<float>(times[k]);
      if (!seconds.empty() && !(time > seconds.back())) continue;
      seconds.push_back(time);
      frames_.push_back(run_.frame(k));
    }
    time_ = buffer_.add(seconds, "SCALAR", GlbUse::other, true);
    for (const FrameData& frame : frames_) {
      Vec3 a = frame.x[0], b = a;
      for (const Vec3& x : frame.x) a = a.cwiseMin(x), b = b.cwiseMax(x);
      size_ = std::max(size_, (b - a).maxCoeff());
    }
  }

  void add_materials() {
    const auto material = [&](const char* name, std::array<double, 3> colour, double metallic,
                              double roughness, bool both_sides) {
      Json entry = {{"name", name},
                    {"pbrMetallicRoughness",
                     {{"baseColorFactor", {colour[0], colour[1], colour[2], 1.0}},
                      {"metallicFactor", metallic},
                      {"roughnessFactor", roughness}}}};
      if (both_sides) entry["doubleSided"] = true;
      materials_.push_back(std::move(entry));
    };
    material("thread", {0.09, 0.16, 0.27}, 0.0, 0.55, true);
    material("steel", {0.45, 0.47, 0.50}, 1.0, 0.35, false);
    material("body", {0.62, 0.56, 0.44}, 0.25, 0.6, true);
  }

  void animate(int node, const char* path, const std::vector<float>& values, const char* type) {
    const int output = buffer_.add(values, type, GlbUse::other);
    channels_.push_back(
        {{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers_.push_back({{"input", time_}, {"output", output}, {"interpolation", "LINEAR"}});
  }

  int add_node(Json node, bool below_root) {
    nodes_.push_back(std::move(node));
    const int number = static_cast<int>(nodes_.size()) - 1;
    if (below_root) nodes_[0]["children"].push_back(number);
    return number;
  }

  // The mesh as it lies in the first frame, so that a viewer without skins shows that.
  int add_net_mesh() {
    std::vector<float> positions, normals;
    std::vector<std::uint16_t> joints;
    std::vector<std::uint8_t> weights;
    for (std::size_t k = 0; k < net_.radius.size(); ++k)
      for (const Vec3& direction : kOctahedron) {
        put(positions, frames_[0].x[k] + radius(k) * direction);
        put(normals, direction);
        joints.insert(joints.end(), {static_cast<std::uint16_t>(k), 0, 0, 0});
        weights.insert(weights.end(), {255, 0, 0, 0});
      }
    std::vector<std::uint32_t> indices;
    for (const auto& [a, b] : net_.segments)
      for (std::uint32_t p = 0; p < 6; ++p)
        for (std::uint32_t q = p + 1; q < 6; ++q) {
          if (q == p + 1 && p % 2 == 0) continue;  // opposite corners have no edge
          const auto i = 6 * static_cast<std::uint32_t>(a), j = 6 * static_cast<std::uint32_t>(b);
          indices.insert(indices.end(), {i + p, i + q, j + q, i + p, j + q, j + p});
        }
    const int position = buffer_.add(positions, "VEC3", GlbUse::vertices, true);
    const int normal = buffer_.add(normals, "VEC3", GlbUse::vertices);
    const int joint = buffer_.add(joints, "VEC4", GlbUse::vertices);
    const int weight = buffer_.add_normalized(weights, "VEC4", GlbUse::vertices);
    return add_mesh(
        "net",
        {{"POSITION", position}, {"NORMAL", normal}, {"JOINTS_0", joint}, {"WEIGHTS_0", weight}},
        buffer_.add(indices, GlbUse::indices), 0);
  }

  int add_mesh(const std::string& name, Json attributes, int indices, int material) {
    meshes_.push_back({{"name", name},
                       {"primitives", Json::array({{{"attributes", std::move(attributes)},
                                                    {"indices", indices},
                                                    {"material", material}}})}});
    return static_cast<int>(meshes_.size()) - 1;
  }

  void add_net() {
    std::vector<float> inverse_bind;
    Json joints = Json::array();
    for (std::size_t k = 0; k < net_.radius.size(); ++k) {
      const Vec3& x = frames_[0].x[k];
      const int node = add_node({{"translation", {x.x(), x.y(), x.z()}}}, true);
      if (k == 0) first_joint_ = node;
      joints.push_back(node);
      inverse_bind.insert(inverse_bind.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
      put(inverse_bind, -x);
      inverse_bind.push_back(1);
      std::vector<float> motion;
      for (const FrameData& frame : frames_) put(motion, frame.x[k]);
      animate(node, "translation", motion, "VEC3");
    }
    const int bind = buffer_.add(inverse_bind, "MAT4", GlbUse::other);
    skins_.push_back({{"inverseBindMatrices", bind}, {"joints", joints}, {"skeleton", 0}});
    net_node_ = add_node({{"name", "net"}, {"mesh", add_net_mesh()}, {"skin", 0}}, false);
  }

  int add_ball_mesh() {
    constexpr int kRound = 16, kRings = 8;
    std::vector<float> points;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i <= kRings; ++i)
      for (int j = 0; j <= kRound; ++j) {
        const double polar = kPi * i / kRings, around = 2.0 * kPi * j / kRound;
        put(points, Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                         std::cos(polar)));
        if (i == kRings || j == kRound) continue;
        const auto a = static_cast<std::uint32_t>(i * (kRound + 1) + j), b = a + kRound + 1;
        if (i > 0) indices.insert(indices.end(), {a, b, a + 1});
        if (i + 1 < kRings) indices.insert(indices.end(), {a + 1, b, b + 1});
      }
    // A unit sphere's points are its normals.
    const int position = buffer_.add(points, "VEC3", GlbUse::vertices, true);
    const int normal = buffer_.add(points, "VEC3", GlbUse::vertices);
    return add_mesh("corner mass", {{"POSITION", position}, {"NORMAL", normal}},
                    buffer_.add(indices, GlbUse::indices), 1);
  }

  // Corner masses ride on the joints of their nodes.
  void add_balls() {
    const std::vector<Ball> balls = run_.balls();
    if (balls.empty()) return;
    const int mesh = add_ball_mesh();
    for (const Ball& ball : balls) {
      const double r = std::max(ball.radius, 3.0 * kThinnest * size_);
      const int node =
          add_node({{"name", "corner mass"}, {"mesh", mesh}, {"scale", {r, r, r}}}, false);
      nodes_[static_cast<std::size_t>(first_joint_ + ball.node)]["children"] = {node};
    }
  }

  void add_bodies() {
    const std::vector<BodyDrawing> bodies = run_.bodies();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      std::vector<float> points;
      std::vector<std::uint32_t> indices;
      for (const Vec3& x : bodies[k].mesh.vertices) put(points, x);
      for (const auto& triangle : bodies[k].mesh.triangles)
        for (Index corner : triangle) indices.push_back(static_cast<std::uint32_t>(corner));
      // Without normals a viewer shades the triangles flat, as glTF demands.
      const int position = buffer_.add(points, "VEC3", GlbUse::vertices, true);
      const int mesh = add_mesh(bodies[k].name, {{"POSITION", position}},
                                buffer_.add(indices, GlbUse::indices), 2);
      animate_body(k, add_node({{"name", bodies[k].name}, {"mesh", mesh}}, true));
    }
  }

  void animate_body(std::size_t body, int node) {
    std::vector<float> places, turns;
    Quat last = Quat::Identity();
    for (const FrameData& frame : frames_) {
      const BodyState& state = frame.bodies.at(body);
      put(places, state.position);
      Quat q = state.attitude.normalized();
      if (q.dot(last) < 0.0) q.coeffs() *= -1.0;  // viewers then turn the short way
      for (double c : q.coeffs()) turns.push_back(static_cast<float>(c));
      last = q;
    }
    Json& entry = nodes_[static_cast<std::size_t>(node)];
    entry["translation"] = std::vector<float>(places.begin(), places.begin() + 3);
    entry["rotation"] = std::vector<float>(turns.begin(), turns.begin() + 4);
    animate(node, "translation", places, "VEC3");
    animate(node, "rotation", turns, "VEC4");
  }

  double radius(std::size_t node) const {
    return std::max<double>(net_.radius[node], kThinnest * size_);
  }

  const RunFile& run_;
  NetDrawing net_;
  std::vector<FrameData> frames_;
  double size_ = 0.0;  // largest extent of the net in any frame, m
  GlbBuffer buffer_;
  int time_ = -1, first_joint_ = -1, net_node_ = -1;
  Json nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array(),
       skins_ = Json::array(), channels_ = Json::array(), samplers_ = Json::array();
};

}  // namespace

GlbReport export_glb(const std::filesystem::path& run, const std::filesystem::path& out,
                     std::size_t most_bytes) {
  const RunFile file(run / "run.h5");
  Scene scene(file, most_bytes > 0 ? most_bytes : static_cast<std::size_t>(kMotionBytes));
  write_atomically(out, scene.file());
  return {scene.frames(), file.frame_count()};
}

}  // namespace retiarius
