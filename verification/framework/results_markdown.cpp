#include "verification/framework/results_markdown.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "verification/framework/comparison_text.hpp"

namespace retiarius::verification {

namespace {

constexpr const char* kOpening =
    "# Verification\n\n"
    "Is it right? Every case below computes something whose answer is known exactly, published, "
    "or\n"
    "computed independently, and compares. Each bound is argued for: by the order of the\n"
    "discretisation, by the digits of what was published, or by round-off. Tests scale each law by "
    "two\nand check that the cases which claim to guard it miss their bounds.\n\n"
    "```sh\n"
    "retiarius verify                    # all cases; table, verification.html, exit code 1 on a "
    "miss\n"
    "retiarius verify --quick            # the same in a short form, as the tests run it\n"
    "retiarius verify --list             # what there is\n"
    "retiarius verify heavy-cantilever   # one case\n"
    "```\n\n"
    "Missions and references lie in `verification/`, a folder a case. This page is written by\n"
    "`scripts/update-verification.sh` from the full form; errors are relative (rel.) or in the\n"
    "unit given (abs.: the quantity has none). Digits that round-off decides are left out.\n";

// Text in which nothing is mistaken for Markdown.
std::string plain(const std::string& text) {
  std::string safe;
  for (char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (std::string("*_|`[]\\").find(c) != std::string::npos)
      (safe += '\\') += c;
    else
      safe += c == '\n' ? ' ' : c;
  }
  return safe;
}

std::string verdict_markdown(const CaseResult& result) {
  const std::string word = verdict_word(result);
  return result.passes() ? word : fmt::format("**{}**", word);
}

std::string summary_markdown(const std::vector<Rung>& rungs) {
  const Tally t = tally(rungs);
  std::string text = fmt::format(
      "\n**{} of {} cases passed, {} of {} comparisons are within their bounds.**\n\n"
      "| case | paper | comparisons | verdict |\n|---|---|---|---|\n",
      t.passed, t.cases, t.within, t.comparisons);
  for (const Rung& rung : rungs)
    text += fmt::format("| [{}](#{}) | {} | {} | {} |\n", plain(rung.of->title), rung.of->name,
                        plain(rung.of->figure),
                        rung.result.comparisons.empty()
                            ? "no published values"
                            : fmt::format("{}", rung.result.comparisons.size()),
                        verdict_markdown(rung.result));
  return text;
}

std::string table_markdown(const std::vector<Comparison>& comparisons) {
  if (comparisons.empty()) return "";
  std::string text =
      "| quantity | ours | reference | error | bound | | source |\n"
      "|---|---|---|---|---|---|---|\n";
  std::vector<std::string> arguments;
  for (const Comparison& c : comparisons) {
    auto at = std::find(arguments.begin(), arguments.end(), c.argument);
    if (at == arguments.end()) at = arguments.insert(arguments.end(), c.argument);
    const std::string unit = plain(unit_text(c.unit));
    text += fmt::format("| {} | {}{} | {}{} | {} | {} ({}) | {} | {} |\n", plain(c.quantity),
                        ours_text(c), unit, reference_text(c), unit, plain(error_text(c)),
                        plain(bound_text(c)), at - arguments.begin() + 1,
                        c.passes() ? "ok" : "**MISS**", plain(c.source));
  }
  text += "\nWhy the bounds are what they are:\n\n";
  for (std::size_t k = 0; k < arguments.size(); ++k)
    text += fmt::format("{}. {}\n", k + 1, plain(arguments[k]));
  return text + "\n";
}

std::string case_markdown(const Rung& rung, const std::string& figures) {
  const Case& c = *rung.of;
  const CaseResult& r = rung.result;
  std::string text = fmt::format("\n<a id=\"{}\"></a>\n\n### {}\n\n", c.name, plain(c.title));
  text += fmt::format("`retiarius verify {}`", c.name);
  text += c.figure.empty() ? ".\n\n" : fmt::format("; the paper's {}.\n\n", plain(c.figure));
  if (!r.failure.empty()) text += fmt::format("**Broke off:** {}\n\n", plain(r.failure));
  text += plain(c.about) + "\n\n";
  if (r.comparisons.empty() && r.failure.empty())
    text += "No published values: drawn, with our own convergence.\n\n";
  for (std::size_t k = 0; k < r.charts.size(); ++k) {
    const Chart& chart = r.charts[k];
    text += fmt::format("![{}]({}/{})\n\n*{}.", plain(chart.title), figures, figure_name(c, k),
                        plain(chart.title));
    if (!chart.caption.empty()) text += fmt::format(" {}", plain(chart.caption));
    if (!chart.source.empty()) text += fmt::format(" Source: {}.", plain(chart.source));
    text += "*\n\n";
  }
  text += table_markdown(r.comparisons);
  for (const std::string& note : r.notes) text += plain(note) + "\n\n";
  return text;
}

std::string recorded_markdown(const Recorded& recorded) {
  if (recorded.comparisons.empty()) return "";
  std::string text = "\n## Independent programs\n\n";
  for (const std::string& about : recorded.about) text += plain(about) + "\n\n";
  text += "| scene | quantity | ours | other | difference | bound |\n|---|---|---|---|---|---|\n";
  for (const RecordedComparison& c : recorded.comparisons)
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", plain(c.scene), plain(c.quantity),
                        recorded_text(c.ours, 7, c.unit), recorded_text(c.theirs, 7, c.unit),
                        recorded_text(c.difference, 2, c.unit), recorded_text(c.bound, 2, c.unit));
  text += "\n| scene | time, ours | time, other |\n|---|---|---|\n";
  for (const RecordedScene& s : recorded.scenes)
    text += fmt::format("| {} | {} s | {} s |\n", plain(s.name), printed(s.our_time, 2),
                        printed(s.their_time, 2));
  return text;
}

}  // namespace

std::string figure_name(const Case& of, std::size_t chart) {
  return fmt::format("{}-{}.svg", of.name, chart + 1);
}

std::string results_markdown(const std::vector<Rung>& rungs, const Recorded& recorded,
                             const std::string& figures, bool quick) {
  std::string text = kOpening;
  if (quick) text += "\n**This copy is of the quick form.**\n";
  text += summary_markdown(rungs);
  const Case* before = nullptr;
  for (const Rung& rung : rungs) {
    if (!before || before->group != rung.of->group)
      text += fmt::format("\n## {}\n", title(rung.of->group));
    before = rung.of;
    text += case_markdown(rung, figures);
  }
  text += recorded_markdown(recorded);
  // Paragraphs are one blank line apart, and the file ends with one line end.
  for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;) text.erase(at, 1);
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

}  // namespace retiarius::verification
