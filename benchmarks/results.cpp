#include "benchmarks/results.hpp"

#include <cmath>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"

namespace retiarius::benchmarks {

namespace {

// The processor's own name, where the system tells it.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line)) {
    if (line.rfind("model name", 0) != 0) continue;
    const auto colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

// Machine and build, as the first line of a CSV file.
std::string machine_line() {
  const BuildInfo build = build_info();
  return fmt::format("# {} {}, kernels {}, {} ({} processors)\n", build.version, build.revision,
                     kernel_name(), processor_name(), std::thread::hardware_concurrency());
}

}  // namespace

std::string results_csv(const std::vector<Measurement>& measurements) {
  std::string text = machine_line();
  text +=
      "nodes,n,s,across,bending,h,threads,solver,steps,step,assembly,factor,solve,rest,"
      "iterations,factorisations\n";
  for (const Measurement& m : measurements)
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{:.4e},{:.4e},{:.4e},{:.4e},{:.4e},{:.3f},{:.3f}\n",
                    m.nodes, m.member.n, m.member.s, m.member.across ? 1 : 0,
                    m.member.bending ? 1 : 0, m.h, m.threads, m.solver, m.steps, m.step, m.assembly,
                    m.factor, m.solve, m.rest, m.iterations, m.factorisations);
  return text;
}

std::string results_json(const std::vector<Measurement>& measurements) {
  const BuildInfo build = build_info();
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Measurement& m : measurements)
    list.push_back({{"nodes", m.nodes},
                    {"n", m.member.n},
                    {"s", m.member.s},
                    {"across", m.member.across},
                    {"bending", m.member.bending},
                    {"h", m.h},
                    {"threads", m.threads},
                    {"solver", m.solver},
                    {"steps", m.steps},
                    {"step", m.step},
                    {"assembly", m.assembly},
                    {"factor", m.factor},
                    {"solve", m.solve},
                    {"rest", m.rest},
                    {"iterations", m.iterations},
                    {"factorisations", m.factorisations}});
  const nlohmann::ordered_json all = {{"version", build.version},
                                      {"revision", build.revision},
                                      {"kernels", kernel_name()},
                                      {"processor", processor_name()},
                                      {"measurements", std::move(list)}};
  return all.dump(1) + "\n";
}

std::string flights_csv(const std::vector<FlightResult>& results) {
  std::string text = machine_line();
  text += "segments,nodes,way,taken,step,until,seconds,substeps,iterations,error\n";
  for (const FlightResult& r : results)
    text += fmt::format("{},{},{},{},{},{},{:.4e},{:.0f},{:.0f},{:.3e}\n", r.flight.segments,
                        r.nodes, to_string(r.flight.way), r.taken, r.flight.step, r.flight.until,
                        r.seconds, r.substeps, r.iterations, r.error);
  return text;
}

std::string flight_heading_text() {
  return fmt::format("{:>8} {:>8} {:>14} {:>14} {:>8} {:>9} {:>10} {:>10} {:>8}\n", "segments",
                     "nodes", "way", "taken", "time/s", "within/s", "sub-steps", "iter.",
                     "error/%");
}

std::string flight_text(const FlightResult& r) {
  return fmt::format("{:>8} {:>8} {:>14} {:>14} {:>8.2f} {:>9.1f} {:>10.0f} {:>10.0f} {:>8.3f}\n",
                     r.flight.segments, r.nodes, to_string(r.flight.way), r.taken, r.seconds,
                     r.flight.until, r.substeps, r.iterations, 100.0 * r.error);
}

std::string missions_csv(const std::vector<MissionTime>& times) {
  std::string text = machine_line();
  text += "mission,overrides,outcome,threads,simulated,seconds,steps,iterations,unconverged\n";
  for (const MissionTime& t : times)
    text += fmt::format("{},{},{},{},{:.6g},{:.4e},{},{},{}\n", t.name, t.overrides, t.outcome,
                        t.threads, t.simulated, t.seconds, t.steps, t.iterations, t.unconverged);
  return text;
}

std::string mission_heading_text() {
  return fmt::format("{:<24} {:<32} {:<10} {:>7} {:>8} {:>8} {:>8} {:>8}\n", "mission", "with",
                     "outcome", "threads", "within/s", "time/s", "steps", "iter.");
}

std::string mission_text(const MissionTime& t) {
  return fmt::format("{:<24} {:<32} {:<10} {:>7} {:>8.3g} {:>8.2f} {:>8} {:>8}\n", t.name,
                     t.overrides, t.outcome, t.threads, t.simulated, t.seconds, t.steps,
                     t.iterations);
}

double growth_exponent(const Measurement& small, const Measurement& large) {
  return std::log(large.step / small.step) /
         std::log(static_cast<double>(large.nodes) / static_cast<double>(small.nodes));
}

double parallel_efficiency(const Measurement& one, const Measurement& more) {
  return one.step * one.threads / (more.step * more.threads);
}

std::string heading_text() {
  return fmt::format(
      "{:>8} {:>4} {:>3} {:>7} {:>7} {:>7} {:>7} {:>9} {:>9} {:>8} {:>8} {:>8} {:>6} {:>7}\n",
      "nodes", "n", "s", "knots", "h/s", "threads", "solver", "step/ms", "assembly", "factor",
      "solve", "rest", "iter.", "factor.");
}

std::string measurement_text(const Measurement& m) {
  return fmt::format(
      "{:>8} {:>4} {:>3} {:>7} {:>7} {:>7} {:>7} {:>9.3f} {:>9.3f} {:>8.3f} {:>8.3f} {:>8.3f} "
      "{:>6.2f} "
      "{:>7.2f}\n",
      m.nodes, m.member.n, m.member.s,
      m.member.bending ? m.member.across ? "across" : "hinged" : "none", m.h, m.threads, m.solver,
      1e3 * m.step, 1e3 * m.assembly, 1e3 * m.factor, 1e3 * m.solve, 1e3 * m.rest, m.iterations,
      m.factorisations);
}

}  // namespace retiarius::benchmarks
