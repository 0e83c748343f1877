// Any text as a network file.
#include "fuzz/target.hpp"
#include "retiarius/net/network_file.hpp"

RETIARIUS_FUZZ_TARGET(bytes) {
  using namespace retiarius;
  fuzz::accept_or_refuse([&] {
    const Layout layout = parse_network(std::string(bytes), "n.net");
    fuzz::require(!layout.pieces.empty(), "a network without pieces");
    for (const auto& piece : layout.pieces)
      fuzz::require(piece.a >= 0 && piece.b >= 0 && piece.a < Index(layout.nodes.size()) &&
                        piece.b < Index(layout.nodes.size()),
                    "a piece without nodes");
  });
}
