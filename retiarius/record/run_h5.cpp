#include "retiarius/record/run_h5.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>

#include <fmt/format.h>
#include <hdf5_hl.h>
#include <unistd.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/body_mesh.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/h5.hpp"
#include "retiarius/record/history_csv.hpp"
#include "retiarius/record/vtk_frames.hpp"

namespace retiarius {

namespace {

constexpr hsize_t kHistoryChunk = 256;  // rows
constexpr hsize_t kContactChunk = 256;
constexpr std::size_t kBufferedRows = 1024;  // at most, when frames are rare

std::vector<double> flat(const std::vector<Vec3>& vectors) {
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Vec3& v : vectors) numbers.insert(numbers.end(), v.begin(), v.end());
  return numbers;
}

template <std::size_t N>
std::vector<Index> flat(const std::vector<std::array<Index, N>>& tuples) {
  std::vector<Index> numbers;
  for (const auto& tuple : tuples) numbers.insert(numbers.end(), tuple.begin(), tuple.end());
  return numbers;
}

// A block of metadata that is smaller than a page lies within one: the system stops a killed writer
// between pages only, so it is never written in part.
constexpr hsize_t kPage = 4096;

h5::Handle create_file(const std::filesystem::path& path) {
  h5::prepare();
  h5::Handle access(h5::checked_id(H5Pcreate(H5P_FILE_ACCESS)), H5Pclose);
  // Needed for the single-writer-multiple-reader mode.
  h5::checked(H5Pset_libver_bounds(access.id(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST));
  // Some cluster file systems have no locks; the run goes on there without.
  h5::checked(H5Pset_file_locking(access.id(), true, true));
  h5::Handle creation(h5::checked_id(H5Pcreate(H5P_FILE_CREATE)), H5Pclose);
  h5::checked(H5Pset_file_space_strategy(creation.id(), H5F_FSPACE_STRATEGY_PAGE, false, 1));
  h5::checked(H5Pset_file_space_page_size(creation.id(), kPage));
  return h5::Handle(
      h5::checked_id(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id())), H5Fclose);
}

void describe(hid_t dataset, const char* unit, const char* meaning) {
  h5::write_text(dataset, "units", unit);
  h5::write_text(dataset, "long_name", meaning);
}

void write_net(hid_t file, const Network& net) {
  const h5::Handle group = h5::make_group(file, "net");
  const NetDrawing drawing = net_drawing(net);
  const hsize_t nodes = net.design.size(), segments = net.segments.size();
  std::vector<Index> material, thread;
  std::vector<double> rest, radius(drawing.radius.begin(), drawing.radius.end());
  std::vector<double> segment_radius;
  for (const Segment& s : net.segments) {
    material.push_back(s.material);
    thread.push_back(s.thread);
    rest.push_back(s.rest_length);
    segment_radius.push_back(net.materials[static_cast<std::size_t>(s.material)].radius);
  }
  const hid_t id = group.id();
  describe(h5::write_array(id, "design", {nodes, 3}, flat(net.design)).id(), "m",
           "node positions as designed");
  describe(h5::write_array(id, "mass", {nodes}, net.mass).id(), "kg", "lumped mass of each node");
  describe(h5::write_array(id, "radius", {nodes}, radius).id(), "m",
           "radius of the thickest thread at each node");
  describe(h5::write_array(id, "segments", {segments, 2}, flat(drawing.segments)).id(), "1",
           "the two nodes of each segment");
  describe(h5::write_array(id, "rest_length", {segments}, rest).id(), "m", "of each segment");
  describe(h5::write_array(id, "segment_radius", {segments}, segment_radius).id(), "m",
           "of each segment");
  describe(h5::write_array(id, "material", {segments}, material).id(), "1",
           "index of each segment's material");
  describe(h5::write_array(id, "thread", {segments}, thread).id(), "1",
           "index of each segment's thread, -1 for none");
  describe(h5::write_array(id, "corners", {net.corners.size()}, net.corners).id(), "1",
           "nodes of the mouth's polygon in order");
  describe(h5::write_array(id, "bullets", {net.bullets.size()}, net.bullets).id(), "1",
           "nodes of the corner masses");
  describe(h5::write_array(id, "perimeter", {net.perimeter.size()}, net.perimeter).id(), "1",
           "nodes of the outline in order");
}

void write_bodies(hid_t file, const RunModel& model) {
  const h5::Handle group = h5::make_group(file, "bodies");
  const std::vector<BodyDrawing> drawings = body_drawings(model);
  for (std::size_t k = 0; k < drawings.size(); ++k) {
    const TriangleMesh& mesh = drawings[k].mesh;
    const h5::Handle body = h5::make_group(group.id(), std::to_string(k));
    h5::write_text(body.id(), "name", drawings[k].name);
    describe(
        h5::write_array(body.id(), "vertices", {mesh.vertices.size(), 3}, flat(mesh.vertices)).id(),
        "m", "vertices of the drawn surface in body axes");
    describe(
        h5::write_array(body.id(), "triangles", {mesh.triangles.size(), 3}, flat(mesh.triangles))
            .id(),
        "1", "three vertices of each triangle, counter-clockwise from outside");
  }
}

}  // namespace

