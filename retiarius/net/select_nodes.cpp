#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius {
namespace {

std::optional<std::size_t> read_index(std::string_view text) {
  std::size_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || error != std::errc() || stop != end) return std::nullopt;
  return value;
}

// "corner3" with prefix "corner" selects member 3 of the list.
std::optional<Index> member(std::string_view name, std::string_view prefix,
                            const std::vector<Index>& list) {
  if (!name.starts_with(prefix)) return std::nullopt;
  const auto index = read_index(name.substr(prefix.size()));
  if (!index || *index >= list.size()) return std::nullopt;
  return list[*index];
}

[[noreturn]] void refuse(const Network& network, std::string_view name) {
  std::string singles = "center";
  if (const std::size_t count = network.corners.size(); count > 0) {
    singles += fmt::format(", corner0 to corner{0}, bullet0 to bullet{0}", count - 1);
  }
  throw InputError(fmt::format(
      "\"{}\" names no nodes; allowed: none, all, corners, bullets, perimeter, knots, {}, or an "
      "index from 0 to {}",
      name, singles, network.node_count() - 1));
}

}  // namespace

std::vector<Index> select_nodes(const Network& network, std::string_view name) {
  if (name == "none") return {};
  if (name == "all") {
    std::vector<Index> all(network.design.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  if (name == "corners") return network.corners;
  if (name == "bullets") return network.bullets;
  if (name == "perimeter") return network.perimeter;
  if (name == "knots") return network.knots;
  if (name == "center") return {network.center};
  if (const auto node = member(name, "corner", network.corners)) return {*node};
  if (const auto node = member(name, "bullet", network.bullets)) return {*node};
  if (const auto index = read_index(name); index && *index < network.design.size()) {
    return {static_cast<Index>(*index)};
  }
  refuse(network, name);
}

double median_rest_length(const Network& network) {
  if (network.segments.empty()) throw Error("median rest length of a network without segments");
  std::vector<double> lengths;
  lengths.reserve(network.segments.size());
  for (const Segment& segment : network.segments) lengths.push_back(segment.rest_length);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  if (lengths.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(lengths.begin(), middle)) / 2.0;
}

}  // namespace retiarius
