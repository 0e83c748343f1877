// In place of the viewer where it is not built.
#include "retiarius/report/viewer_bundle.hpp"

namespace retiarius {

const unsigned char kViewerBundle[] = {0};
const std::size_t kViewerBundleSize = 0;

}  // namespace retiarius