// The open file with its growing datasets.
class RunH5::File {
 public:
  File(const std::filesystem::path& path, const RunModel& model, const std::string& resolved,
       const std::string& version)
      : file_(create_file(path)), bodies_(model.bodies->size()) {
    h5::write_integer(file_.id(), "format", kRunFileFormat);
    h5::write_text(file_.id(), "program", "retiarius " + version);
    const h5::Handle mission = h5::make_group(file_.id(), "mission");
    h5::write_text(mission.id(), "title", model.mission->title);
    h5::write_text(mission.id(), "resolved", resolved);
    write_net(file_.id(), *model.network);
    write_bodies(file_.id(), model);
    create_history(*model.mission);
    create_frames(model.network->design.size(), model.network->segments.size());
    create_contacts();
    h5::checked(H5Fstart_swmr_write(file_.id()));
  }

  void add_row(const HistoryRow& row) {
    const std::vector<double> values = history_values(row);
    if (values.size() != columns_.size())
      throw Error(fmt::format("a history row has {} values for {} columns", values.size(),
                              columns_.size()));
    for (std::size_t k = 0; k < values.size(); ++k) rows_[k].push_back(values[k]);
    if (rows_[0].size() >= kBufferedRows) flush();
  }

  void add_frame(const Frame& frame) {
    const State& s = *frame.state;
    const hid_t number = H5T_NATIVE_DOUBLE;
    const auto add = [&](const char* name, const std::vector<double>& values) {
      h5::Series& series = frames_.at(name);
      if (values.size() != series.entry_size())
        throw Error(fmt::format("a frame has {} values of {} where {} are expected", values.size(),
                                name, series.entry_size()));
      series.append(values.data(), 1, number);
    };
    add("positions", flat(s.x));
    add("velocities", flat(s.v));
    add("tension", frame.tension);
    add("strain", frame.strain);
    add("curvature", frame.curvature);
    frames_.at("contact").append(contact_of_nodes(s).data(), 1, h5::native_type<Index>());
    if (s.bodies.size() != bodies_)
      throw Error(fmt::format("a frame has {} bodies of {}", s.bodies.size(), bodies_));
    if (bodies_ > 0) add_bodies(s.bodies);
    add_contacts(frame.contacts);
    frames_.at("phase").append(&frame.phase, 1, h5::native_type<Index>());
    frames_.at("time").append(&s.time, 1, number);
    flush();
  }

