// Any bytes as an OBJ file.
#include "fuzz/solid.hpp"

RETIARIUS_FUZZ_TARGET(bytes) {
  using namespace retiarius;
  fuzz::accept_or_refuse([&] { fuzz::make_solid(parse_obj(std::string(bytes), "m.obj")); });
}
