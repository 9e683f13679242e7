// SPDX-License-Identifier: MIT
#include "scene/readers/image_files.h"

#include <fmt/format.h>

#include "scene/volumes/vol_reader.h"

namespace strahl {
namespace {

constexpr const char* light_faults = "negative, infinite or no number";

/// Integers, of which none is negative.
bool is_for_all_uses(const Texels& texels) {
  return texels.format == TexelFormat::bits_8 || texels.format == TexelFormat::bits_16;
}

const Texels& texels_of(const Texels& texels) { return texels; }
const Texels& texels_of(const VolumeGrid& grid) { return grid.texels; }

/// What `read` makes of the file, or made of it before; null after an error.
template <class Data, class Read>
std::shared_ptr<const Data> read_once(std::map<std::string, std::shared_ptr<const Data>>& files, Read read,
                                      const std::string& path, const char* faulty, const SourceLocation& where,
                                      Diagnostics& diagnostics) {
  const auto known = files.find(path);
  if (known != files.end()) return known->second;
  diagnostics.opened(path);
  try {
    auto data = std::make_shared<const Data>(read(path));
    const Texels& texels = texels_of(*data);
    if (texels.repaired > 0)
      diagnostics.warning(
          where, fmt::format("{} of the {} texels of \"{}\" are {}; they are taken for 0, infinite ones for the "
                             "largest",
                             texels.repaired, texels.count(), path, faulty));
    if (!texels.doubt.empty())
      diagnostics.warning(where,
                          fmt::format("\"{}\" may be damaged: {}; look at it, and save it anew", path, texels.doubt));
    if (!texels.left_out.empty()) diagnostics.warning(where, fmt::format("\"{}\": {}", path, texels.left_out));
    files.emplace(path, data);
    return data;
  } catch (const InputError& fault) {
    diagnostics.error(where, fault.what());
    return nullptr;
  }
}

}  // namespace

std::shared_ptr<const Texels> ImageFiles::read(const std::string& path, const SourceLocation& where,
                                               Diagnostics& diagnostics, TexelUse use) {
  const bool are_heights = use == TexelUse::heights;
  const auto& others = are_heights ? files_ : heights_;
  const auto known = others.find(path);
  if (known != others.end() && is_for_all_uses(*known->second)) return known->second;
  return read_once(
      are_heights ? heights_ : files_, [use](const std::string& name) { return read_texels(name, use); }, path,
      are_heights ? "infinite or no number" : light_faults, where, diagnostics);
}

std::shared_ptr<const VolumeGrid> ImageFiles::read_grid(const std::string& path, const SourceLocation& where,
                                                        Diagnostics& diagnostics) {
  return read_once(grids_, read_vol, path, light_faults, where, diagnostics);
}

}  // namespace strahl
