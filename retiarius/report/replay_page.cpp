#include "retiarius/report/replay_page.hpp"

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/replay_chunk.hpp"
#include "retiarius/report/svg_plot.hpp"
#include "retiarius/report/viewer_bundle.hpp"

namespace retiarius {

namespace {

std::string viewer_template() {
  if (!viewer_built_in())
    throw Error("this program was built without the 3D replay (RETIARIUS_VIEWER)");
  return inflated({reinterpret_cast<const char*>(kViewerBundle), kViewerBundleSize});
}

void put(std::string& page, std::string_view place, std::string_view text) {
  const std::size_t at = page.find(place);
  if (at == std::string::npos) throw Error(fmt::format("the viewer's page has no place {}", place));
  page.replace(at, place.size(), text);
}

void add_block(std::string& data, const PageRun& run, const char* file, bool deflate,
               std::string_view bytes) {
  data += fmt::format(
      "<script type=\"application/octet-stream;base64\" data-run=\"{}\" data-file=\"{}\"{}>",
      escape_html(run.label), file, deflate ? " data-encoding=\"deflate\"" : "");
  data += base64(deflate ? deflated(bytes) : bytes);
  data += "</script>\n";
}

void add_recording(std::string& data, const PageRun& run) {
  const std::filesystem::path path = run.folder / "replay.bin";
  const std::string bytes = read_whole_file(path);
  std::size_t whole = 0;
  try {
    whole = read_chunks(bytes).size;
  } catch (const InputError& error) {
    throw InputError(fmt::format("cannot use {}: {}", path.string(), error.what()));
  }
  add_block(data, run, "replay.bin", false, std::string_view(bytes).substr(0, whole));
}

std::string page_with(const std::string& title, const std::string& heading, const char* connect,
                      const std::string& data) {
  std::string page = viewer_template();
  put(page, "retiarius-connect", connect);
  put(page, "<!--retiarius:title-->", escape_html(title) + " \u00b7 Retiarius");
  put(page, "<!--retiarius:outcome-->", heading);
  put(page, "<!--retiarius:data-->", data);
  return page;
}

}  // namespace

bool viewer_built_in() { return kViewerBundleSize > 0; }

std::string replay_page(const std::string& title, const std::string& heading,
                        const std::vector<PageRun>& runs) {
  std::string data;
  for (const PageRun& run : runs) {
    for (const char* file : {"history.csv", "summary.json", "mission.toml", "resolved.toml"})
      if (std::filesystem::exists(run.folder / file))
        add_block(data, run, file, true, read_whole_file(run.folder / file));
    add_recording(data, run);
  }
  return page_with(title, heading, "'none'", data);
}

std::string live_page(const std::string& title) { return page_with(title, "", "'self'", ""); }

std::string base64(std::string_view bytes) {
  static constexpr char kLetters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  const auto byte = [&](std::size_t k) {
    return k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) : 0u;
  };
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::uint32_t three = byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2);
    const std::size_t known = std::min<std::size_t>(3, bytes.size() - k);
    for (std::size_t j = 0; j < 4; ++j)
      text += j <= known ? kLetters[(three >> (18 - 6 * j)) & 63u] : '=';
  }
  return text;
}

}  // namespace retiarius
