// SPDX-License-Identifier: MIT
// A logarithmic axis: where a value lies, and which values are named on it.

/// From `start` to `end` in pixels, with some room beyond the least and the largest of the values.
function logScale(values, start, end) {
  const least = Math.log10(Math.min(...values)), most = Math.log10(Math.max(...values));
  const room = Math.max(0.06 * (most - least), 0.08);
  const low = least - room, high = most + room;
  const at = (value) => start + ((Math.log10(value) - low) / (high - low)) * (end - start);
  return { at, start, end, low: 10 ** low, high: 10 ** high, decades: high - low };
}

/// Every multiple of a power of ten; those are labelled that leave `spacing` pixels for each label.
function ticksOf(scale, spacing) {
  const perDecade = Math.abs(scale.end - scale.start) / scale.decades;
  const labelled = [[1, 2, 3, 4, 5, 6, 7, 8, 9], [1, 2, 3, 5], [1, 2, 5], [1, 3], [1]]
    .find((digits) => closest(digits) * perDecade >= spacing) ?? [1];
  const ticks = [];
  for (let exponent = Math.floor(Math.log10(scale.low)); 10 ** exponent <= scale.high; ++exponent) {
    for (let digit = 1; digit <= 9; ++digit) {
      const value = Number(`${digit}e${exponent}`);
      if (value < scale.low || value > scale.high) continue;
      ticks.push({ value, isPower: digit === 1, isLabelled: labelled.includes(digit) });
    }
  }
  return ticks;
}

/// The least distance, in decades, between two of the digits, the next decade's first included.
function closest(digits) {
  return Math.min(...digits.map((digit, i) => Math.log10((digits[i + 1] ?? 10) / digit)));
}
