#include "explore/measured_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <fstream>
#include <string>

#include "io/parse_views.hpp"

namespace bodyline::explore {
namespace {

// CRC-64 of ECMA-182 with reflected bits, as in XZ.
using Crc64 = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~0ull, ~0ull, true, true>;

MeasuredFile measured(const std::filesystem::path& folder, const std::string& name) {
  MeasuredFile file{name, 0, ""};
  std::ifstream stream(folder / name, std::ios::binary);
  std::array<char, 1 << 16> part;
  Crc64 crc;
  while (stream.read(part.data(), part.size()) || stream.gcount() > 0) {
    crc.process_bytes(part.data(), std::size_t(stream.gcount()));
    file.bytes += std::uint64_t(stream.gcount());
  }
  if (stream.is_open() && !stream.bad()) file.digest = fmt::format("{:016x}", crc.checksum());
  return file;
}

}  // namespace

std::vector<MeasuredFile> measured_files(const Study& study) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const MetricSpec& metric : study.metrics) {
    if (metric.kind == MetricKind::scan) add(metric.scan);
    if (metric.kind != MetricKind::outline) continue;
    for (const io::ViewFile& view : io::parse_views(metric.views)) add(view.path);
  }
  std::vector<MeasuredFile> files;
  for (const std::string& name : names) files.push_back(measured(study.folder, name));
  return files;
}

}  // namespace bodyline::explore
