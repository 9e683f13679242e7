// SPDX-License-Identifier: MIT
// `strahl merge`: parts of a picture's samples to the picture, or to a larger part.
#include "checkpoint/merge.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "checkpoint/picture.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/distinct_files.h"
#include "cli/number_options.h"
#include "cli/output_file.h"
#include "cli/picture_files.h"
#include "cli/picture_metadata.h"
#include "cli/scene_aovs.h"
#include "cli/summary.h"

namespace strahl::cli {
namespace {

constexpr const char* merge_footer = R"(
Parts come from `strahl render --samples A:B --checkpoint PART`, with the same scene and options. In any order the sum
has the bits of one run, its told error too. A finished checkpoint of a whole picture is a part as well.

Examples:
  strahl merge part*.ckpt -o out.exr            all samples must be there, each once
  strahl merge a.ckpt b.ckpt -o ab.ckpt         a larger part
  strahl merge part*.ckpt -o out.png --error-map error.exr)";

struct MergeOptions {
  std::vector<std::string> parts;
  std::string output;
  std::string error_map;
  PngOptions png;
  std::vector<const CLI::Option*> of_pictures;  ///< Without effect where a larger part is written.
  bool quiet = false;
};

bool is_checkpoint(const std::string& path) { return std::filesystem::path(path).extension() == ".ckpt"; }

/// layers: of a picture that has them beside it.
void require_distinct_files(const MergeOptions& options, const std::vector<std::string>& layers) {
  std::vector<NamedFile> outputs{{"-o", options.output}, {"--error-map", options.error_map}}, inputs;
  for (const std::string& layer : layers)
    outputs.push_back({"the picture of the AOV " + layer, path_beside(options.output, layer)});
  for (const std::string& part : options.parts) inputs.push_back({"a part", part});
  require_distinct(outputs, inputs);
}

void require_outputs(const MergeOptions& options) {
  if (!is_checkpoint(options.output)) static_cast<void>(image_format(options.output));
  require_distinct_files(options, {});
  for (const std::string& path : {options.output, options.error_map})
    if (!path.empty()) require_writable(path);
  if (!options.error_map.empty()) static_cast<void>(image_format(options.error_map));
}

/// The layers that a picture that is no .exr has beside it, which only the parts know.
void require_distinct_layers(const MergeOptions& options, const std::vector<std::string>& layers) {
  if (image_format(options.output) != ImageFormat::exr) require_distinct_files(options, layers);
}

RenderResult result_of(const Checkpoint& sum) {
  for (const std::string& aov : sum.header.aovs)
    if (aov == "numeric_error")
      throw InputError("--aov numeric_error traces the scene again, which `merge` has not; render it by itself");
  RenderResult result = picture_of(sum);
  if (sum.state.unusual.not_finite() == 0) result.error = estimate_error(sum.state.film);
  return result;
}

ExitCode write_picture(const MergeOptions& options, const Checkpoint& sum, const Invocation& invocation) {
  const RenderResult result = result_of(sum);
  if (!sum.header.named_aovs.empty() && image_format(options.output) != ImageFormat::exr && !options.quiet)
    say_unwritten(sum.header.named_aovs, options.output);
  std::map<std::string, std::string> metadata = sum.header.metadata;
  metadata["command"] = invocation.command_line;
  metadata["spp"] = std::to_string(sum.header.most);
  if (result.error) metadata["rmse"] = rmse_text(*result.error);
  warn_of_samples(sum.state.unusual);
  static_cast<void>(write({options.output, options.png, sum.header.is_length, {}}, result, metadata, options.quiet));
  const bool lacks_map = !options.error_map.empty() && !result.error;
  if (lacks_map)
    say(fmt::format("strahl: error: --error-map \"{}\" is not written: the error is not known", options.error_map));
  else if (!options.error_map.empty())
    write_error_map(options.error_map, standard_error(sum.state.film), metadata);
  if (!options.quiet)
    say(fmt::format("{} {}×{} · {} spp of {} part{} · {}", options.output, result.color.width, result.color.height,
                    sum.header.most, options.parts.size(), options.parts.size() == 1 ? "" : "s",
                    result.error ? "RMSE " + rmse_text(*result.error) : "error not known"));
  return lacks_map ? ExitCode::failure : ExitCode::ok;
}

ExitCode merge(const MergeOptions& options, const Invocation& invocation) {
  require_outputs(options);
  const bool is_part = is_checkpoint(options.output);
  for (const CLI::Option* option : options.of_pictures)
    if (is_part && option->count() > 0)
      throw UsageError(option->get_name() + " is of a picture; name one with -o (.exr, .png or .pfm)");
  if (!is_part) {
    const std::vector<std::string> layers = read_checkpoint_header(options.parts.front()).aovs;
    require_distinct_layers(options, layers);
    require_writable_layers(options.output, layers);
  }
  const Checkpoint sum = merged(options.parts, !is_part);
  if (!is_part) return write_picture(options, sum, invocation);
  write_checkpoint(options.output, sum);
  if (!options.quiet)
    say(fmt::format("{}: samples {}:{} of {}", options.output, sum.header.first_sample,
                    sum.header.first_sample + sum.header.most, sum.header.spp));
  return ExitCode::ok;
}

}  // namespace

Command add_merge(CLI::App& app, const Invocation& invocation) {
  const auto options = std::make_shared<MergeOptions>();
  app.add_option("parts", options->parts, "Checkpoints of parts")->required()->type_name("PART");
  app.add_option("-o,--output", options->output, "Picture (.png, .exr or .pfm), or a larger part (.ckpt)")
      ->required()
      ->type_name("FILE");
  CLI::Option* error_map =
      app.add_option("--error-map", options->error_map, "Standard error of each pixel, as of `render`");
  error_map->type_name("FILE");
  CLI::Option* exposure = app.add_option("--exposure", options->png.exposure, "PNG: brighter by so many stops");
  require_between(exposure, -64, 64)->type_name("STOPS");
  CLI::Option* bits = app.add_option("--png-bits", options->png.bits, "PNG: 8 or 16 bits a channel");
  options->of_pictures = {error_map, exposure, bits};
  require_whole(bits)->type_name("N")->check(CLI::IsMember({8, 16}))->capture_default_str();
  app.add_flag("-q", options->quiet, "Say nothing but warnings and errors");
  app.footer(merge_footer);
  return [options, &invocation] { return merge(*options, invocation); };
}

}  // namespace strahl::cli
