#include "retiarius/campaign/check_campaign.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "retiarius/campaign/copula.hpp"
#include "retiarius/campaign/sobol_sequence.hpp"
#include "retiarius/mission/key.hpp"
#include "retiarius/mission/nearest.hpp"

namespace retiarius {

namespace {

std::string path_of(std::size_t index, const char* key) {
  return fmt::format("variable[{}].{}", index, key);
}

void check_name(const CampaignSpec& campaign, std::size_t index, const Places& places) {
  const std::string& name = campaign.variables[index].name;
  const SourcePlace place = places.of(path_of(index, "name"));
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return c < 128 && (std::isalnum(c) != 0 || c == '_' || c == '-');
  });
  if (name.empty() || !plain)
    throw InputError(place, fmt::format("{} = {}: may have letters, digits, _ and - only",
                                        path_of(index, "name"), quoted(name)));
  for (std::size_t i = 0; i < index; ++i) {
    if (campaign.variables[i].name != name) continue;
    throw InputError(place, fmt::format("{} is called {}, as variable[{}] is; give it a name of "
                                        "its own",
                                        fmt::format("variable[{}]", index), quoted(name), i));
  }
}

void check_range(const VariableSpec& variable, std::size_t index, const Places& places) {
  const bool bounded = variable.distribution == Distribution::uniform ||
                       variable.distribution == Distribution::truncated_normal;
  if (bounded && !(variable.low < variable.high))
    throw InputError(places.of(path_of(index, "high")),
                     fmt::format("{} = {}: must be greater than low = {}", path_of(index, "high"),
                                 number_text(variable.high), number_text(variable.low)));
  // Beyond some 8 deviations the truncated normal's quantiles lose their digits.
  const double low = (variable.low - variable.mean) / variable.deviation;
  const double high = (variable.high - variable.mean) / variable.deviation;
  if (variable.distribution == Distribution::truncated_normal && (low > 6.0 || high < -6.0))
    throw InputError(places.of(path_of(index, "low")),
                     fmt::format("{} and high lie more than 6 deviations to one side of the mean",
                                 path_of(index, "low")));
  if (variable.distribution == Distribution::cone && variable.axis.norm() == 0.0)
    throw InputError(places.of(path_of(index, "axis")),
                     fmt::format("{} must not be zero", path_of(index, "axis")));
}

// Whether distribution and design fit each other.
void check_design(const CampaignSpec& campaign, std::size_t index, const Places& places) {
  const VariableSpec& variable = campaign.variables[index];
  const Design design = campaign.plan.design;
  const bool has_values = variable.distribution == Distribution::values;
  const SourcePlace place = places.of(path_of(index, "distribution"));
  const std::string what = path_of(index, "distribution");
  if (design == Design::list && !has_values)
    throw InputError(place, fmt::format("{}: design \"list\" takes \"values\" only", what));
  if (design == Design::list && variable.values.size() != campaign.variables.front().values.size())
    throw InputError(
        places.of(path_of(index, "values")),
        fmt::format("{} has {} numbers, variable[0].values has {}; a list has a row for each run",
                    path_of(index, "values"), variable.values.size(),
                    campaign.variables.front().values.size()));
  if (design == Design::grid && variable.dimensions() > 1)
    throw InputError(place, fmt::format("{}: design \"grid\" takes variables of one number", what));
  if (design == Design::grid && !has_values && variable.levels == 0)
    throw InputError(variable.place, fmt::format("{} is missing: design \"grid\" needs it, or "
                                                 "distribution = \"values\"",
                                                 path_of(index, "levels")));
  const bool sampled = design != Design::list && design != Design::grid;
  if (sampled && has_values)
    throw InputError(place, fmt::format("{}: \"values\" is for the designs grid and list", what));
  if (sampled && variable.levels > 0)
    throw InputError(places.of(path_of(index, "levels")),
                     fmt::format("{} is for the design grid", path_of(index, "levels")));
}

