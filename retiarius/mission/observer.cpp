#include "retiarius/mission/observer.hpp"

namespace retiarius {

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::finished:
      return "finished";
    case Outcome::failed:
      return "failed";
    case Outcome::interrupted:
      return "interrupted";
    case Outcome::broke:
      return "broke";
  }
  throw Error("an outcome that is none of the four");
}

}  // namespace retiarius
