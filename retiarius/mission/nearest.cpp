#include "retiarius/mission/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace retiarius {

int edit_distance(const std::string& a, const std::string& b) {
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  };
  const std::size_t n = b.size();
  std::vector<int> before(n + 1), last(n + 1), row(n + 1);
  for (std::size_t j = 0; j <= n; ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= n; ++j) {
      const int replaced = last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1])) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = std::exchange(last, row);
  }
  return last[n];
}

namespace {

std::size_t common_beginning(const std::string& a, const std::string& b) {
  const auto ends = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(ends.first - a.begin());
}

}  // namespace

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 100;  // nobody mistypes a name into a page of text
  if (word.empty() || word.size() > kLongest) return std::nullopt;
  const int limit = std::max(2, static_cast<int>(word.size()) / 3);
  std::optional<std::string> best;
  int least = limit + 1;
  std::size_t longest = 0;  // beginning in common
  for (const std::string& name : names) {
    const int distance = edit_distance(word, name);
    if (distance > limit || distance >= static_cast<int>(std::max(word.size(), name.size()))) {
      continue;
    }
    const std::size_t alike = common_beginning(word, name);
    if (distance < least || (distance == least && alike > longest)) {
      least = distance;
      longest = alike;
      best = name;
    }
  }
  return best;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& names) {
  if (const auto name = nearest(word, names)) return fmt::format(", did you mean {}?", *name);
  return fmt::format("; allowed: {}", fmt::join(names, ", "));
}

}  // namespace retiarius
