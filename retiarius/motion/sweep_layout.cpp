#include "retiarius/motion/sweep_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace retiarius {

namespace {

constexpr int kLanes = kernels::kSweepLanes;

std::vector<int> degrees_of(const Network& network) {
  std::vector<int> degree(network.mass.size(), 0);
  for (const Segment& s : network.segments) {
    ++degree[s.a];
    ++degree[s.b];
  }
  return degree;
}

bool same_row(const LineVector& a, std::size_t at_a, const LineVector& b, std::size_t at_b) {
  return std::equal(&a[at_a], &a[at_a] + kLanes, &b[at_b]);
}

bool are_alike(const LineVector& rows) {
  for (std::size_t k = kLanes; k < rows.size(); k += kLanes)
    if (!same_row(rows, 0, rows, k)) return false;
  return true;
}

// Adds rows to others, or only the first if one stands for all and is not there yet. Returns where
// they begin.
std::size_t add_rows(LineVector& all, const LineVector& rows, bool alike) {
  const std::size_t end = all.size();
  if (rows.empty()) return 0;
  if (!alike) {
    all.insert(all.end(), rows.begin(), rows.end());
    return end;
  }
  for (std::size_t k = 0; k < end; k += kLanes)
    if (same_row(all, k, rows, 0)) return k;
  all.insert(all.end(), rows.begin(), rows.begin() + kLanes);
  return end;
}

}  // namespace

// Runs of a thread's segments of one material; segments of no thread are chains of their own.
std::vector<SweepLayout::Chain> SweepLayout::cut_chains() const {
  std::vector<Chain> chains;
  std::vector<char> done(network_->segments.size(), 0);
  const auto add = [&](Index k, Index from) {
    const Segment& s = network_->segments[k];
    Chain& chain = chains.back();
    if (chain.nodes.empty()) {
      chain.nodes.push_back(from);
      chain.material = s.material;
    }
    chain.nodes.push_back(s.a == from ? s.b : s.a);
    chain.segments.push_back(k);
    done[k] = 1;
  };
  for (const Thread& thread : network_->threads) {
    chains.emplace_back();
    for (std::size_t k = 0; k < thread.segments.size(); ++k) {
      const Segment& s = network_->segments[thread.segments[k]];
      const Index from = thread.nodes[k];
      if (done[thread.segments[k]] || (s.a != from && s.b != from)) continue;
      const Chain& chain = chains.back();
      if (!chain.nodes.empty() && (chain.nodes.back() != from || chain.material != s.material))
        chains.emplace_back();
      add(thread.segments[k], from);
    }
    if (chains.back().nodes.empty()) chains.pop_back();
  }
  for (std::size_t k = 0; k < done.size(); ++k) {
    if (done[k]) continue;
    chains.emplace_back();
    add(static_cast<Index>(k), network_->segments[k].a);
  }
  return chains;
}

SweepLayout::SweepLayout(const Network& network, const std::vector<char>& alone)
    : network_(&network) {
  const std::vector<Chain> chains = cut_chains();
  std::vector<const Chain*> order;
  for (const Chain& c : chains) order.push_back(&c);
  std::stable_sort(order.begin(), order.end(), [](const Chain* a, const Chain* b) {
    if (a->material != b->material) return a->material < b->material;
    return a->nodes.size() > b->nodes.size();
  });
  std::vector<std::vector<const Chain*>> groups;
  for (const Chain* c : order) {
    if (groups.empty() || groups.back().size() == kLanes ||
        groups.back().front()->material != c->material)
      groups.emplace_back();
    groups.back().push_back(c);
  }
  place_nodes(groups, alone);
  place_groups(groups);
  link_ends();
  make_groups();
}

