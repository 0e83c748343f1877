#include "retiarius/mission/observer.hpp"

namespace retiarius {

namespace {

template <class Value>
void transfer_value(Archive& archive, Measure& measure) {
  if (archive.reads()) measure.value = Value{};
  archive(std::get<Value>(measure.value));
}

void transfer_measure(Archive& archive, Measure& measure) {
  std::int32_t kind = static_cast<std::int32_t>(measure.value.index());
  archive(measure.name, measure.unit, kind);
  if (kind == 0) {
    measure.value = std::monostate{};
  } else if (kind == 1) {
    transfer_value<double>(archive, measure);
  } else if (kind == 2) {
    transfer_value<std::int64_t>(archive, measure);
  } else if (kind == 3) {
    transfer_value<bool>(archive, measure);
  } else {
    throw Error("a measure of unknown kind");
  }
}

}  // namespace

void transfer(Archive& archive, PhaseReport& report) {
  archive(report.name, report.kind, report.start, report.end, report.trigger);
  report.measures.resize(archive.length(report.measures.size()));
  for (Measure& measure : report.measures) transfer_measure(archive, measure);
}

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