  void flush() {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (rows_[k].empty()) continue;
      columns_[k].append(rows_[k].data(), rows_[k].size(), H5T_NATIVE_DOUBLE);
      rows_[k].clear();
    }
    h5::checked(H5Fflush(file_.id(), H5F_SCOPE_LOCAL));
  }

  // As flush(), and waits until the data are on the device.
  void sync() {
    flush();
    void* descriptor = nullptr;
    h5::checked(H5Fget_vfd_handle(file_.id(), H5P_DEFAULT, &descriptor));
    if (::fsync(*static_cast<const int*>(descriptor)) != 0) throw Error(std::strerror(errno));
  }

 private:
  void create_history(const Mission& mission) {
    const h5::Handle group = h5::make_group(file_.id(), "history");
    const std::vector<std::string> names = history_header(mission);
    h5::write_text(group.id(), "columns", fmt::format("{}", fmt::join(names, ",")));
    for (const std::string& name : names) {
      const std::size_t k = columns_.size();
      columns_.emplace_back(group.id(), name, H5T_NATIVE_DOUBLE, std::vector<hsize_t>{},
                            kHistoryChunk, false);
      if (k < history_columns().size()) {
        const HistoryColumn& column = history_columns()[k];
        describe(columns_[k].id(), column.unit.c_str(), column.meaning.c_str());
      } else if (k >= history_columns().size() + 6 * mission.probes.size()) {
        describe(columns_[k].id(), "N", "force of contact on the target");
      } else {
        const bool force = name[name.size() - 2] == 'f';
        describe(columns_[k].id(), force ? "N" : "m",
                 force ? "support force on the probe's node" : "position of the probe's node");
      }
      if (k == 0) h5::checked(H5DSset_scale(columns_[0].id(), "time"));
      if (k > 0) h5::checked(H5DSattach_scale(columns_[k].id(), columns_[0].id(), 0));
    }
    rows_.resize(columns_.size());
  }

  void create_frames(hsize_t nodes, hsize_t segments) {
    const h5::Handle group = h5::make_group(file_.id(), "frames");
    const auto create = [&](const char* name, hid_t type, std::vector<hsize_t> row,
                            const char* unit, const char* meaning) {
      const bool array = !row.empty();
      const auto [entry, added] =
          frames_.try_emplace(name, group.id(), name, type, row, array ? 1 : 64, array);
      describe(entry->second.id(), unit, meaning);
      const hid_t time = frames_.at("time").id();
      if (entry->second.id() != time)
        h5::checked(H5DSattach_scale(entry->second.id(), time, 0));
      else
        h5::checked(H5DSset_scale(time, "time"));
    };
    const hid_t number = H5T_NATIVE_DOUBLE;
    const hsize_t bodies = bodies_;
    create("time", number, {}, "s", "time since the mission's start");
    create("phase", h5::native_type<Index>(), {}, "1", "index of the phase, from 0");
    create("positions", number, {nodes, 3}, "m", "node positions");
    create("velocities", number, {nodes, 3}, "m/s", "node velocities");
    create("tension", number, {segments}, "N", "of each segment, viscous part included");
    create("strain", number, {segments}, "1", "axial strain of each segment");
    create("curvature", number, {nodes}, "1/m", "largest of the joints at each node");
    create("contact", h5::native_type<Index>(), {nodes}, "1",
           "of each node: 0 free, 1 slides along a body, 2 sticks to one");
    if (bodies_ == 0) return;
    create("body_position", number, {bodies, 3}, "m", "of each body's mass centre");
    create("body_attitude", number, {bodies, 4}, "1",
           "unit quaternion x, y, z, w, from body axes to world axes");
    create("body_velocity", number, {bodies, 3}, "m/s", "of each body's mass centre");
    create("body_angular_momentum", number, {bodies, 3}, "kg m2/s",
           "about each body's mass centre, world axes");
  }

  // Frames have different numbers of contacts: all stand in one list, frame after frame.
  void create_contacts() {
    const h5::Handle group = h5::make_group(file_.id(), "contacts");
    const auto create = [&](const char* name, hid_t type, std::vector<hsize_t> row,
                            const char* unit, const char* meaning) {
      const auto [entry, added] =
          contacts_.try_emplace(name, group.id(), name, type, row, kContactChunk, false);
      describe(entry->second.id(), unit, meaning);
    };
    create("end", h5::native_type<std::int64_t>(), {}, "1",
           "of each frame: its contacts stand before this place, after those of the frame before");
    create("point", H5T_NATIVE_DOUBLE, {3}, "m", "where they touch");
    create("force", H5T_NATIVE_DOUBLE, {3}, "N", "on the body, or on the second thread");
    create("body", h5::native_type<Index>(), {}, "1", "index of the body, -1 for a thread");
    create("thread", h5::native_type<Index>(), {}, "1",
           "index of the thread that touches it, -1 for another body");
  }

  void add_contacts(const std::vector<ContactMark>& marks) {
    std::vector<Vec3> points, forces;
    std::vector<Index> bodies, threads;
    for (const ContactMark& mark : marks) {
      points.push_back(mark.point);
      forces.push_back(mark.force);
      bodies.push_back(mark.body);
      threads.push_back(mark.thread);
    }
    const auto add = [&](const char* name, const void* values, std::size_t count, hid_t type) {
      if (count > 0) contacts_.at(name).append(values, count, type);
    };
    add("point", flat(points).data(), marks.size(), H5T_NATIVE_DOUBLE);
    add("force", flat(forces).data(), marks.size(), H5T_NATIVE_DOUBLE);
    add("body", bodies.data(), marks.size(), h5::native_type<Index>());
    add("thread", threads.data(), marks.size(), h5::native_type<Index>());
    contacts_told_ += static_cast<std::int64_t>(marks.size());
    add("end", &contacts_told_, 1, h5::native_type<std::int64_t>());
  }

  void add_bodies(const std::vector<BodyState>& bodies) {
    std::vector<Vec3> position, velocity, momentum;
    std::vector<double> attitude;
    for (const BodyState& b : bodies) {
      position.push_back(b.position);
      velocity.push_back(b.velocity);
      momentum.push_back(b.angular_momentum);
      attitude.insert(attitude.end(), b.attitude.coeffs().begin(), b.attitude.coeffs().end());
    }
    frames_.at("body_position").append(flat(position).data(), 1, H5T_NATIVE_DOUBLE);
    frames_.at("body_attitude").append(attitude.data(), 1, H5T_NATIVE_DOUBLE);
    frames_.at("body_velocity").append(flat(velocity).data(), 1, H5T_NATIVE_DOUBLE);
    frames_.at("body_angular_momentum").append(flat(momentum).data(), 1, H5T_NATIVE_DOUBLE);
  }

  h5::Handle file_;  // declared first: closed after its datasets
  std::size_t bodies_;
  std::vector<h5::Series> columns_;
  std::vector<std::vector<double>> rows_;  // of each column, not yet in the file
  std::map<std::string, h5::Series> frames_, contacts_;
  std::int64_t contacts_told_ = 0;
};

