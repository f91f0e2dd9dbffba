// From values to places between 0 and 1, on a linear or logarithmic scale.

/**
 * @typedef {{log: boolean, least: number, most: number, place: (value: number) => number,
 *   value: (place: number) => number, ticks: (count: number) => number[]}} Scale
 */

// Powers of ten, or one, two and five times them when there is room.
function logTicks(least, most, count) {
  const first = Math.floor(Math.log10(least)),
    last = Math.ceil(Math.log10(most));
  const factors = Math.log10(most / least) * 3 <= count + 1 ? [1, 2, 5] : [1];
  const step = Math.max(1, Math.ceil((last - first) / count));
  const ticks = [];
  for (let power = first; power <= last; power += step) {
    factors.forEach((factor) => ticks.push(Number(`${factor}e${power}`)));
  }
  const inside = ticks.filter((tick) => tick >= least && tick <= most);
  return inside.length >= 2 ? inside : linearTicks(least, most, count);
}

/** Round numbers in a range, about so many. */
export function linearTicks(least, most, count) {
  const raw = (most - least) / Math.max(1, count);
  if (!(raw > 0)) return [least];
  const power = Math.floor(Math.log10(raw)),
    lead = raw / 10 ** power;
  const factor = lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10;
  const step = factor * 10 ** power,
    ticks = [];
  for (let k = Math.ceil(least / step - 1e-9); k * step <= most + 1e-9 * step; ++k) {
    ticks.push(Number((k * step).toPrecision(12)));
  }
  return ticks;
}

/**
 * @param {{least: number, leastPositive: number, most: number}} range
 * @param {boolean} log asked for; a column without positive values stays linear
 * @returns {Scale}
 */
export function makeScale(range, log) {
  let { least, most } = range;
  const logarithmic = log && range.leastPositive < range.most;
  if (logarithmic) least = range.leastPositive;
  if (!(least <= most)) [least, most] = [0, 1];
  if (least === most) {
    const margin = Math.abs(least) * 0.01 || 1;
    [least, most] = [least - margin, most + margin];
  }
  const forward = logarithmic ? Math.log : (x) => x,
    back = logarithmic ? Math.exp : (x) => x;
  const from = forward(least),
    span = forward(most) - from;
  return {
    log: logarithmic,
    least,
    most,
    place: (value) => (forward(value) - from) / span,
    value: (place) => (place <= 0 ? least : place >= 1 ? most : back(from + place * span)),
    ticks: (count) => (logarithmic ? logTicks : linearTicks)(least, most, count),
  };
}
