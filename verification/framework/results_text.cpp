#include "verification/framework/results_text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace retiarius::verification {

namespace {

std::string unit_text(const std::string& unit) { return unit == "1" ? "" : " " + unit; }

std::string error_text(double error, ErrorKind kind, const std::string& unit) {
  if (kind == ErrorKind::absolute) return fmt::format("{:.2g}{}", error, unit_text(unit));
  return fmt::format("{:.2g}", error);
}

std::string comparison_text(const Comparison& c) {
  return fmt::format("  {:<4} {:<52} {:>14} {:>14}{:<6} {:>9} <= {:<9} {}\n",
                     c.passes() ? "ok" : "MISS", c.quantity, number_text(c.ours),
                     number_text(c.reference), unit_text(c.unit), error_text(c.error(), c.kind, ""),
                     error_text(c.bound, c.kind, ""), c.source);
}

}  // namespace

std::string number_text(double value) {
  std::string text = fmt::format("{:.8g}", value);
  return text == "-0" ? "0" : text;
}

std::string list_text(const std::vector<const Case*>& cases) {
  std::size_t width = 0;
  for (const Case* c : cases) width = std::max(width, c->name.size());
  std::string text;
  const Case* before = nullptr;
  for (const Case* c : cases) {
    if (!before || before->group != c->group) text += fmt::format("{}\n", title(c->group));
    before = c;
    text += fmt::format("  {:<{}}  {}{}\n", c->name, width, c->title,
                        c->figure.empty() ? "" : " (" + c->figure + ")");
  }
  return text;
}

std::string case_text(const Rung& rung) {
  const CaseResult& r = rung.result;
  std::string text =
      fmt::format("{} - {} ({:.1f} s)\n", rung.of->name, rung.of->title, r.wall_time);
  if (!r.comparisons.empty())
    text += fmt::format("       {:<52} {:>14} {:>14}{:<6} {:>9}    {:<9} {}\n", "quantity", "ours",
                        "reference", "", "error", "bound", "source");
  for (const Comparison& c : r.comparisons) text += comparison_text(c);
  if (r.comparisons.empty() && r.failure.empty())
    text += "  no published values: drawn, with our own convergence\n";
  if (!r.failure.empty()) text += fmt::format("  FAILED: {}\n", r.failure);
  return text + "\n";
}

std::string verdict_text(const std::vector<Rung>& rungs) {
  std::size_t passed = 0, comparisons = 0, within = 0;
  std::string missed;
  for (const Rung& rung : rungs) {
    passed += rung.result.passes() ? 1 : 0;
    for (const Comparison& c : rung.result.comparisons) {
      ++comparisons;
      within += c.passes() ? 1 : 0;
    }
    if (!rung.result.passes()) missed += fmt::format(" {}", rung.of->name);
  }
  std::string text =
      fmt::format("{} of {} cases passed, {} of {} comparisons within their bounds\n", passed,
                  rungs.size(), within, comparisons);
  if (!missed.empty()) text += fmt::format("missed:{}\n", missed);
  return text;
}

}  // namespace retiarius::verification
