// SPDX-License-Identifier: MIT
// The page, styles and scripts of the report as built into the program; src/embed_files.cmake generates the definition.
#pragma once

#include <string_view>
#include <vector>

namespace strahl {

struct EmbeddedReportFile {
  std::string_view name;  ///< "report.html"
  std::string_view text;
};

[[nodiscard]] const std::vector<EmbeddedReportFile>& embedded_report_files();

}  // namespace strahl