// Which nodes are shared, and where each lies.
void SweepLayout::place_nodes(const std::vector<std::vector<const Chain*>>& groups,
                              const std::vector<char>& alone) {
  const std::vector<int> degree = degrees_of(*network_);
  std::vector<char> shared(network_->mass.size(), 1);
  for (const auto& group : groups) {
    for (std::size_t j = 1; j + 1 < group.front()->nodes.size(); ++j) {
      const bool passes = std::all_of(group.begin(), group.end(), [&](const Chain* c) {
        if (j >= c->nodes.size()) return true;
        const Index node = c->nodes[j];
        return j + 1 < c->nodes.size() && degree[node] == 2 && (alone.empty() || !alone[node]);
      });
      if (!passes) continue;
      for (const Chain* c : group)
        if (j < c->nodes.size()) shared[c->nodes[j]] = 0;
    }
  }
  // Shared nodes by the number of chain rows that touch them, so that equals are summed alike.
  std::vector<int> touched(network_->mass.size(), 0);
  for (const auto& group : groups)
    for (const Chain* c : group)
      for (const Index node : c->nodes) ++touched[node];
  for (std::size_t i = 0; i < shared.size(); ++i)
    if (shared[i]) shared_nodes_.push_back(static_cast<Index>(i));
  std::stable_sort(shared_nodes_.begin(), shared_nodes_.end(),
                   [&](Index a, Index b) { return touched[a] < touched[b]; });
  slots_.resize(shared.size());
  // One shared node more, which padding lanes read.
  nodes_.assign((4 * (shared_nodes_.size() + 1) + 7) / 8 * 8, kNone);
  for (std::size_t i = 0; i < shared_nodes_.size(); ++i) {
    slots_[shared_nodes_[i]] = {4 * static_cast<long>(i), 1};
    for (std::size_t c = 0; c < 3; ++c) nodes_[4 * i + c] = shared_nodes_[i];
    inverse_shared_.push_back(1.0 / network_->mass[shared_nodes_[i]]);
  }
  for (std::size_t i = 0; i < shared.size(); ++i)
    if (!shared[i]) slots_[i].stride = kLanes;
}

void SweepLayout::place_groups(const std::vector<std::vector<const Chain*>>& groups) {
  const int nobody = 4 * static_cast<int>(shared_nodes_.size());
  for (const auto& group : groups) {
    Block block;
    block.place = place_.size();
    block.shared = shared_.size();
    block.ends = ends_of_.size();
    block.segment = segments_.size();
    block.inverse = inverse_rows_.size();
    block.rows = static_cast<long>(group.front()->nodes.size());
    block.material = group.front()->material;
    blocks_.push_back(block);
    for (std::size_t j = 0; j < group.front()->nodes.size(); ++j) {
      const bool in_row = !shared(group.front()->nodes[j]);
      const long start = size();
      place_.push_back(in_row ? static_cast<int>(start) : -1);
      if (in_row) nodes_.resize(nodes_.size() + 3 * kLanes, kNone);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const bool there = lane < group.size() && j < group[lane]->nodes.size();
        const Index node = there ? group[lane]->nodes[j] : kNone;
        const bool spans = there && j + 1 < group[lane]->nodes.size();
        if (j + 1 < group.front()->nodes.size())
          segments_.push_back(spans ? group[lane]->segments[j] : kNone);
        if (!in_row) {
          shared_.push_back(there ? static_cast<int>(slots_[node].offset) : nobody);
          ends_of_.push_back(node);
          continue;
        }
        inverse_rows_.push_back(there ? 1.0 / network_->mass[node] : 0.0);
        if (!there) continue;
        slots_[node].offset = start + static_cast<long>(lane);
        for (std::size_t c = 0; c < 3; ++c)
          nodes_[static_cast<std::size_t>(start) + c * kLanes + lane] = node;
      }
    }
  }
}

// For each shared node where its forces are, and the runs of nodes with equally many.
void SweepLayout::link_ends() {
  std::vector<std::vector<int>> at(slots_.size());
  for (std::size_t e = 0; e < ends_of_.size(); ++e)
    if (ends_of_[e] != kNone) at[ends_of_[e]].push_back(4 * static_cast<int>(e));
  for (const Index node : shared_nodes_) {
    first_end_.push_back(static_cast<int>(incidences_.size()));
    end_count_.push_back(static_cast<int>(at[node].size()));
    incidences_.insert(incidences_.end(), at[node].begin(), at[node].end());
  }
  for (std::size_t i = 0; i < shared_nodes_.size(); ++i) {
    const int k = static_cast<int>(i);
    if (runs_.empty() || runs_.back().count != end_count_[i])
      runs_.push_back({k, k, end_count_[i], incidences_.data() + first_end_[i]});
    runs_.back().end = k + 1;
  }
}

