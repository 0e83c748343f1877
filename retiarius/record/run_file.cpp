#include "retiarius/record/run_file.hpp"

#include <algorithm>
#include <type_traits>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/body_mesh.hpp"
#include "retiarius/record/h5.hpp"
#include "retiarius/record/history_csv.hpp"
#include "retiarius/record/run_h5.hpp"

namespace retiarius {

namespace {

// A reader beside a writer tries again where a block's checksum is wrong, and waits twice as long
// each time, from 1 ns on. What was torn for good when its writer was killed would be waited for
// for ages with the library's 100 attempts; with these the last wait is 17 ms.
constexpr unsigned kReadAttempts = 24;

h5::Handle open_file(const std::filesystem::path& path) {
  h5::prepare();
  h5::Handle access(h5::checked_id(H5Pcreate(H5P_FILE_ACCESS)), H5Pclose);
  h5::checked(H5Pset_file_locking(access.id(), true, true));
  hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id());
  h5::checked(H5Pset_metadata_read_attempts(access.id(), kReadAttempts));
  // A file whose writer goes on or was killed is marked so; it opens as a reader of that mode.
  if (id < 0) id = H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.id());
  return h5::Handle(h5::checked_id(id), H5Fclose);
}

template <class T>
std::vector<T> read_all(hid_t file, const std::string& name) {
  const h5::Handle set = h5::open_dataset(file, name);
  return h5::read_rows<T>(set.id(), 0, h5::shape_of(set.id()).at(0));
}

std::vector<Vec3> vectors(const std::vector<double>& numbers) {
  std::vector<Vec3> list(numbers.size() / 3);
  for (std::size_t k = 0; k < list.size(); ++k) list[k] = Vec3(&numbers[3 * k]);
  return list;
}

template <std::size_t N>
std::vector<std::array<Index, N>> tuples(const std::vector<Index>& numbers) {
  std::vector<std::array<Index, N>> list(numbers.size() / N);
  for (std::size_t k = 0; k < numbers.size(); ++k) list[k / N][k % N] = numbers[k];
  return list;
}

herr_t collect_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->push_back(name);
  return 0;
}

std::vector<std::string> names_in(hid_t group) {
  std::vector<std::string> names;
  hsize_t position = 0;
  h5::checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, &position, collect_name, &names));
  return names;
}

// A killed writer may have let some datasets grow further than others: what all have is complete.
hsize_t common_length(hid_t file, const std::string& group_name) {
  const h5::Handle group(h5::checked_id(H5Gopen2(file, group_name.c_str(), H5P_DEFAULT)), H5Gclose);
  hsize_t length = H5S_UNLIMITED;
  for (const std::string& name : names_in(group.id()))
    length = std::min(length, h5::shape_of(h5::open_dataset(group.id(), name).id()).at(0));
  return length == H5S_UNLIMITED ? 0 : length;
}

}  // namespace

class RunFile::Impl {
 public:
  explicit Impl(const std::filesystem::path& path) : path_(path) {
    guarded([&] {
      file_ = open_file(path);
      const std::int64_t format = h5::read_integer(file_.id(), "format");
      if (format != kRunFileFormat)
        throw Error(
            fmt::format("it has format {}, this version reads format {}", format, kRunFileFormat));
      rows_ = common_length(file_.id(), "history");
      frames_ = common_length(file_.id(), "frames");
    });
  }

  template <class Call>
  std::invoke_result_t<Call> guarded(Call&& call) const {
    try {
      return call();
    } catch (const Error& error) {
      throw InputError(
          fmt::format("cannot read the run file {}: {}", path_.string(), error.what()));
    }
  }

  std::string mission_text(const char* name) const {
    return guarded([&] {
      const h5::Handle group(h5::checked_id(H5Gopen2(id(), "mission", H5P_DEFAULT)), H5Gclose);
      return h5::read_text(group.id(), name);
    });
  }

