// A thin layer over the HDF5 C API: handles that close themselves, every return value checked.
// Only for the sources of record/: everything else speaks of run.h5 through RunH5 and RunFile.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace retiarius::h5 {

// Owns an HDF5 identifier. Errors while closing are not seen: what must be on disk is flushed
// before.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { reset(); }

  void reset() {
    if (id_ >= 0) close_(id_);
    id_ = H5I_INVALID_HID;
  }
  hid_t id() const { return id_; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

// To be called before a file is opened: HDF5 prints its errors unless told otherwise, and cleans up
// at exit in a way that crashes after a full disk.
void prepare();

// The innermost cause of the last HDF5 error: the system's message where there is one.
std::string last_error();

// The HDF5 type of a C++ number: double, std::int32_t, std::int64_t.
template <class T>
hid_t native_type();
template <>
inline hid_t native_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t native_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
inline hid_t native_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}

// Throw Error with last_error() as text when the call failed; callers add the file's name.
hid_t checked_id(hid_t id);
void checked(herr_t status);

Handle make_group(hid_t parent, const std::string& name);
Handle open_dataset(hid_t parent, const std::string& name);
bool exists(hid_t parent, const std::string& name);

void write_text(hid_t object, const std::string& name, const std::string& text);
std::string read_text(hid_t object, const std::string& name);
void write_integer(hid_t object, const std::string& name, std::int64_t value);
std::int64_t read_integer(hid_t object, const std::string& name);

// Sizes of a dataset along its dimensions.
std::vector<hsize_t> shape_of(hid_t dataset);

// Writes a dataset of fixed size, row by row.
template <class T>
Handle write_array(hid_t parent, const std::string& name, const std::vector<hsize_t>& shape,
                   const std::vector<T>& values) {
  Handle space(checked_id(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr)),
               H5Sclose);
  Handle set(checked_id(H5Dcreate2(parent, name.c_str(), native_type<T>(), space.id(), H5P_DEFAULT,
                                   H5P_DEFAULT, H5P_DEFAULT)),
             H5Dclose);
  if (!values.empty())
    checked(H5Dwrite(set.id(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  return set;
}

// Reads `count` entries of the first dimension from `first` on, row by row.
template <class T>
std::vector<T> read_rows(hid_t dataset, hsize_t first, hsize_t count) {
  std::vector<hsize_t> shape = shape_of(dataset), start(shape.size(), 0);
  start.at(0) = first;
  shape.at(0) = count;
  std::size_t size = 1;
  for (hsize_t extent : shape) size *= extent;
  std::vector<T> values(size);
  if (size == 0) return values;
  Handle file_space(checked_id(H5Dget_space(dataset)), H5Sclose);
  checked(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, shape.data(),
                              nullptr));
  Handle memory(checked_id(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr)),
                H5Sclose);
  checked(
      H5Dread(dataset, native_type<T>(), memory.id(), file_space.id(), H5P_DEFAULT, values.data()));
  return values;
}

// A dataset that grows along its first dimension.
class Series {
 public:
  // `row` is the shape of one entry (empty: a number), `chunk` the entries of one chunk. Compressed
  // chunks should hold one entry, so that each is written once and never moved.
  Series(hid_t parent, const std::string& name, hid_t type, std::vector<hsize_t> row, hsize_t chunk,
         bool compressed);

  // Appends `count` entries; `values` has count times the entry's size elements of `type`.
  void append(const void* values, hsize_t count, hid_t type);

  // Numbers in one entry.
  std::size_t entry_size() const;

  hid_t id() const { return set_.id(); }

 private:
  Handle set_;
  std::vector<hsize_t> shape_;  // now
};

}  // namespace retiarius::h5
