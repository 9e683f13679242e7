// SPDX-License-Identifier: MIT
#include "scene/readers/image_files.h"

#include <fmt/format.h>

namespace strahl {

std::shared_ptr<const Texels> ImageFiles::read(const std::string& path, const SourceLocation& where,
                                               Diagnostics& diagnostics) {
  const auto known = files_.find(path);
  if (known != files_.end()) return known->second;
  diagnostics.opened(path);
  try {
    auto texels = std::make_shared<const Texels>(read_texels(path));
    if (texels->repaired > 0)
      diagnostics.warning(where,
                          fmt::format("{} of the {} texels of \"{}\" are negative, infinite or no number; they are "
                                      "taken for 0, infinite ones for the largest",
                                      texels->repaired, texels->count(), path));
    files_.emplace(path, texels);
    return texels;
  } catch (const InputError& fault) {
    diagnostics.error(where, fault.what());
    return nullptr;
  }
}

}  // namespace strahl
