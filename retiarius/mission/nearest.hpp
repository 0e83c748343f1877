// The nearest of some names to one that was mistyped.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace retiarius {

// The fewest insertions, deletions, replacements of a letter and swaps of neighbouring letters
// that turn one word into the other; case does not count.
int edit_distance(const std::string& a, const std::string& b);

// The name nearest to `word`, of equals the one that begins most alike; none where more than a
// third of it (at least two letters) would have to change.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& names);

// ", did you mean radius?" or "; allowed: a, b, c".
std::string suggestion(const std::string& word, const std::vector<std::string>& names);

}  // namespace retiarius
