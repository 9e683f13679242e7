// SPDX-License-Identifier: MIT
#include "cli/scene_aovs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "cli/console.h"
#include "cli/keep_options.h"
#include "errors.h"
#include "kinds/integrators.h"
#include "render/aov.h"
#include "settings/settings.h"

namespace strahl::cli {
namespace {

/// Whose --aov has a channel of one of these names.
std::optional<Aov> namesake(const NamedAov& named, const std::set<Aov>& plain) {
  const std::vector<std::string> channels = channels_of(named);
  for (const Aov aov : plain)
    for (const std::string& channel : aov_channels({aov}))
      if (std::find(channels.begin(), channels.end(), channel) != channels.end()) return aov;
  return std::nullopt;
}

void require_names_apart(const NamedAov& named, const Aov other, const SourceLocation& where) {
  if (other == named.aov) return;
  throw UsageError(
      fmt::format("--aov {} and the scene's AOV \"{}\" ({}) have channels of one name: leave out --aov {}, or give the "
                  "other one another name",
                  aov_name(other), named.name, where.text(), aov_name(other)));
}

}  // namespace

void add_scene_aovs(const Scene& scene, const RenderOptions& options, const std::string& picture, AovList& aovs) {
  const IntegratorSettings& integrator = scene.integrator;
  if (integrator.aovs.empty()) return;
  if (kinds::integrator(integrator.name).from_lights) {
    const std::string why = fmt::format(
        "the AOVs are left out: integrator {} begins its paths on lights, and they need a camera ray in every pixel; "
        "take integrator path for them",
        integrator.name);
    return say(Diagnostic{Severity::warning, integrator.aovs_where, why}.text());
  }
  const bool is_exr = !picture.empty() && image_format(picture) == ImageFormat::exr;
  if (!picture.empty() && !is_exr && !options.scene.quiet) say_unwritten(integrator.aovs, picture);
  // A checkpoint of a PNG may be gone on from to an EXR.
  if (!is_exr && options.keep.target().empty()) return;
  for (const NamedAov& named : integrator.aovs) {
    const std::optional<Aov> other = namesake(named, aovs.plain());
    if (other)
      require_names_apart(named, *other, integrator.aovs_where);  // One layer for both.
    else
      aovs.add(named);
  }
}

void warn_of_later_samples(const KeepOptions& keep, const AovList& aovs) {
  if (!keep.samples || sample_range(*keep.samples).first == 0) return;
  std::vector<std::string> names = aovs.plain_names();
  for (const NamedAov& named : aovs.named())
    if (is_of_first_sample(named.aov)) names.push_back(named.name);
  if (names.empty()) return;
  say(fmt::format(
      "strahl: warning: --samples {}: the picture is without {}, of sample 0 alone; `strahl merge` takes {} "
      "from the part that has it",
      *keep.samples, fmt::join(names, ", "), names.size() == 1 ? "it" : "them"));
}

void warn_of_rounded_ids(const Scene& scene, const AovList& aovs) {
  if (!aovs.contains(Aov::shape_id) && !aovs.contains(Aov::primitive_id)) return;
  for (const Aov aov : rounded_ids(id_counts(scene), aovs))
    say(fmt::format(
        "strahl: warning: the AOV {} rounds numbers above 16777216, of which the scene has some: files hold "
        "them as floats",
        aov_name(aov)));
}

void say_unwritten(const std::vector<NamedAov>& aovs, const std::string& picture) {
  std::vector<std::string> names;
  std::set<std::string> kinds;
  for (const NamedAov& named : aovs) {
    names.push_back(named.name);
    if (is_of_first_sample(named.aov)) kinds.insert(aov_name(named.aov));
  }
  std::string remedy;
  if (!kinds.empty())
    remedy = fmt::format("; --aov {} writes {} as pictures", fmt::join(kinds, ","), kinds.size() == 1 ? "it" : "them");
  say(fmt::format("{}: without the scene's AOVs ({}), which an .exr holds{}", picture, fmt::join(names, ", "), remedy));
}

}  // namespace strahl::cli
