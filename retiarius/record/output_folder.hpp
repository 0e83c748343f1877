// The folder that one run leaves behind.
#pragma once

#include <filesystem>

namespace retiarius {

// Creates the folder (and its parents) and makes sure that files can be written in it. A folder
// that exists and is not empty is an InputError that names it and the remedies, unless `overwrite`
// is set: then what an earlier run left in it is removed, and nothing else. Throws InputError
// also when the place is a file, read-only or full.
void prepare_output_folder(const std::filesystem::path& folder, bool overwrite = false);

}  // namespace retiarius
