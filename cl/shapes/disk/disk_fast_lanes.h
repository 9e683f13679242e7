// SPDX-License-Identifier: MIT
// Rays against disks as in textbooks: Hesse's plane (plane_fast_lanes.h), then |o + t d - c|^2 <= r^2.

FN realw disk_t_w(real3w o, real3w d, const Disks_w* disk, realw t_min, realw t_max, PRIVATE maskw* which) {
  real3w c = disk->center, n = disk->normal;
  realw hesse = n.x * c.x + n.y * c.y + n.z * c.z;
  realw t = (hesse - (n.x * o.x + n.y * o.y + n.z * o.z)) / (n.x * d.x + n.y * d.y + n.z * d.z);
  realw px = o.x + t * d.x - c.x, py = o.y + t * d.y - c.y, pz = o.z + t * d.z - c.z;
  *which = *which & le_w(px * px + py * py + pz * pz, disk->r2);
  (void)t_min;
  (void)t_max;
  return t;
}
