// The viewer's page as it was built from viewer/, a zlib stream.
#pragma once

#include <cstddef>

namespace retiarius {

extern const unsigned char kViewerBundle[];
extern const std::size_t kViewerBundleSize;  // bytes; 0 where the viewer was not built

}  // namespace retiarius
