#include <cstdio>

#include "retiarius/net/network.hpp"

int main() {
  retiarius::NetSpec spec;
  spec.side = 1.0, spec.mesh = 0.2, spec.segments = 4;
  spec.thread = {.young_modulus = 1.0e6, .density = 1000.0, .radius = 0.01};
  const retiarius::Network net = retiarius::build_network(spec);
  std::printf("%d nodes, %d segments\n", net.node_count(), net.segment_count());
  return net.node_count() == 631 && net.segment_count() == 720 ? 0 : 1;
}
