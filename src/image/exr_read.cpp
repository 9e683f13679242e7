// SPDX-License-Identifier: MIT
// OpenEXR reader: one part, scan lines or tiles, any compression; half and unsigned channels become floats.
// A picture is the display window; where the data window does not reach, it is 0. A texture is the data window, of
// several parts the first one's.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <tuple>

#include "errors.h"
#include "image/codecs.h"
#include "image/exr_colours.h"
#include "image/exr_header.h"
#include "image/exr_metadata.h"

namespace strahl {
namespace {

enum class ExrUse { picture, texture };

constexpr int rows_at_once = 256;  // The most that a block of scan lines has (DWAB).

class InputStream : public Imf::IStream {
 public:
  InputStream(const std::string& bytes, const std::string& path) : Imf::IStream(path.c_str()), bytes_(bytes) {}

  bool read(char target[], int size) override {
    const auto wanted = static_cast<std::size_t>(size);
    if (position_ > bytes_.size() || wanted > bytes_.size() - position_) {
      throw std::runtime_error("the file ends too early");
    }
    std::memcpy(target, bytes_.data() + position_, wanted);
    position_ += wanted;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  const std::string& bytes_;
  std::uint64_t position_ = 0;
};

/// "l.R" of "l.r": channels of colours are also written in lower case.
std::string in_capitals(const std::string& name) {
  const std::size_t base = name.rfind('.') + 1;
  static const std::string letters = "rgbaxyz";
  if (name.size() != base + 1 || letters.find(name[base]) == std::string::npos) return name;
  return name.substr(0, base) + static_cast<char>(std::toupper(static_cast<unsigned char>(name[base])));
}

/// OpenEXR lists channels by alphabet; a picture has R G B A, layer by layer.
std::vector<std::string> channel_order(const Imf::ChannelList& channels) {
  std::vector<std::string> names;
  for (auto it = channels.begin(); it != channels.end(); ++it) names.emplace_back(it.name());
  const auto key = [](const std::string& name) {
    const std::size_t base = name.rfind('.') + 1;
    const std::string channel = in_capitals(name).substr(base);
    static const std::string order[] = {"R", "G", "B"};
    const auto rank = channel == "A" ? 4 : std::find(std::begin(order), std::end(order), channel) - std::begin(order);
    return std::tuple(name.substr(0, base), rank, channel);
  };
  std::sort(names.begin(), names.end(), [&key](const auto& a, const auto& b) { return key(a) < key(b); });
  return names;
}

std::map<std::string, std::string> metadata_of(const Imf::Header& header) {
  const std::string prefix = exr_metadata_prefix;
  std::map<std::string, std::string> metadata;
  for (auto it = header.begin(); it != header.end(); ++it) {
    const std::string name = it.name();
    if (name == "type" || name == "name") continue;  // They belong to the container.
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute());
    if (text) metadata[name.rfind(prefix, 0) == 0 ? name.substr(prefix.size()) : name] = text->value();
  }
  return metadata;
}

void check_readable(const Imf::MultiPartInputFile& file, const std::string& path, ExrUse use) {
  const Imf::Header& header = file.header(0);
  const auto reject = [&path](const std::string& why) { throw InputError(fmt::format("\"{}\": {}", path, why)); };
  if (file.parts() != 1 && use == ExrUse::picture)
    reject(fmt::format("an OpenEXR file of {} parts; extract one into a file", file.parts()));
  if (header.hasType() && Imf::isDeepData(header.type())) reject("deep OpenEXR files are not read; flatten it first");
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
    if (it.channel().xSampling != 1 || it.channel().ySampling != 1) {
      reject(fmt::format("channel \"{}\" is subsampled; convert the file to full resolution", it.name()));
    }
  }
  if (!file.partComplete(0)) reject("incomplete OpenEXR file");
}

std::int64_t length(int from, int to) { return std::int64_t{to} - from + 1; }

/// No byte stands for the blank parts of a display window: it may be four times as large as the data window, or 64 MiB,
/// or what a part of a picture with so many bytes is likely to come from.
ClaimLimit display_claim(const Imath::Box2i& window, std::size_t channels) {
  const std::int64_t pixels = length(window.min.x, window.max.x) * length(window.min.y, window.max.y);
  return {std::max(std::size_t{1} << 24, 4 * static_cast<std::size_t>(pixels) * channels), 256};
}

Image decode(Imf::MultiPartInputFile& file, const std::string& path, std::size_t file_bytes, ExrUse use) {
  check_readable(file, path, use);
  const Imf::Header& header = file.header(0);
  const Imath::Box2i window = header.dataWindow();
  const Imath::Box2i display = use == ExrUse::texture ? window : header.displayWindow();
  const std::vector<std::string> channels = channel_order(header.channels());
  const auto check = [&](const Imath::Box2i& box, const ClaimLimit& claim) {
    check_picture_size(path, length(box.min.x, box.max.x), length(box.min.y, box.max.y), channels.size(), file_bytes,
                       claim);
  };
  check(window, compressed_values);
  check(display, display_claim(window, channels.size()));

  const auto blank = [&](const Imath::Box2i& box) {
    Image image;
    image.width = box.max.x - box.min.x + 1;
    image.height = box.max.y - box.min.y + 1;
    image.channels = channels;
    image.metadata = metadata_of(header);
    image.data.reserve(image.index(0, image.height, 0));
    return image;
  };
  Image stored = blank(window);
  Imf::FrameBuffer pixels;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::size_t stride = channels.size() * sizeof(float);
    pixels.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, stored.data.data() + c, window, stride,
                                                stride * static_cast<std::size_t>(stored.width)));
  }
  Imf::InputPart part(file, 0);
  part.setFrameBuffer(pixels);
  // Memory grows with what was read: a file that claims more than it holds ends here early.
  for (int y = 0; y < stored.height; y += rows_at_once) {
    const int end = std::min(y + rows_at_once, stored.height);
    stored.data.resize(stored.index(0, end, 0));
    part.readPixels(window.min.y + y, window.min.y + end - 1);
  }
  if (use == ExrUse::texture) {
    for (std::string& channel : stored.channels)
      if (std::ranges::find(stored.channels, in_capitals(channel)) == stored.channels.end())
        channel = in_capitals(channel);
    convert_to_rec_709(stored, header);
  }
  if (window == display) return stored;

  Image image = blank(display);
  image.data.resize(image.index(0, image.height, 0));
  const int left = std::max(window.min.x, display.min.x);
  const int right = std::min(window.max.x, display.max.x);
  for (int y = std::max(window.min.y, display.min.y); left <= right && y <= std::min(window.max.y, display.max.y);
       ++y) {
    const float* row = &stored.data[stored.index(left - window.min.x, y - window.min.y, 0)];
    std::copy_n(row, static_cast<std::size_t>(right - left + 1) * channels.size(),
                &image.data[image.index(left - display.min.x, y - display.min.y, 0)]);
  }
  return image;
}

ExrTexture read(const std::string& path, const std::string& bytes, ExrUse use) {
  try {
    require_attributes_fit(bytes);
    InputStream stream(bytes, path);
    Imf::MultiPartInputFile file(stream);
    return {decode(file, path, bytes.size(), use), file.parts()};
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw InputError(fmt::format("\"{}\": not a readable OpenEXR file: {}", path, e.what()));
  }
}

}  // namespace

Image read_exr(const std::string& path, const std::string& bytes) { return read(path, bytes, ExrUse::picture).image; }

ExrTexture read_exr_texture(const std::string& path, const std::string& bytes) {
  return read(path, bytes, ExrUse::texture);
}

}  // namespace strahl
