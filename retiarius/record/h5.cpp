#include "retiarius/record/h5.hpp"

#include <algorithm>

#include "retiarius/base/error.hpp"

namespace retiarius::h5 {

namespace {

herr_t keep_first(unsigned depth, const H5E_error2_t* error, void* text) {
  if (depth == 0 && error->desc) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

constexpr unsigned kCompressionLevel = 3;  // beyond it files shrink little and writing slows much

}  // namespace

void prepare() {
  // At exit HDF5 would try again to close a file that the full disk kept from closing, and crash.
  // Nothing is left to that moment: every file is flushed and closed before.
  static const herr_t once = H5dont_atexit();
  (void)once;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string last_error() {
  std::string text = "unknown HDF5 error";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &text);
  // "..., errno = 28, error message = 'No space left on device', buf = ..." says it between quotes.
  const std::string marker = "error message = '";
  const std::size_t at = text.find(marker);
  if (at == std::string::npos) return text;
  const std::size_t begin = at + marker.size();
  return text.substr(begin, text.find('\'', begin) - begin);
}

hid_t checked_id(hid_t id) {
  if (id < 0) throw Error(last_error());
  return id;
}

void checked(herr_t status) {
  if (status < 0) throw Error(last_error());
}

Handle make_group(hid_t parent, const std::string& name) {
  return Handle(checked_id(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)),
                H5Gclose);
}

Handle open_dataset(hid_t parent, const std::string& name) {
  return Handle(checked_id(H5Dopen2(parent, name.c_str(), H5P_DEFAULT)), H5Dclose);
}

bool exists(hid_t parent, const std::string& name) {
  return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0;
}

void write_text(hid_t object, const std::string& name, const std::string& text) {
  Handle type(checked_id(H5Tcopy(H5T_C_S1)), H5Tclose);
  checked(H5Tset_size(type.id(), std::max<std::size_t>(1, text.size())));
  checked(H5Tset_cset(type.id(), H5T_CSET_UTF8));
  checked(H5Tset_strpad(type.id(), H5T_STR_NULLPAD));
  Handle space(checked_id(H5Screate(H5S_SCALAR)), H5Sclose);
  Handle attribute(
      checked_id(H5Acreate2(object, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT)),
      H5Aclose);
  checked(H5Awrite(attribute.id(), type.id(), text.c_str()));
}

std::string read_text(hid_t object, const std::string& name) {
  Handle attribute(checked_id(H5Aopen(object, name.c_str(), H5P_DEFAULT)), H5Aclose);
  Handle type(checked_id(H5Aget_type(attribute.id())), H5Tclose);
  std::string text(H5Tget_size(type.id()), '\0');
  checked(H5Aread(attribute.id(), type.id(), text.data()));
  text.resize(std::min(text.size(), text.find('\0')));
  return text;
}

void write_integer(hid_t object, const std::string& name, std::int64_t value) {
  Handle space(checked_id(H5Screate(H5S_SCALAR)), H5Sclose);
  Handle attribute(checked_id(H5Acreate2(object, name.c_str(), H5T_NATIVE_INT64, space.id(),
                                         H5P_DEFAULT, H5P_DEFAULT)),
                   H5Aclose);
  checked(H5Awrite(attribute.id(), H5T_NATIVE_INT64, &value));
}

std::int64_t read_integer(hid_t object, const std::string& name) {
  Handle attribute(checked_id(H5Aopen(object, name.c_str(), H5P_DEFAULT)), H5Aclose);
  std::int64_t value = 0;
  checked(H5Aread(attribute.id(), H5T_NATIVE_INT64, &value));
  return value;
}

std::vector<hsize_t> shape_of(hid_t dataset) {
  Handle space(checked_id(H5Dget_space(dataset)), H5Sclose);
  std::vector<hsize_t> shape(
      static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.id()))));
  checked(H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr));
  return shape;
}

Series::Series(hid_t parent, const std::string& name, hid_t type, std::vector<hsize_t> row,
               hsize_t chunk, bool compressed)
    : shape_(std::move(row)) {
  shape_.insert(shape_.begin(), 0);
  std::vector<hsize_t> largest = shape_, chunks = shape_;
  largest[0] = H5S_UNLIMITED;
  chunks[0] = chunk;
  for (hsize_t& extent : chunks) extent = std::max<hsize_t>(1, extent);
  const int rank = static_cast<int>(shape_.size());
  Handle space(checked_id(H5Screate_simple(rank, shape_.data(), largest.data())), H5Sclose);
  Handle properties(checked_id(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
  checked(H5Pset_chunk(properties.id(), rank, chunks.data()));
  if (compressed) {
    checked(H5Pset_shuffle(properties.id()));
    checked(H5Pset_deflate(properties.id(), kCompressionLevel));
  }
  set_ = Handle(checked_id(H5Dcreate2(parent, name.c_str(), type, space.id(), H5P_DEFAULT,
                                      properties.id(), H5P_DEFAULT)),
                H5Dclose);
}

std::size_t Series::entry_size() const {
  std::size_t size = 1;
  for (std::size_t k = 1; k < shape_.size(); ++k) size *= shape_[k];
  return size;
}

void Series::append(const void* values, hsize_t count, hid_t type) {
  std::vector<hsize_t> start(shape_.size(), 0), block = shape_;
  start[0] = shape_[0];
  block[0] = count;
  shape_[0] += count;
  checked(H5Dset_extent(set_.id(), shape_.data()));
  Handle space(checked_id(H5Dget_space(set_.id())), H5Sclose);
  checked(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, block.data(),
                              nullptr));
  const int rank = static_cast<int>(block.size());
  Handle memory(checked_id(H5Screate_simple(rank, block.data(), nullptr)), H5Sclose);
  checked(H5Dwrite(set_.id(), type, memory.id(), space.id(), H5P_DEFAULT, values));
}

}  // namespace retiarius::h5
