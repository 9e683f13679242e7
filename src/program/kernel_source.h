// SPDX-License-Identifier: MIT
// The text of a kernel file with its includes expanded, restricted to the effects that are active.
//
// Sources come from the binary (embedded at build time) or, for live editing, from the directory that the environment
// variable STRAHL_KERNEL_DIR names. Includes are expanded each time they are named (lanes are compiled by including a
// file repeatedly), with `#line N "shapes/sphere/sphere.h"`, so that drivers report the right place.
//
// A file within an include guard is left out once it stands in the text unconditionally; #pragma once is refused,
// because a driver's compiler sees one text, in which it means nothing.
//
// `.def` lists (shapes/shapes.def, materials/materials.def, ...) hold one entry a line, `SHAPE(sphere, ...)`, and
// comments: the expander keeps the lines of active entries only, and the includes `"shapes/sphere/sphere.h"`,
// `"shapes/sphere/sphere_lanes.h"`, `"shapes/sphere/sphere_surfaces_lanes.h"` and `"shapes/sphere/sphere_body_lanes.h"`
// are dropped where `sphere` is an entry of shapes/shapes.def that is not active. What several entries share is
// included by a list file (all.h, all_lanes.h, all_surfaces_lanes.h) with their names, `#include "math/roots.h"  // of
// sphere, disk` (or `// not of box`), and dropped where none of them (no other one) is active. In list files and
// entries' own files a section `#if HAS_X` ... `#endif` is left out where the feature is off, and stands without these
// two lines where it is on. So a program's text does not change when somebody adds an effect that it does not use; for
// the same reason neither .def files nor the list files, which hold includes only, put #line directives of their own
// into the text.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "program/kernel_files.h"

namespace strahl {

/// Active entries per list, keyed by the list's folder ("shapes" -> {"plane", "sphere"}). A list that is absent here
/// is complete: every entry is active (what --generic and the lint use).
using ActiveEntries = std::map<std::string, std::set<std::string>>;

/// Features of cl/features.def, and whether they are on; one that is absent here is on.
using ActiveFeatures = std::vector<std::pair<std::string, bool>>;

/// Names of the entries of cl/<folder>/<folder>.def in file order; throws std::logic_error for an unknown list.
[[nodiscard]] std::vector<std::string> list_entries(const std::string& folder);
/// Entries of cl/features.def: name and reason.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> list_features();
/// Folders that have a list (shapes, materials, lights, integrators, ...), sorted.
[[nodiscard]] std::vector<std::string> list_folders();

/// The expanded text of `root` (a path below cl/, "kernels/render.cl"). Throws std::logic_error that names the
/// including file and line where an include is missing or goes in a circle, where a list holds something else than
/// entries, and where `active` names what is in no list.
[[nodiscard]] std::string expand_kernel(const std::string& root, const ActiveEntries& active,
                                        const ActiveFeatures& features = {});

// The same on files of one's own.
[[nodiscard]] std::vector<std::string> list_entries(const KernelFiles& files, const std::string& folder);
[[nodiscard]] std::vector<std::pair<std::string, std::string>> list_features(const KernelFiles& files);
[[nodiscard]] std::vector<std::string> list_folders(const KernelFiles& files);
[[nodiscard]] std::string expand_kernel(const KernelFiles& files, const std::string& root, const ActiveEntries& active,
                                        const ActiveFeatures& features = {});

}  // namespace strahl
