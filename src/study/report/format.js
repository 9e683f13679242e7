// SPDX-License-Identifier: MIT
// Numbers and times as they are read: three digits, a real minus sign, powers of ten where zeros would be counted.

const missing = "–";

function superscript(integer) {
  return String(integer).replace(/[-\d]/g, (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]));
}

function isNumber(value) {
  return typeof value === "number" && Number.isFinite(value);
}

function number(value, digits = 3) {
  if (!isNumber(value)) return missing;
  if (value === 0) return "0";
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e").map(Number);  // Of the rounded value.
  if (exponent < -4 || exponent > 5) {
    const power = `10${superscript(exponent)}`;
    return (mantissa === 1 ? power : `${mantissa} · ${power}`).replace("-", "−");
  }
  return (exponent >= digits ? value.toFixed(0) : value.toPrecision(digits)).replace("-", "−");
}

/// Without zeros at its end: for ticks, whose values are short.
function shortNumber(value) {
  const text = number(value);
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

function range(low, high, digits = 3) {
  return isNumber(low) && isNumber(high) ? `${number(low, digits)} … ${number(high, digits)}` : missing;
}

const units = [[1e-6, "µs"], [1e-3, "ms"], [1, "s"], [60, "min"], [3600, "h"]];

function seconds(value, format = number) {
  if (!isNumber(value)) return missing;
  const rounded = Number(value.toPrecision(3));  // 999.6 ms are a second.
  const [size, unit] = units.findLast(([least]) => rounded >= least * (least === 60 ? 2 : 1)) ?? units[0];
  return `${format(value / size)}\u00a0${unit}`;
}

/// 2.3 ×; ratios need no more than two digits. Numbers do not part from what they count.
function times(ratio) {
  return isNumber(ratio) ? `${number(ratio, 2)}\u00a0×` : missing;
}

function percent(share) {
  return `${number(100 * share, 2)}\u00a0%`;
}

function median(values) {
  const sorted = values.filter(isNumber).sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  if (sorted.length === 0) return null;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
