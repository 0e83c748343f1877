#include "retiarius/campaign/schema.hpp"

#include <fmt/format.h>

namespace retiarius {

const Table<CampaignSpec>& campaign_table() {
  static const Table<CampaignSpec> table = [] {
    Key<CampaignSpec> format;
    format.name = "format";
    format.type = KeyType::integer;
    format.meaning = "version of the campaign file's format";
    format.get = [](const CampaignSpec&) -> KeyValue { return std::int64_t{kCampaignFormat}; };
    format.set = [](CampaignSpec&, const KeyValue&) {};
    format.refuse = [](const KeyValue& value) {
      return std::get<std::int64_t>(value) == kCampaignFormat
                 ? std::string()
                 : fmt::format("this program reads format {}", kCampaignFormat);
    };
    return Table<CampaignSpec>(
        {"",
         "What the campaign is, before the first table.",
         "",
         false,
         {"plan", "variable", "group", "keep", "limits", "stop"}},
        {format, key("title", &CampaignSpec::title, "", "what the campaign is called"),
         key("mission", &CampaignSpec::mission, "", "file of the mission that is varied")
             .must_be_given()
             .file_path(),
         key("set", &CampaignSpec::sets, "",
             "overrides of the mission for every run, as `--set` takes them: \"path=value\""),
         key("kernels", &CampaignSpec::kernels, "",
             "code paths of the solver: auto, portable, avx2 or avx512; name one where machines "
             "differ")
             .refused_if([](const KeyValue& value) -> std::string {
               const auto& name = std::get<std::string>(value);
               const bool known =
                   name == "auto" || name == "portable" || name == "avx2" || name == "avx512";
               return known ? "" : "must be one of auto, portable, avx2, avx512";
             })});
  }();
  return table;
}

const Table<PlanSpec>& plan_table() {
  static const Table<PlanSpec> table(
      {"plan", "How many runs there are and how they are spread.", "design", false, {}},
      {word("design", &PlanSpec::design,
            {{"grid", Design::grid},
             {"list", Design::list},
             {"latin-hypercube", Design::latin_hypercube},
             {"sobol", Design::sobol},
             {"monte-carlo", Design::monte_carlo},
             {"saltelli", Design::saltelli}},
            "every combination (grid), the values row by row (list), random (monte-carlo), one in "
            "each of `runs` equal strata of every variable (latin-hypercube), a scrambled Sobol' "
            "sequence (sobol), or what Sobol' indices need (saltelli)")
           .must_be_given(),
       key("runs", &PlanSpec::runs, "",
           "how many; saltelli: how many blocks of k + 2 runs, for k inputs")
           .at_least(1)
           .up_to(1e9)
           .must_be_given()
           .only_for({"latin-hypercube", "sobol", "monte-carlo", "saltelli"}),
       key("seed", &PlanSpec::seed, "", "start of everything random").at_least(0)});
  return table;
}

const Table<VariableSpec>& variable_table() {
  static const Table<VariableSpec> table(
      {"variable",
       "What is varied. Variables are in the order of the file.",
       "distribution",
       true,
       {}},
      {key("name", &VariableSpec::name, "", "of its column: letters, digits, _ and -")
           .else_used("the last name of its path"),
       key("set", &VariableSpec::sets, "",
           "what it sets: a dotted path of the mission or several, as `--set` takes them; "
           "`target.position[0]` is one number of a list")
           .must_be_given(),
       word("distribution", &VariableSpec::distribution,
            {{"values", Distribution::values},
             {"uniform", Distribution::uniform},
             {"normal", Distribution::normal},
             {"truncated-normal", Distribution::truncated_normal},
             {"lognormal", Distribution::lognormal},
             {"uniform-attitude", Distribution::uniform_attitude},
             {"cone", Distribution::cone}},
            "numbers as given (values); an attitude of which all are alike, set as a rotation "
            "vector in degrees (uniform-attitude); a direction uniform in a cone, set as a vector "
            "(cone)")
           .must_be_given(),
       key("values", &VariableSpec::values, "", "for the designs grid and list")
           .must_be_given()
           .only_for({"values"}),
       key("low", &VariableSpec::low, "", "the least value")
           .must_be_given()
           .only_for({"uniform", "truncated-normal"}),
       key("high", &VariableSpec::high, "", "the largest value")
           .must_be_given()
           .only_for({"uniform", "truncated-normal"}),
       key("mean", &VariableSpec::mean, "", "of the normal distribution, before truncation")
           .must_be_given()
           .only_for({"normal", "truncated-normal"}),
       key("median", &VariableSpec::median, "", "half of all values are smaller")
           .above(0)
           .must_be_given()
           .only_for({"lognormal"}),
       key("deviation", &VariableSpec::deviation, "",
           "standard deviation, before truncation; lognormal: of the natural logarithm")
           .above(0)
           .must_be_given()
           .only_for({"normal", "truncated-normal", "lognormal"}),
       key("axis", &VariableSpec::axis, "", "of the cone, of any length").only_for({"cone"}),
       key("half_angle_deg", &VariableSpec::half_angle_deg, "deg",
           "of the cone; 180: every direction alike")
           .above(0)
           .up_to(180)
           .must_be_given()
           .only_for({"cone"}),
       key("length", &VariableSpec::length, "", "of the vector that is set")
           .above(0)
           .only_for({"cone"}),
       key("levels", &VariableSpec::levels, "",
           "design grid: how many values, the quantiles at the middles of as many equal shares")
           .at_least(1)
           .up_to(1e6)
           .only_for({"uniform", "normal", "truncated-normal", "lognormal"})});
  return table;
}

const Table<GroupSpec>& group_table() {
  static const Table<GroupSpec> table(
      {"group", "Variables that are correlated, by a Gaussian copula.", "", true, {}},
      {key("variables", &GroupSpec::variables, "", "their names, each of one number")
           .must_be_given(),
       key("correlation", &GroupSpec::correlation, "",
           "matrix of their normal scores, row by row: symmetric, ones on the diagonal, positive "
           "definite")
           .at_least(-1)
           .up_to(1)
           .must_be_given()});
  return table;
}

const Table<KeepSpec>& keep_table() {
  static const Table<KeepSpec> table(
      {"keep", "What stays of each run beside its row in the database.", "what", false, {}},
      {word("what", &KeepSpec::what,
            {{"measures", Keep::measures},
             {"history", Keep::history},
             {"failures", Keep::failures},
             {"sample", Keep::sample},
             {"all", Keep::all}},
            "nothing more (measures); the history (history); the whole folder of results, frames "
            "and report included, of runs without success (failures), of a sample or of all")
           .must_be_given(),
       key("ids", &KeepSpec::ids, "", "ids of the sample").at_least(0).only_for({"sample"}),
       key("every", &KeepSpec::every, "", "each run whose id is a multiple; 0: none so")
           .at_least(0)
           .only_for({"sample"})});
  return table;
}

const Table<LimitSpec>& limit_table() {
  static const Table<LimitSpec> table(
      {"limits",
       "Of each run; one that reaches them ends there, and its outcome says so.",
       "",
       false,
       {}},
      {key("time", &LimitSpec::time, "s", "of the mission").above(0).or_infinite(),
       key("steps", &LimitSpec::steps, "", "time steps; 0: no limit").at_least(0),
       key("wall_clock", &LimitSpec::wall_clock, "s", "of the clock on the wall")
           .above(0)
           .or_infinite(),
       key("attempts", &LimitSpec::attempts, "",
           "how often a run is begun whose process dies, before it is recorded as killed")
           .at_least(1)
           .up_to(1e6)});
  return table;
}

const Table<StopSpec>& stop_table() {
  static const Table<StopSpec> table(
      {"stop",
       "When enough is known. Decided on the runs 0 to n - 1, for n a multiple of the batch, so "
       "that it does not depend on which runs ended first.",
       "",
       false,
       {}},
      {key("width", &StopSpec::width, "",
           "no more runs once Wilson's interval of the success rate is narrower")
           .above(0)
           .up_to(1)
           .must_be_given(),
       key("confidence", &StopSpec::confidence, "", "of the interval").above(0).up_to(0.999999),
       key("batch", &StopSpec::batch, "", "runs between decisions").at_least(1).up_to(1e9)});
  return table;
}

}  // namespace retiarius
