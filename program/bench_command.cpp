// retiarius bench: times on this machine of steps, flights and missions.
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/results.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "retiarius/base/error.hpp"
#include "retiarius/base/parallel.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius::program {

namespace {

using namespace benchmarks;

struct BenchArguments {
  ComputingArguments computing;
  std::string what = "family", mission;
  std::vector<std::string> overrides;
  std::vector<int> segments{2, 4, 10};
  std::vector<int> edges;                   // empty: the family's own
  int largest = 0, steps = 0, repeats = 0;  // 0: what suits the rows asked for
  bool json = false, quick = false, references = false;
  std::string csv;
};

int or_else(int given, int otherwise) { return given > 0 ? given : otherwise; }

void save_csv(const BenchArguments& arguments, const std::string& text) {
  if (!arguments.csv.empty()) write_atomically(arguments.csv, text);
}

// Edges that double the number of nodes from one net to the next.
std::vector<int> growing_edges(int first) {
  std::vector<int> edges;
  double n = first;
  while (n < 200.0) {
    edges.push_back(static_cast<int>(n));
    n *= 1.414;
  }
  return edges;
}

// From the net of 631 nodes up, or of the edges that were asked for.
std::vector<Member> family(const BenchArguments& arguments) {
  const int largest = or_else(arguments.largest, arguments.edges.empty() ? 10000 : 1000000);
  std::vector<Member> members;
  for (const auto& [s, across] : {std::pair{0, true}, {3, true}, {9, true}, {9, false}}) {
    for (const int n : arguments.edges.empty() ? growing_edges(s == 0 ? 7 : 5) : arguments.edges) {
      Member m;
      m.n = n;
      m.s = s;
      m.across = across;
      if (count_network(net_of(m)).nodes > 1.05 * largest) continue;
      members.push_back(m);
    }
  }
  return members;
}

void finish(const BenchArguments& arguments, const std::vector<Measurement>& all) {
  if (arguments.json) print(results_json(all));
  save_csv(arguments, results_csv(all));
}

void bench_family(const BenchArguments& arguments) {
  std::vector<Measurement> all;
  if (!arguments.json) print(heading_text());
  for (const Member& member : family(arguments)) {
    for (const auto& [h, newton] :
         {std::pair{0.01, Newton::converged}, {0.001, Newton::converged}, {0.01, Newton::single}}) {
      Settings settings;
      settings.h = h;
      settings.newton = newton;
      settings.steps = or_else(arguments.steps, arguments.quick ? 10 : 100);
      settings.repeats = or_else(arguments.repeats, arguments.quick ? 1 : 5);
      all.push_back(measure(member, settings));
      if (!arguments.json) print(measurement_text(all.back()));
      flush_output();
    }
  }
  finish(arguments, all);
}

// Nets of about 8,000, 10,000, 30,000 and 100,000 nodes by one thread and by two.
void bench_threads(const BenchArguments& arguments) {
  std::vector<Measurement> all;
  if (!arguments.json) print(heading_text());
  const double largest = or_else(arguments.largest, 110000);
  std::string findings;
  Measurement middle;  // of about 10,000 nodes, one thread
  for (const int n : {19, 21, 37, 69}) {
    const Member member{n, 3};
    const double nodes = count_network(net_of(member)).nodes;
    if (nodes > largest) break;
    Settings settings;
    settings.steps = or_else(arguments.steps, arguments.quick ? 3 : 100);
    settings.repeats = or_else(arguments.repeats, arguments.quick || nodes > 50000.0 ? 1 : 3);
    const std::size_t first = all.size();
    for (const int threads : {1, 2}) {
      set_threads(threads);
      all.push_back(measure(member, settings));
      if (!arguments.json) print(measurement_text(all.back()));
      flush_output();
    }
    findings += fmt::format("{} nodes: two threads at {:.0f} % efficiency\n", all.back().nodes,
                            100.0 * parallel_efficiency(all[first], all[first + 1]));
    if (n == 21) middle = all[first];
    if (n == 69)
      findings += fmt::format("time of a step ~ nodes^{:.2f} from {} to {} nodes, one thread\n",
                              growth_exponent(middle, all[first]), middle.nodes, all[first].nodes);
  }
  if (!arguments.json) print("\n" + findings);
  finish(arguments, all);
}

void tell_flight(const FlightResult& result) {
  print(flight_text(result));
  flush_output();
}

void bench_flights(const BenchArguments& arguments) {
  FlightsOptions options;
  options.segments = arguments.segments;
  options.until = arguments.quick ? 0.1 : 2.0;
  options.references = arguments.references;
  print(flight_heading_text());
  save_csv(arguments, flights_csv(measure_flights(options, tell_flight)));
}

void bench_mission(const BenchArguments& arguments) {
  if (arguments.mission.empty()) throw InputError("bench mission needs --mission FILE");
  print(mission_heading_text());
  const MissionTime time = time_mission(arguments.mission, arguments.overrides);
  print(mission_text(time));
  save_csv(arguments, missions_csv({time}));
}

void bench(const BenchArguments& arguments) {
  arguments.computing.apply();
  if (arguments.json && (arguments.what == "flights" || arguments.what == "mission"))
    throw InputError("--json: flights and missions are told as a table or by --csv");
  if (arguments.what == "family") bench_family(arguments);
  if (arguments.what == "threads") bench_threads(arguments);
  if (arguments.what == "flights") bench_flights(arguments);
  if (arguments.what == "mission") bench_mission(arguments);
}

}  // namespace