void mend_run_file(const std::filesystem::path& path) {
  constexpr std::streamoff kEndOfFileAddress = 28;  // in a superblock of version 2 or 3
  std::array<unsigned char, 8> bytes{};
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(kEndOfFileAddress);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size())) return;
  std::uintmax_t stated = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k) stated |= std::uintmax_t{bytes[k]} << (8 * k);
  // Far more than any write that failed: the bytes are not what they seem.
  constexpr std::uintmax_t kMost = std::uintmax_t{1} << 32;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && stated > size && stated - size < kMost)
    std::filesystem::resize_file(path, stated, error);
}

template <class Call>
void RunH5::guarded(const char* what, Call&& call) {
  if (broken_) return;
  try {
    call();
  } catch (const Error& error) {
    broken_ = true;
    save_what_is_written();
    throw RunError(fmt::format("cannot {} {}: {}", what, path_.string(), error.what()));
  }
}

void RunH5::save_what_is_written() {
  file_.reset();
  // A failure here leaves the file as it is; the error that led here is the one to report.
  mend_run_file(path_);
}

RunH5::RunH5(const std::filesystem::path& folder, std::string resolved, std::string version)
    : path_(folder / "run.h5"), resolved_(std::move(resolved)), version_(std::move(version)) {}

RunH5::~RunH5() = default;

void RunH5::begin(const RunModel& model) {
  if (model.resumed) path_ = new_name(path_);
  guarded("create", [&] { file_ = std::make_unique<File>(path_, model, resolved_, version_); });
}

void RunH5::history(const HistoryRow& row) {
  guarded("write", [&] { file_->add_row(row); });
}

void RunH5::frame(const Frame& frame) {
  guarded("write", [&] { file_->add_frame(frame); });
}

void RunH5::save(const Checkpoint&, bool durable) {
  guarded("write", [&] { durable ? file_->sync() : file_->flush(); });
}

// The file that was begun takes the place of the one that the run left.
void RunH5::resumed() {
  guarded("write", [&] { file_->sync(); });
  const std::filesystem::path old = path_.parent_path() / "run.h5";
  rename_durably(path_, old);
  path_ = old;
}

void RunH5::end(const RunReport&) {
  if (!file_) return;
  guarded("write", [&] { file_->flush(); });
  file_.reset();
}

}  // namespace retiarius
