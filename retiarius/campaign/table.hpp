// What a campaign found, run by run: the table that statistics and report read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace retiarius {

struct CampaignRow {
  std::int64_t id = 0;
  std::vector<double> inputs;    // in the order of CampaignTable::inputs
  std::vector<double> measures;  // in the order of CampaignTable::measures; NaN: missing
  std::string outcome;          // how the run ended: "finished", "failed", "timeout", "killed", ...
  std::optional<bool> success;  // absent where the run did not come to an answer
  std::string reason;           // why it ended so; empty where there is nothing to say
  std::string command;          // repeats this run alone
  std::string replay;           // path or address of its kept report; empty: none kept
};

// How the inputs of the runs were chosen, as far as statistics depend on it.
enum class CampaignDesign {
  independent,  // each run for itself: random, or spread evenly over the inputs' distributions
  prescribed,   // grid or list: the runs are chosen by hand, so a share of them is no probability
  saltelli,     // blocks of inputs + 2 runs, from which Sobol indices follow (sobol_indices.hpp)
};

struct CampaignTable {
  std::string title;
  CampaignDesign design = CampaignDesign::independent;
  std::vector<std::string> inputs;
  std::vector<std::string> measures;
  std::vector<CampaignRow> runs;   // by ascending id; runs that are not done are left out
  std::int64_t planned = 0;        // runs that the campaign would have in all; 0: unknown
  std::vector<std::string> facts;  // lines for the page's head: mission, seed, version, limits
};

}  // namespace retiarius
