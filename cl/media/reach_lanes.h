// SPDX-License-Identifier: MIT
// How far paths in media need to see. In a homogeneous medium the place where a path scatters is known from the number
// that draws it, so nothing behind that place is looked for: in dense media rays are short. One width; no guard.

/// t along the path's rays where they may end, a little behind the places where the paths scatter if they meet nothing;
/// REAL_MAX: no end is known. Draws optical depths for the paths that have none yet.
FN realw scatter_reach_w(const Scene* scene, Paths_w* path) {
  realw most = splat_w(REAL_MAX), zero = splat_w(R(0.0));
  maskw which = path->alive & is_within_w(path->medium);
  // No path has a first way without a depth, as in Mitsuba.
  if (scene->index[HEADER_MAX_DEPTH] == 0 || !any_w(which)) return most;
  maskw is_new = which & lt_w(path->optical, zero);
  if (any_w(is_new)) {
    Random2_w numbers = vertex_pair_w(scene, &path->sample, path->depth, USE_DISTANCE);
    path->optical = sel_w(is_new, optical_depth_w(numbers.x, numbers.y), path->optical);
  }
  realw length = media_reach_w(scene, path->medium, &path->sample, which, path->optical);
  real3w o = real3_at_w(path->rays.planes + RAY_PLANE_O), d = real3_at_w(path->rays.planes + RAY_PLANE_D);
  // The way begins at `entered`, the ray somewhere on its line; what rounding makes of both is far less than the rest.
  realw size = length3_w(d), before = dot3_w(sub3_w(path->entered, o), d) / size;
  realw slack = splat_w(R(0x1p-18)) * (largest_of_w(o.x, o.y, o.z) + abs_w(before));
  realw reach = (fma_w(splat_w(R(1.0) + R(0x1p-8)), length, slack) + before) / size;
  return sel_w(which & lt_w(length, most), min_w(reach, most), most);
}

/// The paths' rays as they are without a cut, and how they are cut.
typedef struct {
  maskw cut;        ///< Lanes whose rays were cut,
  realw reach;      ///< to this t: scatter_reach_w.
  realw t_max;      ///< The end of the whole rays.
  realw travelled;  ///< Of the paths, before the rays.
} Outlook_w;

/// Cuts the paths' rays for the search for surfaces, but those of `whole`; media_travel_w gives them their ends back.
FN Outlook_w look_ahead_w(const Scene* scene, Paths_w* path, maskw whole) {
  Outlook_w outlook;
  PRIVATE realw* t_max = path->rays.planes + RAY_PLANE_T_MAX;
  outlook.travelled = path->travelled;
  outlook.t_max = *t_max;
  outlook.reach = scatter_reach_w(scene, path);
  outlook.cut = path->alive & lt_w(outlook.reach, *t_max) & ~whole;
  *t_max = sel_w(outlook.cut, outlook.reach, *t_max);
  return outlook;
}
