// SPDX-License-Identifier: MIT
// The errors and the times that can be put on the axes of Figure 1, and the front of what is best by them.

const measures = {
  rmse: { title: "RMSE", of: (point) => point.rmse, bar: (point) => [point.rmse_low, point.rmse_high] },
  relmse: { title: "relMSE", of: (point) => point.relmse },
  flip: { title: "FLIP", of: (point) => point.flip },
  ssim: { title: "1 − SSIM", of: (point) => (isNumber(point.ssim) ? 1 - point.ssim : null) },
  bias: { title: "bias", of: biasOf },
};

const clocks = {
  kernel: { title: "kernel time", of: (point) => point.seconds.kernel },
  wall: { title: "wall time", of: (point) => point.seconds.wall },
};

/// Only where the estimate of bias² is more than its own noise, which comes from few seeds.
function biasOf(point) {
  return point.bias2 > 2 * (point.bias2_error ?? 0) ? Math.sqrt(point.bias2) : null;
}

/// Logarithmic axes have no place for nothing.
function isDrawable(point, measure, clock) {
  return measure.of(point) > 0 && clock.of(point) > 0;
}

/// By time; each has less error than all before it.
function frontOf(some, measure, clock) {
  const front = [];
  const sorted = some.filter((point) => isDrawable(point, measure, clock));
  sorted.sort((a, b) => clock.of(a) - clock.of(b) || measure.of(a) - measure.of(b));
  for (const point of sorted) {
    if (front.length === 0 || measure.of(point) < measure.of(front[front.length - 1])) front.push(point);
  }
  return front;
}