  hid_t id() const { return file_.id(); }
  hsize_t rows() const { return rows_; }
  hsize_t frames() const { return frames_; }

  template <class T>
  std::vector<T> frame_part(const std::string& name, std::size_t number) const {
    return h5::read_rows<T>(h5::open_dataset(id(), "frames/" + name).id(), number, 1);
  }

  std::vector<ContactMark> contacts(std::size_t number) const {
    const auto part = [&]<class T>(const char* name, hsize_t first, hsize_t count, T) {
      return h5::read_rows<T>(h5::open_dataset(id(), std::string("contacts/") + name).id(), first,
                              count);
    };
    const hsize_t before = number > 0 ? number - 1 : 0;
    const auto ends = part("end", before, number > 0 ? 2 : 1, std::int64_t{});
    const std::int64_t first = number > 0 ? ends.front() : 0, end = ends.back();
    if (first < 0 || end < first) throw Error("its contacts are not counted rightly");
    const auto count = static_cast<hsize_t>(end - first), from = static_cast<hsize_t>(first);
    const auto point = vectors(part("point", from, count, double{}));
    const auto force = vectors(part("force", from, count, double{}));
    const auto body = part("body", from, count, Index{});
    const auto thread = part("thread", from, count, Index{});
    std::vector<ContactMark> marks;
    for (std::size_t k = 0; k < point.size(); ++k)
      marks.push_back({point[k], force[k], body[k], thread[k]});
    return marks;
  }

 private:
  std::filesystem::path path_;
  h5::Handle file_;
  hsize_t rows_ = 0, frames_ = 0;
};

RunFile::RunFile(const std::filesystem::path& path) : impl_(std::make_unique<Impl>(path)) {}
RunFile::~RunFile() = default;
RunFile::RunFile(RunFile&&) noexcept = default;

std::string RunFile::title() const { return impl_->mission_text("title"); }
std::string RunFile::resolved() const { return impl_->mission_text("resolved"); }

NetDrawing RunFile::net() const {
  return impl_->guarded([&] {
    NetDrawing net;
    net.segments = tuples<2>(read_all<Index>(impl_->id(), "net/segments"));
    for (double r : read_all<double>(impl_->id(), "net/radius"))
      net.radius.push_back(static_cast<float>(r));
    for (Index k : read_all<Index>(impl_->id(), "net/material"))
      net.material.push_back(static_cast<float>(k));
    for (Index k : read_all<Index>(impl_->id(), "net/thread"))
      net.thread.push_back(static_cast<float>(k));
    return net;
  });
}

std::vector<Index> RunFile::corners() const {
  return impl_->guarded([&] { return read_all<Index>(impl_->id(), "net/corners"); });
}

std::vector<Index> RunFile::perimeter() const {
  return impl_->guarded([&] { return read_all<Index>(impl_->id(), "net/perimeter"); });
}

std::vector<Index> RunFile::bullets() const {
  return impl_->guarded([&] {
    if (!h5::exists(impl_->id(), "net/bullets")) return std::vector<Index>();
    return read_all<Index>(impl_->id(), "net/bullets");
  });
}

std::vector<double> RunFile::mass() const {
  return impl_->guarded([&] { return read_all<double>(impl_->id(), "net/mass"); });
}

std::vector<double> RunFile::segment_radius() const {
  return impl_->guarded([&] { return read_all<double>(impl_->id(), "net/segment_radius"); });
}

std::vector<double> RunFile::rest_length() const {
  return impl_->guarded([&] { return read_all<double>(impl_->id(), "net/rest_length"); });
}

std::vector<Ball> RunFile::balls() const {
  std::vector<Index> nodes = bullets();
  if (nodes.empty()) nodes = corners();
  const std::vector<double> masses = mass();
  std::vector<double> sorted = masses;
  if (sorted.empty()) return {};
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  std::vector<Ball> balls;
  for (Index node : nodes) {
    const double m = masses.at(static_cast<std::size_t>(node));
    if (m > 2.0 * *middle) balls.push_back({node, steel_ball_radius(m)});
  }
  return balls;
}

