"use strict";
// The motion as the page has it, without a page: a track is the pieces of one axis, and a piece, x seconds after its
// start, is at c0 + c1 x + c2 x² + c3 x³ + a sin(w x + f). Nothing is sampled before it is looked at.

const ORDERS = { position: 0, velocity: 1, acceleration: 2, jerk: 3 };
const CURVED_POINTS = 48;

/** The index of the last of `starts` that is not after `time`; 0 before the first. */
function indexAt(starts, time) {
  let low = 0, high = starts.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (starts[middle] <= time) low = middle; else high = middle;
  }
  return low;
}

/** Derivative `order` of a piece, x seconds after its start. */
function evaluate(track, piece, x, order) {
  const [c0, c1, c2, c3] = track.c;
  const value = [
    () => ((c3[piece] * x + c2[piece]) * x + c1[piece]) * x + c0[piece],
    () => (3 * c3[piece] * x + 2 * c2[piece]) * x + c1[piece],
    () => 6 * c3[piece] * x + 2 * c2[piece],
    () => 6 * c3[piece],
  ][order]();
  const wave = track.waves[piece];
  if (!wave) return value;
  const [a, w, f] = wave;
  return value + a * w ** order * Math.sin(w * x + f + (order * Math.PI) / 2);
}

/** Derivative `order` of a track at a time. */
function valueAt(track, time, order) {
  const piece = indexAt(track.starts, time);
  return evaluate(track, piece, Math.max(0, time - track.starts[piece]), order);
}

function isStraight(track, piece, order) {
  return !track.waves[piece] && !(order < 2 && track.c[3][piece]) && !(order < 1 && track.c[2][piece]);
}

/** Collects points and keeps of each of `columns` stretches the first, the lowest, the highest and the last. */
class Thinner {
  constructor(begin, end, columns) {
    this.begin = begin;
    this.perSecond = columns / (end - begin || 1);
    this.column = null;
    this.points = [];
  }

  put(time, value) {
    const column = Math.floor((time - this.begin) * this.perSecond);
    const point = [time, value];
    if (column !== this.column) {
      this.flush();
      this.column = column;
      this.kept = [point];
      this.low = this.high = point;
    }
    if (value < this.low[1]) this.low = point;
    if (value > this.high[1]) this.high = point;
    // In the order in which they came, which at a jump is not that of their times.
    this.kept = this.kept.filter((each, i) => i === 0 || each === this.low || each === this.high).concat([point]);
  }

  flush() {
    if (this.column === null) return;
    for (const point of this.kept) {
      const before = this.points[this.points.length - 1];
      if (!before || before[0] !== point[0] || before[1] !== point[1]) this.points.push(point);
    }
  }

  done() {
    this.flush();
    this.column = null;
    return this.points;
  }
}

/** Points [time, value] of a track from `begin` to `end`: every jump and every peak of each of `columns` stretches. */
function trackPoints(track, order, begin, end, columns) {
  const thinner = new Thinner(begin, end, columns);
  const { starts } = track;
  for (let piece = indexAt(starts, begin); piece < starts.length; piece += 1) {
    if (piece && starts[piece] > end) break;
    const first = Math.max(starts[piece], begin);
    const last = Math.max(first, Math.min(piece + 1 < starts.length ? starts[piece + 1] : end, end));
    const wide = (last - first) * thinner.perSecond;
    const count = isStraight(track, piece, order) ? 1 : Math.min(CURVED_POINTS, Math.max(4, Math.ceil(wide)));
    for (let i = 0; i <= count; i += 1) {
      const time = i === count ? last : first + ((last - first) * i) / count;
      thinner.put(time, evaluate(track, piece, Math.max(0, time - starts[piece]), order));
    }
  }
  return thinner.done();
}

/** The same for values that hold until the next one (`isStepped`), or that lines go between. */
function seriesPoints(times, values, isStepped, begin, end, columns) {
  const thinner = new Thinner(begin, end, columns);
  const first = indexAt(times, begin);
  for (let i = first; i < times.length && (i === first || times[i] <= end); i += 1) {
    const time = Math.max(times[i], isStepped ? begin : times[i]);
    if (isStepped && i > first) thinner.put(time, values[i - 1]);
    thinner.put(time, values[i]);
    if (isStepped && (i + 1 === times.length || times[i + 1] > end)) thinner.put(end, values[i]);
    if (!isStepped && i + 1 < times.length && times[i + 1] > end) thinner.put(times[i + 1], values[i + 1]);
  }
  return thinner.done();
}

/** The value of such a series at a time. */
function seriesAt(times, values, isStepped, time) {
  const i = indexAt(times, time);
  if (isStepped || i + 1 === times.length || time <= times[i]) return values[i];
  const part = (time - times[i]) / (times[i + 1] - times[i]);
  return values[i] + part * (values[i + 1] - values[i]);
}

/** Round values from `low` to `high`, about `count` of them, and how many decimals they need. */
function ticks(low, high, count) {
  const rough = (high - low) / Math.max(1, count);
  if (!(rough > 0) || !isFinite(rough)) return { values: [low], decimals: 0 };
  const power = Math.floor(Math.log10(rough));
  const factor = [1, 2, 2.5, 5, 10].find((each) => each * 10 ** power >= rough * (1 - 1e-9));
  const step = factor * 10 ** power;
  const decimals = Math.max(0, -power + ({ 2.5: 1, 10: -1 }[factor] || 0));
  const values = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9; i += 1) values.push(i * step);
  return { values, decimals };
}

/** A number for a person: six digits that matter, no exponent where it can be helped. */
function figure(value) {
  if (Math.abs(value) < 1e-12) return "0";
  const text = Number(value.toPrecision(6));
  return Math.abs(text) >= 1e9 || Math.abs(text) < 1e-5 ? text.toExponential() : String(text);
}

/** A time with as many decimals as the step from one pixel to the next can show. */
function clock(seconds, step) {
  const decimals = Math.min(9, Math.max(0, Math.ceil(-Math.log10(step || 1))));
  return `${seconds.toFixed(decimals)} s`;
}

/** The move of an axis at a time, and the name of its phase; undefined between moves. */
function moveAt(axis, time) {
  const { moves } = axis;
  if (!moves.length) return undefined;
  const move = moves[indexAt(axis.moveStarts || (axis.moveStarts = moves.map((each) => each.start)), time)];
  if (time < move.start || time > move.start + move.duration) return undefined;
  let end = move.start;
  for (const [name, duration] of move.phases) {
    end += duration;
    if (time <= end) return { move, phase: name };
  }
  return { move, phase: "" };
}
