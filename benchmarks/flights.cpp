#include "benchmarks/flights.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "benchmarks/plain_explicit.hpp"
#include "retiarius/motion/integrator.hpp"
#include "retiarius/motion/stable_step.hpp"

namespace retiarius::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRow = 0.1;    // s, between records of the area
constexpr double kShort = 0.2;  // s
constexpr double kSpeed = 2.5;
const double kAngle = radians(36.0);

Vec3 shot(const Network& network, std::size_t corner) {
  const Vec3 out = network.design[network.corners[corner]].normalized();
  return kSpeed * (std::cos(kAngle) * Vec3::UnitZ() + std::sin(kAngle) * out);
}

double mouth_area(const Network& network, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  const Vec3 first = x[network.corners[0]];
  for (std::size_t k = 1; k + 1 < network.corners.size(); ++k)
    sum += 0.5 * (x[network.corners[k]] - first).cross(x[network.corners[k + 1]] - first);
  return std::abs(sum.z());
}

void fly_plainly(const Network& network, const Flight& flight, FlightResult& result) {
  PlainExplicit net(network);
  for (std::size_t k = 0; k < network.bullets.size(); ++k)
    net.v[network.bullets[k]] = shot(network, k);
  const int count = static_cast<int>(std::ceil(kRow / (flight.share * net.stable_step())));
  const int rows = static_cast<int>(std::lround(flight.until / kRow));
  for (int row = 1; row <= rows; ++row) {
    for (int k = 0; k < count; ++k) net.step(kRow / count);
    result.areas.push_back(mouth_area(network, net.x));
  }
  result.substeps = static_cast<double>(count) * rows;
  result.taken = "plain explicit";
}

void fly_simulated(const Network& network, const Flight& flight, FlightResult& result) {
  const std::vector<Body> none;
  Simulation simulation(network, none, initial_state(network, none));
  IntegratorSpec integrator;
  integrator.method = flight.way == Way::automatic    ? Method::automatic
                      : flight.way == Way::explicitly ? Method::explicit_differences
                                                      : Method::implicit_euler;
  integrator.step = flight.step;
  integrator.substep = flight.substep;
  integrator.tolerance = 1e-5;
  integrator.max_iterations = 100;
  simulation.configure({}, integrator, {});
  for (std::size_t k = 0; k < network.bullets.size(); ++k)
    simulation.kick(network.bullets[k], shot(network, k));
  const int steps = static_cast<int>(std::lround(kRow / flight.step));
  const int rows = static_cast<int>(std::lround(flight.until / kRow));
  for (int row = 0; row < rows; ++row) {
    for (int k = 1; k <= steps; ++k) {
      const double end = row * kRow + k * kRow / steps;
      while (simulation.state().time < end) {
        const StepReport report = simulation.advance(end, {});
        result.iterations += report.iterations;
        result.substeps += report.substeps;
      }
    }
    result.areas.push_back(mouth_area(network, simulation.state().x));
  }
  result.taken = retiarius::to_string(simulation.integrator().method);
}

}  // namespace

const char* to_string(Way way) {
  switch (way) {
    case Way::automatic:
      return "auto";
    case Way::explicitly:
      return "explicit";
    case Way::euler:
      return "implicit-euler";
    case Way::plain:
      return "plain-explicit";
  }
  return "";
}

double euler_step(int segments) { return segments <= 2 ? 2.5e-4 : 2e-4 / segments; }

NetSpec flight_net(int segments) {
  NetSpec spec;
  spec.pattern = Pattern::square;
  spec.side = 5.0;
  spec.mesh = 0.2;
  spec.segments = segments;
  spec.scale = 0.25;
  spec.zigzag = true;
  spec.thread.young_modulus = 70e9;
  spec.thread.density = 1390.0;
  spec.thread.radius = 0.0005;
  spec.thread.compression = false;
  spec.thread.material_damping = 1e-6;
  spec.corner_mass.mass = 0.5;
  return spec;
}

FlightResult fly(const Flight& flight) {
  const Network network = build_network(flight_net(flight.segments));
  FlightResult result;
  result.flight = flight;
  result.nodes = network.node_count();
  result.areas.push_back(mouth_area(network, network.initial));
  const auto start = Clock::now();
  if (flight.way == Way::plain)
    fly_plainly(network, flight, result);
  else
    fly_simulated(network, flight, result);
  const std::chrono::duration<double> wall = Clock::now() - start;
  result.seconds = wall.count();
  return result;
}

double area_error(const std::vector<double>& areas, const std::vector<double>& reference) {
  double worst = 0.0;
  for (std::size_t k = 0; k < std::min(areas.size(), reference.size()); ++k)
    worst = std::max(worst, std::abs(areas[k] / reference[k] - 1.0));
  return worst;
}

std::vector<FlightResult> measure_flights(const FlightsOptions& options,
                                          void (*told)(const FlightResult&)) {
  std::vector<FlightResult> all;
  for (const int segments : options.segments) {
    Flight flight;
    flight.segments = segments;
    flight.until = options.until;
    flight.way = Way::explicitly;
    std::vector<double> reference;
    if (options.references) {
      const Network network = build_network(flight_net(segments));
      Flight finer = flight;
      finer.substep = 0.45 * stable_explicit_step(network).step;
      reference = fly(finer).areas;
    }
    for (const Way way : {Way::explicitly, Way::automatic, Way::plain, Way::euler}) {
      flight.way = way;
      flight.step = way == Way::euler ? euler_step(segments) : 0.005;
      flight.until =
          way == Way::euler && segments > 2 ? std::min(kShort, options.until) : options.until;
      FlightResult result = fly(flight);
      if (reference.empty()) reference = result.areas;
      result.error = area_error(result.areas, reference);
      if (told) told(result);
      all.push_back(std::move(result));
    }
  }
  return all;
}

}  // namespace retiarius::benchmarks