std::vector<BodyDrawing> RunFile::bodies() const {
  return impl_->guarded([&] {
    std::vector<BodyDrawing> bodies;
    for (int k = 0; h5::exists(impl_->id(), fmt::format("bodies/{}", k)); ++k) {
      const std::string name = fmt::format("bodies/{}", k);
      const h5::Handle group(h5::checked_id(H5Gopen2(impl_->id(), name.c_str(), H5P_DEFAULT)),
                             H5Gclose);
      bodies.push_back({h5::read_text(group.id(), "name"),
                        {vectors(read_all<double>(group.id(), "vertices")),
                         tuples<3>(read_all<Index>(group.id(), "triangles"))}});
    }
    return bodies;
  });
}

std::vector<std::string> RunFile::history_names() const {
  return impl_->guarded([&] {
    const h5::Handle group(h5::checked_id(H5Gopen2(impl_->id(), "history", H5P_DEFAULT)), H5Gclose);
    // The group lists names alphabetically; the attribute keeps the order of history.csv.
    const std::string ordered = h5::read_text(group.id(), "columns");
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin <= ordered.size();) {
      const std::size_t end = std::min(ordered.find(',', begin), ordered.size());
      names.push_back(ordered.substr(begin, end - begin));
      begin = end + 1;
    }
    return names;
  });
}

std::vector<double> RunFile::history(const std::string& name) const {
  return impl_->guarded([&] {
    const h5::Handle set = h5::open_dataset(impl_->id(), "history/" + name);
    return h5::read_rows<double>(set.id(), 0, impl_->rows());
  });
}

std::size_t RunFile::frame_count() const { return impl_->frames(); }

std::vector<double> RunFile::frame_times() const {
  return impl_->guarded([&] {
    const h5::Handle set = h5::open_dataset(impl_->id(), "frames/time");
    return h5::read_rows<double>(set.id(), 0, impl_->frames());
  });
}

std::vector<Index> RunFile::frame_phases() const {
  return impl_->guarded([&] {
    const h5::Handle set = h5::open_dataset(impl_->id(), "frames/phase");
    return h5::read_rows<Index>(set.id(), 0, impl_->frames());
  });
}

FrameData RunFile::frame(std::size_t number) const {
  return impl_->guarded([&] {
    if (number >= impl_->frames())
      throw Error(
          fmt::format("it has {} frames, number {} is not among them", impl_->frames(), number));
    FrameData frame;
    frame.time = impl_->frame_part<double>("time", number)[0];
    frame.phase = impl_->frame_part<Index>("phase", number)[0];
    frame.x = vectors(impl_->frame_part<double>("positions", number));
    frame.v = vectors(impl_->frame_part<double>("velocities", number));
    frame.tension = impl_->frame_part<double>("tension", number);
    frame.strain = impl_->frame_part<double>("strain", number);
    frame.curvature = impl_->frame_part<double>("curvature", number);
    if (h5::exists(impl_->id(), "frames/contact"))
      frame.contact = impl_->frame_part<Index>("contact", number);
    if (h5::exists(impl_->id(), "contacts")) frame.contacts = impl_->contacts(number);
    if (!h5::exists(impl_->id(), "frames/body_position")) return frame;
    const auto position = vectors(impl_->frame_part<double>("body_position", number));
    const auto velocity = vectors(impl_->frame_part<double>("body_velocity", number));
    const auto momentum = vectors(impl_->frame_part<double>("body_angular_momentum", number));
    const auto attitude = impl_->frame_part<double>("body_attitude", number);
    for (std::size_t k = 0; k < position.size(); ++k)
      frame.bodies.push_back({position[k], Quat(&attitude[4 * k]), velocity[k], momentum[k]});
    return frame;
  });
}

}  // namespace retiarius
