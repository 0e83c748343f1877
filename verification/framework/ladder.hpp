// Runs cases and gathers what they yield.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verification/framework/case.hpp"
#include "verification/framework/results.hpp"

namespace retiarius::verification {

struct Rung {
  const Case* of = nullptr;
  CaseResult result;
};

// Runs one case; what it throws becomes its failure.
CaseResult run_case(const Case& of, bool quick, const Fault& fault = {});

// Runs cases side by side on `workers` threads; `finished` is called after each, one call at a
// time. The order of the result is that of `cases`.
std::vector<Rung> climb(const std::vector<const Case*>& cases, bool quick, int workers,
                        const std::function<void(const Rung&)>& finished = {});

// The cases of these names, all where there is none. Throws InputError that lists near names.
std::vector<const Case*> chosen_cases(const std::vector<std::string>& names);

bool passes(const std::vector<Rung>& rungs);

}  // namespace retiarius::verification
