#include "retiarius/campaign/read_campaign.hpp"

#include <filesystem>
#include <sstream>

#include "retiarius/campaign/check_campaign.hpp"
#include "retiarius/campaign/schema.hpp"
#include "retiarius/mission/table_source.hpp"
#include "retiarius/mission/toml_file.hpp"

namespace retiarius {

namespace {

const TomlFileKind kCampaignFile{"campaign",
                                 "a campaign needs at least mission, [plan] and a [[variable]]"};

// "target.position[0]" -> "position0"; "net.thread.radius" -> "radius".
std::string last_name(const std::string& path) {
  const auto dot = path.rfind('.');
  std::string name;
  for (const char c : dot == std::string::npos ? path : path.substr(dot + 1))
    if (c != '[' && c != ']') name += c;
  return name;
}

void read_variables(const TableSource& root, CampaignSpec& campaign) {
  for (const TableSource& source : root.tables("variable", false)) {
    VariableSpec& variable = campaign.variables.emplace_back();
    source.read(variable_table(), variable);
    variable.place = source.place();
    if (variable.name.empty()) variable.name = last_name(variable.sets.front());
  }
}

void read_groups(const TableSource& root, CampaignSpec& campaign) {
  for (const TableSource& source : root.tables("group", false)) {
    GroupSpec& group = campaign.groups.emplace_back();
    source.read(group_table(), group);
    group.place = source.place();
  }
}

std::string canonical_text(const toml::table& root) {
  std::ostringstream text;
  text << toml::toml_formatter(root);
  return text.str();
}

}  // namespace

CampaignSpec parse_campaign(const std::string& text, const std::string& name,
                            const std::string& folder) {
  const toml::table table = parse_toml(text, name, kCampaignFile);
  Places places(name);
  const TableSource root(table, "", {name, 0, 0}, places);
  CampaignSpec campaign;
  campaign.folder = folder;
  root.read(campaign_table(), campaign);
  campaign.sets_place = places.of("set");
  const auto plan = root.table("plan");
  if (!plan) throw InputError(root.place(), "plan is missing: add a table [plan]");
  plan->read(plan_table(), campaign.plan);
  read_variables(root, campaign);
  read_groups(root, campaign);
  if (const auto keep = root.table("keep")) keep->read(keep_table(), campaign.keep);
  if (const auto limits = root.table("limits")) limits->read(limit_table(), campaign.limits);
  if (const auto stop = root.table("stop")) stop->read(stop_table(), campaign.stop);
  check_campaign(campaign, places);
  campaign.canonical = canonical_text(table);
  return campaign;
}

CampaignSpec read_campaign(const std::string& path) {
  const std::string text = read_toml_file(path, kCampaignFile);
  const auto folder = std::filesystem::absolute(path).lexically_normal().parent_path();
  CampaignSpec campaign = parse_campaign(text, path, folder.string());
  campaign.file = path;
  return campaign;
}

}  // namespace retiarius
