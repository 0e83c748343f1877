// Any bytes as an STL file, text or binary.
#include "fuzz/solid.hpp"

RETIARIUS_FUZZ_TARGET(bytes) {
  using namespace retiarius;
  fuzz::accept_or_refuse([&] { fuzz::make_solid(parse_stl(std::string(bytes), "m.stl")); });
}
