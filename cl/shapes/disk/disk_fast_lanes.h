// SPDX-License-Identifier: MIT
// Ray against LANES disks as in textbooks: Hesse's plane (plane_fast_lanes.h), then |o + t d - c|^2 <= r^2.

FN void disk_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw cx = load_w(block), cy = load_w(block + LANES), cz = load_w(block + 2 * LANES);
  realw nx = load_w(block + 3 * LANES), ny = load_w(block + 4 * LANES), nz = load_w(block + 5 * LANES);
  realw ox = splat_w(ray->o.x), oy = splat_w(ray->o.y), oz = splat_w(ray->o.z);
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z);
  realw hesse = nx * cx + ny * cy + nz * cz;
  realw t = (hesse - (nx * ox + ny * oy + nz * oz)) / (nx * dx + ny * dy + nz * dz);
  realw px = ox + t * dx - cx, py = oy + t * dy - cy, pz = oz + t * dz - cz;
  maskw hit = le_w(px * px + py * py + pz * pz, load_w(block + 6 * LANES));
  take_nearest_w(hit & in_range_w(t, ray, best), t, ids, -1, SHAPE_disk, slot, best);
}
