// SPDX-License-Identifier: MIT
// Ambient occlusion: the share of ways from the first hit into the open (core/openness.h) that meet nothing within a
// reach. Materials and lights do not count; black where nothing is hit.

FN int ao_step(const Scene* scene, Path* path, int hit, const Surface* s) {
  (void)scene;
  (void)path;
  (void)s;
  return hit ? STEP_OPENNESS : 0;
}
