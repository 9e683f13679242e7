// SPDX-License-Identifier: MIT
// OpenEXR writer: all channels as 32-bit floats, so that values survive bit by bit, ZIP-compressed.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "errors.h"
#include "image/atomic_file.h"
#include "image/codecs.h"
#include "image/exr_metadata.h"

namespace strahl {
namespace {

/// The destructor of Imf::OutputFile writes a table and swallows what goes wrong; AtomicFile::commit() remembers it.
class OutputStream : public Imf::OStream {
 public:
  OutputStream(AtomicFile& file, const std::string& path) : Imf::OStream(path.c_str()), file_(file) {}
  void write(const char bytes[], int size) override { file_.write(bytes, static_cast<std::size_t>(size)); }
  std::uint64_t tellp() override { return file_.tell(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  AtomicFile& file_;
};

/// Of a target that cannot seek: the file comes first as a whole, because its table of lines is written last.
class MemoryStream : public Imf::OStream {
 public:
  explicit MemoryStream(const std::string& path) : Imf::OStream(path.c_str()) {}
  void write(const char bytes[], int size) override {
    const auto count = static_cast<std::size_t>(size);
    if (bytes_.size() < position_ + count) bytes_.resize(position_ + count);
    std::copy_n(bytes, count, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
    position_ += count;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = static_cast<std::size_t>(position); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

/// OpenEXR cuts longer names without a word, and channels that are alike from then on would be one.
void check_names(const Image& image, const std::string& path) {
  constexpr std::size_t longest = 255;
  for (const std::string& name : image.channels)
    if (name.size() > longest)
      throw Error(fmt::format("cannot write \"{}\": a channel's name has {} bytes, and an EXR file holds {}: \"{}\"",
                              path, name.size(), longest, name));
}

/// The file is complete when this returns.
void write_pixels(const Imf::Header& header, const Imf::FrameBuffer& pixels, int height, Imf::OStream& stream) {
  Imf::OutputFile output(stream, header);
  output.setFrameBuffer(pixels);
  output.writePixels(height);
}

}  // namespace

WriteReport write_exr(const Image& image, const std::string& path) {
  check_names(image, path);
  AtomicFile file(path);
  try {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, value] : image.metadata) {
      header.insert(exr_metadata_prefix + key, Imf::StringAttribute(value));
    }
    Imf::FrameBuffer pixels;
    const std::size_t stride = image.channels.size() * sizeof(float);
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
      header.channels().insert(image.channels[c], Imf::Channel(Imf::FLOAT));
      // OpenEXR has one slice type for reading and writing; it only reads these.
      char* first = const_cast<char*>(reinterpret_cast<const char*>(image.data.data() + c));
      pixels.insert(image.channels[c],
                    Imf::Slice(Imf::FLOAT, first, stride, stride * static_cast<std::size_t>(image.width)));
    }
    if (file.can_seek()) {
      OutputStream stream(file, path);
      write_pixels(header, pixels, image.height, stream);
    } else {
      MemoryStream stream(path);
      write_pixels(header, pixels, image.height, stream);
      file.write(stream.bytes());
    }
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw Error(fmt::format("cannot write \"{}\": {}", path, e.what()));
  }
  file.commit();

  WriteReport report;
  report.invalid = static_cast<std::size_t>(
      std::count_if(image.data.begin(), image.data.end(), [](float value) { return !std::isfinite(value); }));
  return report;
}

}  // namespace strahl