// Rest lengths, stiffnesses and masses of a block's rows: one row where all are alike, which other
// blocks may have left.
void SweepLayout::add_laws(Block& block, kernels::SweepGroup& group) {
  LineVector rest, stiffness, inverse;
  const auto end = block.segment + static_cast<std::size_t>(block.rows - 1) * kLanes;
  for (std::size_t k = block.segment; k < end; ++k) {
    const bool there = segments_[k] != kNone;
    const Segment* const s = there ? &network_->segments[segments_[k]] : nullptr;
    rest.push_back(there ? s->rest_length : 1.0);
    stiffness.push_back(there ? network_->materials[s->material].axial_stiffness / s->rest_length
                              : 0.0);
  }
  const auto rows = place_.begin() + static_cast<std::ptrdiff_t>(block.place);
  const auto own = static_cast<std::size_t>(
      std::count_if(rows, rows + block.rows, [](int place) { return place >= 0; }));
  const double* const first = inverse_rows_.data() + block.inverse;
  inverse.assign(first, first + own * kLanes);
  const bool alike = are_alike(rest) && are_alike(stiffness) && are_alike(inverse);
  group.step = alike ? 0 : kLanes;
  block.rest = add_rows(rest_, rest, alike);
  block.stiffness = add_rows(stiffness_, stiffness, alike);
  block.inverse = add_rows(inverse_, inverse, alike);
}

void SweepLayout::make_groups() {
  last_.assign(segments_.size(), 0.0);
  before_.assign(segments_.size(), 0.0);
  drag_.assign(segments_.size(), 0.0);
  tension_.assign(segments_.size(), 0.0);
  ends_.resize(std::max<std::size_t>(1, 4 * ends_of_.size()));
  std::fill_n(ends_.data(), ends_.size(), 0.0);
  for (Block& b : blocks_) {
    kernels::SweepGroup g{};
    g.rows = b.rows;
    g.place = place_.data() + b.place;
    g.shared = shared_.data() + b.shared;
    g.ends = ends_.data() + 4 * b.ends;
    add_laws(b, g);
    g.elongation[0] = last_.data() + b.segment;
    g.elongation[1] = before_.data() + b.segment;
    g.drag = drag_.data() + b.segment;
    g.tension = tension_.data() + b.segment;
    g.bilateral = network_->materials[b.material].compression;
    groups_.push_back(g);
  }
  slack_.assign(stiffness_.size(), 0.0);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].rest = rest_.data() + blocks_[g].rest;
    groups_[g].inverse = inverse_.data() + blocks_[g].inverse;
  }
}

void SweepLayout::begin(const std::vector<Vec3>& x, const std::vector<Vec3>& v, double h,
                        bool stretch) {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Material& m = network_->materials[blocks_[g].material];
    groups_[g].viscosity = stretch ? m.damping / h : 0.0;
    groups_[g].stiffness = (stretch ? stiffness_ : slack_).data() + blocks_[g].stiffness;
  }
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    if (segments_[k] == kNone) continue;
    const Segment& s = network_->segments[segments_[k]];
    const Material& m = network_->materials[s.material];
    if (m.damping == 0.0) continue;
    const Vec3 e = x[s.b] - x[s.a];
    const double length = e.norm();
    const double rate = length > 0.0 ? e.dot(v[s.b] - v[s.a]) / length : 0.0;
    const double u = length - s.rest_length;
    last_[k] = u - h * rate;
    before_[k] = u - 2.0 * h * rate;
    if (m.compression) continue;
    last_[k] = u > 0.0 ? std::max(0.0, last_[k]) : 0.0;
    before_[k] = u > 0.0 ? std::max(0.0, before_[k]) : 0.0;
  }
}

void SweepLayout::bind(kernels::SweepState& state) const {
  state.inverse_shared = inverse_shared_.data();
  state.ends = ends_.data();
}

Vec3 SweepLayout::force(Index shared_node) const {
  const auto i = static_cast<std::size_t>(slots_[shared_node].offset / 4);
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < end_count_[i]; ++k) {
    const double* f = ends_.data() + incidences_[static_cast<std::size_t>(first_end_[i] + k)];
    sum += Vec3(f[0], f[1], f[2]);
  }
  return sum;
}

void SweepLayout::tensions(std::vector<double>& out) const {
  for (std::size_t k = 0; k < segments_.size(); ++k)
    if (segments_[k] != kNone) out[segments_[k]] = tension_[k];
}

}  // namespace retiarius
