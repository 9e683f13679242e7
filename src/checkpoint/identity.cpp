// SPDX-License-Identifier: MIT
#include "checkpoint/identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "checkpoint/host_sources.h"
#include "errors.h"
#include "json_text.h"
#include "opencl/program.h"
#include "opencl/program_cache.h"
#include "program/kernel_files.h"
#include "settings/sampler_name.h"

namespace strahl {
namespace {

namespace fs = std::filesystem;

std::string hex(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::string hash_of_file(const std::string& path) {
  std::error_code unknown;
  if (!fs::is_regular_file(path, unknown))
    throw InputError(fmt::format(
        "--checkpoint and --resume compare the scene's files, and \"{}\" is no file; write it to one", path));
  std::ifstream in(path, std::ios::binary);
  std::vector<char> bytes(1 << 16);
  std::uint64_t hash = fnv1a("");
  while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || in.gcount() > 0)
    hash = fnv1a({bytes.data(), static_cast<std::size_t>(in.gcount())}, hash);
  if (!in.eof()) throw InputError(fmt::format("cannot read \"{}\" again", path));
  return hex(hash);
}

std::string hash_of_kernels() {
  std::uint64_t hash = fnv1a("");
  for (const auto& [path, text] : kernel_files()) hash = fnv1a(text, fnv1a(path, hash));
  return hex(hash);
}

std::string sorted_list(std::vector<std::string> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? "none" : fmt::format("{}", fmt::join(values, ", "));
}

/// Of several values of a name the last holds, as in the scene.
std::string define_list(const std::vector<std::string>& defines) {
  std::map<std::string, std::string> last;
  for (const std::string& define : defines) last[define.substr(0, define.find('='))] = define;
  std::vector<std::string> effective;
  for (const auto& [name, define] : last) effective.push_back(define);
  return sorted_list(std::move(effective));
}

std::string aov_list(const RenderSettings& settings) { return sorted_list(settings.aovs.plain_names()); }

}  // namespace

std::string PictureIdentity::difference_from(const PictureIdentity& other) const {
  for (std::size_t i = 0; i < std::min(parts.size(), other.parts.size()); ++i) {
    const IdentityPart &here = parts[i], &there = other.parts[i];
    if (here.name != there.name) return fmt::format("{} there and {} here", there.name, here.name);
    if (here.value != there.value)
      return fmt::format("{}{} is {} there and {} here", here.name, here.note, there.value, here.value);
  }
  return parts.size() == other.parts.size() ? "" : "one of them states less";
}

PictureIdentity identity_of(const Device& device, const Renderer& renderer, const RenderSettings& settings,
                            const std::vector<std::string>& defines, const RenderGoal& goal) {
  const Scene& scene = renderer.scene();
  const Window window = scene.film.window();
  const ResolvedSampling sampling = resolve_sampling(scene);
  PictureIdentity identity;
  const auto add = [&](std::string name, const std::string& value, std::string note = {}) {
    // As a checkpoint gives it back; a note is only shown.
    identity.parts.push_back({std::move(name), utf8_text(value), std::move(note)});
  };
  add("the version of strahl", STRAHL_VERSION);
  add("the hash of its kernels", hash_of_kernels());
  add("the hash of its host's sources", host_sources_hash());
  add("--precision", precision_name(settings.precision));
  if (settings.precision == Precision::fast || settings.precision == Precision::stable) {
    add("the program, whose compiler may decide bits of this precision", renderer.stats().program);
    std::string driver = driver_key(device);
    std::replace(driver.begin(), driver.end(), '\n', ' ');
    add("the driver, which may decide bits of this precision", driver);
  }
  add("the number of the scene's files", fmt::format("{}", scene.files.size()));
  for (std::size_t i = 0; i < scene.files.size(); ++i)
    add(fmt::format("the hash of file {}", i + 1), hash_of_file(scene.files[i]),
        fmt::format(" ({})", fs::path(scene.files[i]).filename().string()));
  add("-D", define_list(defines));
  add("--sensor", fmt::format("{}", scene.camera.number));
  add("the integrator", scene.integrator.name);
  add("the greatest depth", fmt::format("{}", scene.integrator.max_depth));
  add("the sampler", sampler_name(sampling.kind));
  add("the seed", fmt::format("{}", goal.seed.value_or(sampling.seed)));
  add("the picture's size", fmt::format("{}x{}", scene.film.width, scene.film.height));
  add("the window", fmt::format("{},{},{},{}", window.x0, window.y0, window.x1, window.y1));
  add("--disable", sorted_list({settings.disabled.begin(), settings.disabled.end()}));
  add("--texture-lod", settings.texture_lod ? "on" : "off");
  add("--light-choice", settings.light_choice.value_or("by the lights"));
  add("--aov", aov_list(settings));
  add("what the told error is made from (--spp, --no-error, --time, --max-error)", renderer.division_text(goal));
  return identity;
}

}  // namespace strahl
