// SPDX-License-Identifier: MIT
#include "checkpoint/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "errors.h"

namespace strahl {
namespace {

struct Part {
  std::string path;
  CheckpointHeader header;

  [[nodiscard]] int first() const { return header.first_sample; }
  [[nodiscard]] int end() const { return header.first_sample + header.most; }
};

std::string missing_text(int first, int end) {
  return fmt::format("samples {}:{} are missing; render them with --samples {}:{}", first, end, first, end);
}

void require_one_picture(const Part& part, const Part& first) {
  const std::string difference = part.header.identity.difference_from(first.header.identity);
  if (!difference.empty())
    throw InputError(fmt::format("\"{}\" and \"{}\" are not of one picture: {} (there: \"{}\")", first.path, part.path,
                                 difference, first.path));
  if (part.header.spp != first.header.spp)
    throw InputError(fmt::format("\"{}\" is of a picture of {} samples and \"{}\" of {}; render both with one --spp",
                                 first.path, first.header.spp, part.path, part.header.spp));
}

/// By their first samples.
std::vector<Part> parts_of(const std::vector<std::string>& paths) {
  std::vector<Part> parts;
  for (const std::string& path : paths) {
    parts.push_back({path, read_checkpoint_header(path)});
    const Part& part = parts.back();
    require_one_picture(part, parts.front());
    if (part.header.least != part.header.most)
      throw InputError(fmt::format("\"{}\" is not finished: its pixels have {} to {} samples; finish it with --resume",
                                   path, part.header.least, part.header.most));
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.first() < b.first(); });
  return parts;
}

void require_all_samples(const std::vector<Part>& parts, bool is_whole) {
  const int spp = parts.front().header.spp;
  if (is_whole && parts.front().first() > 0) throw InputError(missing_text(0, parts.front().first()));
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Part &before = parts[i - 1], &part = parts[i];
    if (part.first() < before.end())
      throw InputError(fmt::format("\"{}\" ({}:{}) and \"{}\" ({}:{}) overlap: each sample may be in one part only",
                                   before.path, before.first(), before.end(), part.path, part.first(), part.end()));
    if (part.first() > before.end()) throw InputError(missing_text(before.end(), part.first()));
  }
  if (is_whole && parts.back().end() < spp) throw InputError(missing_text(parts.back().end(), spp));
}

void add(Checkpoint& sum, Checkpoint part) {
  FilmSums& film = sum.state.film;
  if (film.words.size() != part.state.film.words.size() || film.samples.size() != part.state.film.samples.size())
    throw InputError("the parts' films differ in size");
  film.add_words(0, part.state.film.words);
  for (std::size_t i = 0; i < film.samples.size(); ++i) film.samples[i] += part.state.film.samples[i];
  sum.state.unusual += part.state.unusual;
}

}  // namespace

Checkpoint merged(const std::vector<std::string>& paths, bool is_whole) {
  const std::vector<Part> parts = parts_of(paths);
  require_all_samples(parts, is_whole);
  // The first one has the AOVs, which are of a pixel's first sample.
  Checkpoint sum = read_checkpoint(parts.front().path);
  std::set<std::string> devices{sum.header.metadata["device"]};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    Checkpoint part = read_checkpoint(parts[i].path);
    devices.insert(part.header.metadata["device"]);
    add(sum, std::move(part));
  }
  sum.header.metadata["device"] = fmt::format("{}", fmt::join(devices, "; "));
  sum.state.position.done = parts.back().end();
  sum.told_of_film();
  return sum;
}

}  // namespace strahl
