#include "retiarius/record/replay_header.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "retiarius/base/error.hpp"
#include "retiarius/record/body_mesh.hpp"
#include "retiarius/record/replay_chunk.hpp"
#include "retiarius/record/summary_json.hpp"

namespace retiarius {

namespace {

using Json = nlohmann::ordered_json;

double net_size(const Network& net) {
  if (net.design.empty()) return 1.0;
  Vec3 low = net.design[0], high = low;
  for (const Vec3& x : net.design) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double size = (high - low).maxCoeff();
  return size > 0.0 ? size : 1.0;
}

double largest_stiffness(const Network& net) {
  double stiffness = 0.0;
  for (const Material& m : net.materials) stiffness = std::max(stiffness, m.axial_stiffness);
  return stiffness > 0.0 ? stiffness : 1.0;
}

// The arrays and their description.
class Arrays {
 public:
  template <class T>
  void add(const std::string& name, const char* type, const std::vector<T>& numbers,
           std::size_t width = 1) {
    Json shape = Json::array({numbers.size() / width});
    if (width > 1) shape.push_back(width);
    list_.push_back({{"name", name}, {"type", type}, {"shape", shape}});
    append_bytes(bytes_, numbers);
  }
  const Json& list() const { return list_; }
  const std::string& bytes() const { return bytes_; }

