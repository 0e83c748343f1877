#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "retiarius/campaign/schema.hpp"

namespace retiarius {
namespace {

TEST(CampaignDocument, PageIsUpToDate) {
  std::ostringstream page;
  page << std::ifstream(RETIARIUS_SOURCE_DIR "/docs/campaign-file.md").rdbuf();
  EXPECT_EQ(page.str(), campaign_file_markdown())
      << "docs/campaign-file.md differs from the schema; write it anew with\n"
         "  retiarius docs campaign-file > docs/campaign-file.md";
}

}  // namespace
}  // namespace retiarius
