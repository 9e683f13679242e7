// SPDX-License-Identifier: MIT
// Every reader under libFuzzer: whatever the bytes, an answer or one of strahl's own errors. tests/fuzz/run starts it.
//
//   STRAHL_FUZZ_KIND    one of the kinds below
//   STRAHL_FUZZ_SEEDS   writes seeds of what scenes/ has no files of into this folder, and ends
#include <unistd.h>
#include <zlib.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "checkpoint/checkpoint.h"
#include "errors.h"
#include "image/image_io.h"
#include "image/npy.h"
#include "image/texels.h"
#include "scene/loader.h"
#include "scene/meshes/mesh_file.h"
#include "scene/spectra/curve.h"
#include "scene/volumes/vol_reader.h"

namespace {

using namespace strahl;
namespace fs = std::filesystem;

struct Kind {
  const char* file;  ///< The input's name: readers go by extensions.
  void (*read)(const std::string& path);
};

void texels(const std::string& path) { static_cast<void>(read_texels(path)); }

void image(const std::string& path) {
  texels(path);
  static_cast<void>(read_image(path));
}

void mesh(const std::string& path) { static_cast<void>(read_mesh(path)); }

const std::map<std::string, Kind> kinds{
    {"xml", {"in.xml", [](const std::string& path) { static_cast<void>(load_scene(path)); }}},
    {"obj", {"in.obj", mesh}},
    {"mtl", {"in.mtl", [](const std::string& path) { mesh(fs::path(path).replace_extension("obj").string()); }}},
    {"ply", {"in.ply", mesh}},
    {"serialized", {"in.serialized", mesh}},
    {"png", {"in.png", image}},
    {"exr", {"in.exr", image}},
    {"pfm", {"in.pfm", image}},
    {"jpeg", {"in.jpg", texels}},
    {"hdr", {"in.hdr", texels}},
    {"tga", {"in.tga", texels}},
    {"bmp", {"in.bmp", texels}},
    {"vol", {"in.vol", [](const std::string& path) { static_cast<void>(read_vol(path)); }}},
    {"spectrum", {"in.spd", [](const std::string& path) { static_cast<void>(curve_of_file(path)); }}},
    {"npy", {"in.npy", [](const std::string& path) { static_cast<void>(read_npy(path)); }}},
    {"checkpoint", {"in.ckpt", [](const std::string& path) { static_cast<void>(read_checkpoint(path)); }}},
};

void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

template <class Value>
void append(std::string& bytes, Value value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// One triangle in single precision, stored rather than squeezed, so that changes come through.
std::string serialized_file() {
  std::string content;
  append(content, std::uint32_t{0x1000});
  content += std::string("a name") + '\0';
  append(content, std::uint64_t{3});
  append(content, std::uint64_t{1});
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) append(content, x);
  for (const std::uint32_t i : {0U, 1U, 2U}) append(content, i);
  uLongf size = compressBound(static_cast<uLong>(content.size()));
  std::string stream(size, '\0');
  compress2(reinterpret_cast<Bytef*>(stream.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
            static_cast<uLong>(content.size()), 0);
  stream.resize(size);
  std::string file;
  append(file, std::uint16_t{0x041C});
  append(file, std::uint16_t{4});
  file += stream;
  append(file, std::uint64_t{0});
  append(file, std::uint32_t{1});
  return file;
}

void write_seeds(const fs::path& folder) {
  write(folder / "s.serialized", serialized_file());
  Image picture;
  picture.width = 3;
  picture.height = 2;
  for (int i = 0; i < 18; ++i) picture.data.push_back(static_cast<float>(i) / 7);
  for (const char* name : {"s.png", "s.exr", "s.pfm"}) static_cast<void>(write_image(picture, folder / name));
  write_npy({2, 6, std::vector<double>(12, 0.5)}, folder / "s.npy");
  FilmSums film({FilmKind::pixels, 2, 2, {4, 2, 1}});
  Checkpoint checkpoint{{}, {film, {4, 8}, {}, {}, {}, {}}};
  checkpoint.header.identity.parts = {{"the seed", "0", ""}};
  checkpoint.told_of_film();
  write_checkpoint(folder / "s.ckpt", checkpoint);
  write(folder / "s.spd", "# nm\n400 0.5\n500 0.25\n700 1e-3\n");
  write(folder / "s.mtl", "newmtl a\nKd .1 .2 .3\nKs 1 1 1\nNs 20\nd .5\nillum 4\nmap_Kd x.png\n");
  // 2 x 1 texels of 24 bits.
  using namespace std::string_literals;
  write(folder / "s.tga", "\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x18\0abcdef"s);
  write(
      folder / "s.bmp",
      "BM\x3e\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\2\0\0\0\1\0\0\0\1\0\x18\0\0\0\0\0\x08\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"
      "\0\0"
      "abcdef\0\0"s);
}

std::string folder_of_inputs() {
  std::string pattern = (fs::temp_directory_path() / "strahl-fuzz-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) std::abort();
  write(fs::path(pattern) / "in.obj", "mtllib in.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  return pattern;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string folder = folder_of_inputs();
  static const Kind kind = [] {
    const char* name = std::getenv("STRAHL_FUZZ_KIND");
    const auto at = kinds.find(name != nullptr ? name : "");
    if (at != kinds.end()) return at->second;
    std::fputs("STRAHL_FUZZ_KIND names no kind of file\n", stderr);
    std::exit(2);
  }();
  const std::string path = folder + "/" + kind.file;
  write(path, std::string(reinterpret_cast<const char*>(data), size));
  try {
    kind.read(path);
  } catch (const Error&) {
  }
  return 0;
}

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*arguments*/) {
  if (const char* folder = std::getenv("STRAHL_FUZZ_SEEDS"); folder != nullptr) {
    write_seeds(folder);
    std::exit(0);
  }
  return 0;
}
