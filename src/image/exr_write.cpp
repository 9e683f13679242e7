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

}  // namespace

WriteReport write_exr(const Image& image, const std::string& path) {
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
    OutputStream stream(file, path);
    Imf::OutputFile output(stream, header);
    output.setFrameBuffer(pixels);
    output.writePixels(image.height);
  } catch (const Error&) {
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