 private:
  Json list_ = Json::array();
  std::string bytes_;
};

std::vector<std::uint32_t> unsigned_of(const std::vector<Index>& list) {
  return {list.begin(), list.end()};
}

void add_net(const Network& net, Arrays& arrays) {
  std::vector<std::uint32_t> segments, material;
  std::vector<double> rest;
  for (const Segment& s : net.segments) {
    segments.push_back(static_cast<std::uint32_t>(s.a));
    segments.push_back(static_cast<std::uint32_t>(s.b));
    material.push_back(static_cast<std::uint32_t>(s.material));
    rest.push_back(s.rest_length);
  }
  arrays.add("segments", "u32", segments, 2);
  arrays.add("material", "u32", material);
  arrays.add("rest_length", "f64", rest);
  arrays.add("mass", "f64", net.mass);
  arrays.add("knots", "u32", unsigned_of(net.knots));
  arrays.add("perimeter", "u32", unsigned_of(net.perimeter));
}

void add_bodies(const RunModel& model, Arrays& arrays) {
  for (std::size_t k = 0; k < model.bodies->size(); ++k) {
    const TriangleMesh mesh = drawn_mesh((*model.bodies)[k], *model.network);
    std::vector<float> vertices;
    std::vector<std::uint32_t> triangles;
    for (const Vec3& x : mesh.vertices)
      for (double c : x) vertices.push_back(static_cast<float>(c));
    for (const auto& t : mesh.triangles)
      for (Index node : t) triangles.push_back(static_cast<std::uint32_t>(node));
    arrays.add(fmt::format("body{}.vertices", k), "f32", vertices, 3);
    arrays.add(fmt::format("body{}.triangles", k), "u32", triangles, 3);
  }
}

Json channel(const char* name, const char* unit, const char* on, const Minifloat& scale) {
  return {{"name", name},
          {"unit", unit},
          {"on", on},
          {"quantum", scale.quantum},
          {"steps", scale.steps}};
}

Json channels(const ReplayScales& scales) {
  return {channel("tension", "N", "segment", scales.tension),
          channel("strain", "1", "segment", scales.strain),
          channel("curvature", "1/m", "node", scales.curvature),
          channel("speed", "m/s", "node", scales.speed)};
}

Json materials(const Network& net) {
  Json list = Json::array();
  for (const Material& m : net.materials)
    list.push_back({{"radius", m.radius},
                    {"axial_stiffness", m.axial_stiffness},
                    {"line_density", m.line_density}});
  return list;
}

Json bullets(const Network& net) {
  Json list = Json::array();
  for (Index node : net.bullets) {
    const double mass = net.mass[static_cast<std::size_t>(node)];
    list.push_back({{"node", node}, {"mass", mass}, {"radius", steel_ball_radius(mass)}});
  }
  return list;
}

// A count; what is no integer or below 0 would be converted to nonsense.
std::size_t count_at(const Json& object, const char* key) {
  const Json& value = object.at(key);
  if (!value.is_number_unsigned())
    throw InputError(fmt::format("the recording is damaged: {} is no count", key));
  return value.get<std::size_t>();
}

double quantum_at(const Json& object) {
  const double quantum = object.at("quantum").get<double>();
  if (!(quantum > 0.0 && std::isfinite(quantum)))
    throw InputError("the recording is damaged: a quantity without scale");
  return quantum;
}

Minifloat scale_of(const Json& channel) {
  constexpr std::size_t kMostSteps = 1u << 20;
  const std::size_t steps = count_at(channel, "steps");
  if (steps < 1 || steps > kMostSteps)
    throw InputError("the recording is damaged: a channel without scale");
  return {quantum_at(channel), static_cast<std::int32_t>(steps)};
}

template <class T>
T number_at(const std::string& bytes, std::size_t place) {
  T number{};
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

// The arrays begin with the segments' ends, materials and rest lengths.
void read_segments(const std::string& arrays, std::size_t count, const Json& materials,
                   ReplayShape& shape) {
  if (arrays.size() / 20 < count) throw InputError("the recording is damaged: short arrays");
  for (std::size_t k = 0; k < count; ++k) {
    shape.ends.push_back({number_at<Index>(arrays, 8 * k), number_at<Index>(arrays, 8 * k + 4)});
    for (Index node : shape.ends.back())
      if (node < 0 || static_cast<std::size_t>(node) >= shape.nodes)
        throw InputError("the recording is damaged: a segment without nodes");
    const auto material = number_at<std::uint32_t>(arrays, 8 * count + 4 * k);
    shape.axial_stiffness.push_back(materials.at(material).at("axial_stiffness").get<double>());
    shape.rest_length.push_back(number_at<double>(arrays, 12 * count + 8 * k));
  }
}

}  // namespace

ReplayShape replay_shape(const RunModel& model) {
  ReplayShape shape{model.network->design.size(), model.bodies->size(), {}, {}, {}};
  for (const Segment& s : model.network->segments) {
    shape.axial_stiffness.push_back(
        model.network->materials[static_cast<std::size_t>(s.material)].axial_stiffness);
    shape.ends.push_back({s.a, s.b});
    shape.rest_length.push_back(s.rest_length);
  }
  return shape;
}

ReplayScales replay_scales(const RunModel& model) {
  const double size = net_size(*model.network);
  ReplayScales scales;
  scales.quantum = 2.0 * kReplayError * size;
  scales.strain = {1e-7, 64};
  scales.tension = {1e-7 * largest_stiffness(*model.network), 128};
  scales.curvature = {1e-3 / size, 32};
  scales.speed = {1e-5 * size, 64};
  return scales;
}

std::string replay_header(const RunModel& model, const std::string& version) {
  const ReplayScales scales = replay_scales(model);
  Arrays arrays;
  add_net(*model.network, arrays);
  add_bodies(model, arrays);
  Json head;
  head["title"] = model.mission->title;
  head["program"] = "retiarius " + version;
  head["nodes"] = model.network->design.size();
  head["segments"] = model.network->segments.size();
  head["size"] = net_size(*model.network);
  head["quantum"] = scales.quantum;
  head["error"] = 0.5 * scales.quantum;
  head["key_interval"] = ReplayCodec::kKeyInterval;
  head["channels"] = channels(scales);
  head["materials"] = materials(*model.network);
  head["corners"] = model.network->corners;
  head["bullets"] = bullets(*model.network);
  head["phases"] = Json::array();
  for (const PhaseSpec& phase : model.mission->phases)
    head["phases"].push_back({{"name", phase.name}, {"kind", phase_kind_name(phase.kind)}});
  head["bodies"] = Json::array();
  for (const Body& body : *model.bodies) head["bodies"].push_back({{"name", body.name}});
  head["arrays"] = arrays.list();
  const std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string content;
  append_bytes(content, static_cast<std::uint32_t>(text.size()));
  return content + text + deflated(arrays.bytes());
}

ReplayHeader read_replay_header(std::string_view content) {
  std::uint32_t size = 0;
  if (content.size() < sizeof size) throw InputError("the recording is damaged: no header");
  std::memcpy(&size, content.data(), sizeof size);
  ReplayHeader header;
  header.text = content.substr(sizeof size, size);
  const std::string arrays = inflated(content.substr(std::min(content.size(), size + sizeof size)));
  try {
    const Json head = Json::parse(header.text);
    header.shape.nodes = count_at(head, "nodes");
    header.shape.bodies = head.at("bodies").size();
    const auto segments = count_at(head, "segments");
    read_segments(arrays, segments, head.at("materials"), header.shape);
    header.scales.quantum = quantum_at(head);
    const Json& list = head.at("channels");
    header.scales.tension = scale_of(list.at(0));
    header.scales.strain = scale_of(list.at(1));
    header.scales.curvature = scale_of(list.at(2));
    header.scales.speed = scale_of(list.at(3));
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("the recording's header cannot be used: {}", error.what()));
  }
  return header;
}

}  // namespace retiarius