void check_paths(const CampaignSpec& campaign, const Places& places) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < campaign.variables.size(); ++i) {
    for (const std::string& path : campaign.variables[i].sets) {
      const SourcePlace place = places.of(path_of(i, "set"));
      if (path.find('=') != std::string::npos)
        throw InputError(place, fmt::format("{} = {}: a path alone is expected, without a value",
                                            path_of(i, "set"), quoted(path)));
      if (!taken.insert(path).second)
        throw InputError(place,
                         fmt::format("{} = {}: is set already", path_of(i, "set"), quoted(path)));
      if (path == "seed")
        throw InputError(place, fmt::format("{} = {}: every run has a seed of its own, made from "
                                            "plan.seed",
                                            path_of(i, "set"), quoted(path)));
    }
  }
}

void check_groups(const CampaignSpec& campaign, const Places& places) {
  std::vector<std::string> names;
  for (const VariableSpec& variable : campaign.variables) names.push_back(variable.name);
  std::set<std::string> taken;
  for (std::size_t g = 0; g < campaign.groups.size(); ++g) {
    const GroupSpec& group = campaign.groups[g];
    const std::string path = fmt::format("group[{}].variables", g);
    const SourcePlace place = places.of(path);
    const Design design = campaign.plan.design;
    if (design == Design::saltelli || design == Design::grid || design == Design::list)
      throw InputError(group.place, fmt::format("group[{}]: the designs saltelli, grid and list "
                                                "take independent variables only",
                                                g));
    for (const std::string& name : group.variables) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        throw InputError(place, fmt::format("{}: there is no variable {}{}", path, quoted(name),
                                            suggestion(name, names)));
      const auto at = static_cast<std::size_t>(found - names.begin());
      if (campaign.variables[at].dimensions() > 1)
        throw InputError(place, fmt::format("{}: {} is no variable of one number", path, name));
      if (!taken.insert(name).second)
        throw InputError(place, fmt::format("{}: {} is in a group already", path, name));
    }
    const std::string why = correlation_problem(group);
    if (why.empty()) continue;
    const std::string key = fmt::format("group[{}].correlation", g);
    throw InputError(places.of(key), fmt::format("{}: {}", key, why));
  }
}

void check_sample(const KeepSpec& keep, const Places& places) {
  if (keep.what != Keep::sample) return;
  if (keep.ids.empty() && keep.every == 0)
    throw InputError(places.of("keep"), "keep.what = \"sample\" needs keep.ids or keep.every");
  for (const double id : keep.ids)
    if (id != std::floor(id))
      throw InputError(places.of("keep.ids"),
                       fmt::format("keep.ids: {} is no id", number_text(id)));
}

void check_dimensions(const CampaignSpec& campaign, const Places& places) {
  const std::size_t inputs = campaign.input_names().size();
  const std::size_t needed = campaign.plan.design == Design::saltelli ? 2 * inputs : inputs;
  const bool sobol =
      campaign.plan.design == Design::sobol || campaign.plan.design == Design::saltelli;
  if (!sobol || needed <= static_cast<std::size_t>(SobolSequence::kDimensions)) return;
  throw InputError(places.of("plan.design"),
                   fmt::format("plan.design: {} inputs need a sequence of {} dimensions, and there "
                               "are {}; use latin-hypercube or monte-carlo",
                               inputs, needed, SobolSequence::kDimensions));
}

}  // namespace

void check_campaign(const CampaignSpec& campaign, const Places& places) {
  if (campaign.variables.empty())
    throw InputError(places.of(""),
                     "variable is missing: a campaign needs at least one "
                     "[[variable]]");
  for (std::size_t i = 0; i < campaign.variables.size(); ++i) {
    check_name(campaign, i, places);
    check_range(campaign.variables[i], i, places);
    check_design(campaign, i, places);
  }
  check_paths(campaign, places);
  check_groups(campaign, places);
  check_sample(campaign.keep, places);
  check_dimensions(campaign, places);
}

}  // namespace retiarius
