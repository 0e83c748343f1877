#include "retiarius/motion/surface_planes.hpp"

#include "retiarius/motion/sweep_kernels.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kLanes = kernels::kSweepLanes;
constexpr std::size_t kNoBlock = static_cast<std::size_t>(-1);

// Where a lane's vector begins.
std::size_t first_of(std::size_t lane) { return lane / kLanes * 3 * kLanes + lane % kLanes; }

void write(LineVector& array, std::size_t lane, const Vec3& value) {
  double* const p = array.data() + first_of(lane);
  p[0] = value.x();
  p[kLanes] = value.y();
  p[2 * kLanes] = value.z();
}

}  // namespace

std::size_t SurfacePlanes::add_block(int place) {
  place_.push_back(place);
  nodes_.resize(nodes_.size() + kLanes, -1);
  return place_.size() - 1;
}

// Nodes of a row are lanes of one block, so that they are read together; shared ones are gathered.
// Lanes of no node read the first shared one.
void SurfacePlanes::lay_out(const std::vector<SweepLayout::Slot>& slots, long size) {
  lanes_.clear();
  nodes_.clear();
  place_.clear();
  shared_.clear();
  block_of_.assign(static_cast<std::size_t>(size) / kLanes, kNoBlock);
  std::size_t gathering = kNoBlock, gathered = 0;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const auto offset = static_cast<std::size_t>(slots[k].offset);
    std::size_t lane = 0;
    if (slots[k].stride == 1) {
      if (gathered % kLanes == 0) {
        gathering = add_block(-1);
        shared_.resize(shared_.size() + kLanes, 0);
      }
      lane = gathering * kLanes + gathered % kLanes;
      shared_[gathered++] = static_cast<int>(offset);
    } else {
      std::size_t& block = block_of_[offset / kLanes];
      if (block == kNoBlock) block = add_block(static_cast<int>(offset / kLanes * kLanes));
      lane = block * kLanes + offset % kLanes;
    }
    nodes_[lane] = static_cast<int>(k);
    lanes_.push_back(lane);
  }
  for (LineVector* vectors : {&origin_, &normal_, &velocity_})
    vectors->assign(3 * nodes_.size(), 0.0);
  for (LineVector* numbers : {&offset_, &gap_}) numbers->assign(nodes_.size(), 0.0);
  for (LineVector* bounds : {&reach_, &far_}) bounds->assign(nodes_.size(), kInfinity);
}

void SurfacePlanes::set_plane(std::size_t k, const Plane& plane) {
  const std::size_t lane = lanes_[k];
  write(origin_, lane, plane.origin);
  write(normal_, lane, plane.normal);
  offset_[lane] = plane.gap;
  reach_[lane] = plane.reach;
}

Vec3 SurfacePlanes::velocity(std::size_t k) const {
  const double* const p = velocity_.data() + first_of(lanes_[k]);
  return {p[0], p[kLanes], p[2 * kLanes]};
}

void SurfacePlanes::set_motion(std::size_t k, double gap, const Vec3& velocity) {
  gap_[lanes_[k]] = gap;
  write(velocity_, lanes_[k], velocity);
}

const std::vector<int>& SurfacePlanes::touched(const double* x, const double* v, bool& far) {
  const kernels::SweepPlanes planes{static_cast<long>(place_.size()),
                                    place_.data(),
                                    shared_.data(),
                                    origin_.data(),
                                    normal_.data(),
                                    offset_.data(),
                                    reach_.data(),
                                    far_.data(),
                                    gap_.data(),
                                    velocity_.data()};
  found_.resize(nodes_.size());
  found_.resize(
      static_cast<std::size_t>(kernels::sweeps().clear(planes, x, v, found_.data(), &far)));
  for (int& k : found_) k = nodes_[static_cast<std::size_t>(k)];
  return found_;
}

}  // namespace retiarius