void add_bench_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("bench", "Time the solver on nets of growing size");
  auto arguments = std::make_shared<BenchArguments>();
  command
      ->add_option("ROWS", arguments->what,
                   "family: steps of nets of growing size (the default); threads: of large nets by "
                   "one thread and two; flights: a stiff net by each integrator at equal accuracy; "
                   "mission: a whole mission")
      ->type_name("family|threads|flights|mission")
      ->check(quiet(CLI::IsMember({"family", "threads", "flights", "mission"})));
  command
      ->add_option("--largest", arguments->largest,
                   "Nodes of the largest net; default 10000, of threads 110000")
      ->type_name("N")
      ->check(quiet(CLI::Range(600, 1000000)));
  command
      ->add_option("--edges", arguments->edges,
                   "Meshes along the edge of the family's nets, instead of its own")
      ->type_name("N,...")
      ->delimiter(',')
      ->check(quiet(CLI::Range(2, 200)));
  command->add_option("--segments", arguments->segments, "Of a piece in flights; default 2,4,10")
      ->type_name("N,...")
      ->delimiter(',')
      ->check(quiet(CLI::Range(1, 100)));
  command->add_option("--steps", arguments->steps, "Steps of a repeat; default 100")
      ->type_name("N")
      ->check(quiet(CLI::Range(1, 1000000)));
  command
      ->add_option("--repeats", arguments->repeats,
                   "Of which the median is told; default 5, of threads 3 or 1")
      ->type_name("N")
      ->check(quiet(CLI::Range(1, 1000)));
  command->add_flag("--references", arguments->references,
                    "Compare flights with one of half the explicit sub-step, not with their own");
  command->add_option("--mission", arguments->mission, "The mission file to time")
      ->type_name("FILE");
  command->add_option("--set", arguments->overrides, "Override one key of the mission")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--quick", arguments->quick,
                    "A taste: 10 steps once instead of 100 steps five times; flights of 0.1 s");
  command->add_flag("--json", arguments->json, "Print JSON instead of a table");
  command->add_option("--csv", arguments->csv, "Also write the results to a CSV file")
      ->type_name("FILE");
  arguments->computing.add_to(*command);
  command->callback([arguments] { bench(*arguments); });
}

}  // namespace retiarius::program
