"use strict";
// The motion as the page has it, without a page: a track is the pieces of one axis, and a piece, x seconds after its
// start, is at c0 + c1 x + c2 x² + c3 x³ + a sin(w x + f). Nothing is sampled before it is looked at.

const ORDERS = { position: 0, velocity: 1, acceleration: 2, jerk: 3 };
const CURVED_POINTS = 48;

/** What the page was given, unpacked: columns told as the different numbers and which of them stands where, and moves. */
function expand(given) {
  const column = (packed) => Float64Array.from(packed.of ? packed.at.map((i) => packed.of[i]) : packed);
  const track = (packed) => ({ starts: column(packed.starts), c: packed.c.map(column), waves: packed.waves, end: given.end, trees: [] });
  const axis = (each) => ({
    ...each,
    track: track(each.track),
    moves: each.moves.which.map((kind, i) => ({ ...each.moves.kinds[kind], start: each.moves.starts[i] })),
  });
  const against = given.against && { ...given.against, axes: given.against.axes.map(axis) };
  return { ...given, axes: given.axes.map(axis), against };
}

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
  const { c, waves } = track;
  const c1 = c[1][piece], c2 = c[2][piece], c3 = c[3][piece];
  let value = 6 * c3;
  if (order === 0) value = ((c3 * x + c2) * x + c1) * x + c[0][piece];
  else if (order === 1) value = (3 * c3 * x + 2 * c2) * x + c1;
  else if (order === 2) value = 6 * c3 * x + 2 * c2;
  const wave = waves[piece];
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
    if (column !== this.column) {
      this.flush();
      this.column = column;
      this.count = this.lowAt = this.highAt = 0;
      this.firstTime = this.lowTime = this.highTime = time;
      this.first = this.low = this.high = value;
    } else this.count += 1;
    if (value < this.low) { this.low = value; this.lowTime = time; this.lowAt = this.count; }
    if (value > this.high) { this.high = value; this.highTime = time; this.highAt = this.count; }
    this.lastTime = time;
    this.last = value;
  }

  // In the order in which they came, which at a jump is not that of their times.
  flush() {
    if (this.column === null) return;
    this.keep(this.firstTime, this.first);
    if (this.lowAt < this.highAt) this.keep(this.lowTime, this.low);
    this.keep(this.highTime, this.high);
    if (this.lowAt > this.highAt) this.keep(this.lowTime, this.low);
    this.keep(this.lastTime, this.last);
  }

  keep(time, value) {
    const before = this.points[this.points.length - 1];
    if (!before || before[0] !== time || before[1] !== value) this.points.push([time, value]);
  }

  done() {
    this.flush();
    this.column = null;
    return this.points;
  }
}

/** Where in a piece of length `length` its derivative `order` may be highest or lowest, its ends left out. */
function turns(track, piece, length, order) {
  if (track.waves[piece]) return Array.from({ length: 15 }, (_, i) => (length * (i + 1)) / 16);
  const [, c1, c2, c3] = track.c.map((column) => column[piece]);
  let found = [];
  if (order === 1 && c3) found = [-c2 / (3 * c3)];
  if (order === 0 && c3) {
    const root = Math.sqrt(c2 * c2 - 3 * c3 * c1);
    found = [(-c2 - root) / (3 * c3), (-c2 + root) / (3 * c3)];
  } else if (order === 0 && c2) found = [-c1 / (2 * c2)];
  return found.filter((x) => x > 0 && x < length).sort((one, other) => one - other);
}

const BRANCHES = 8;

/**
 * The lowest and the highest value of every piece, of every eight pieces, of every eight of those and so on: what lies
 * within one column of the picture is looked up there, so that an hour is drawn as quickly as a second.
 */
function tree(track, order) {
  if (track.trees[order]) return track.trees[order];
  const { starts, end } = track, count = starts.length;
  const level = (size) => ({ lowTime: new Float64Array(size), low: new Float64Array(size), highTime: new Float64Array(size), high: new Float64Array(size) });
  const ground = level(count);
  for (let i = 0; i < count; i += 1) {
    const length = Math.max(0, (i + 1 < count ? starts[i + 1] : end) - starts[i]);
    ground.low[i] = Infinity;
    ground.high[i] = -Infinity;
    for (const x of [0, ...turns(track, i, length, order), length]) {
      const value = evaluate(track, i, x, order);
      if (value < ground.low[i]) { ground.low[i] = value; ground.lowTime[i] = starts[i] + x; }
      if (value > ground.high[i]) { ground.high[i] = value; ground.highTime[i] = starts[i] + x; }
    }
  }
  const levels = [ground];
  for (let below = ground; below.low.length > 1;) {
    const above = level(Math.ceil(below.low.length / BRANCHES));
    above.low.fill(Infinity);
    above.high.fill(-Infinity);
    below.low.forEach((low, i) => {
      const k = Math.floor(i / BRANCHES);
      if (low < above.low[k]) { above.low[k] = low; above.lowTime[k] = below.lowTime[i]; }
      if (below.high[i] > above.high[k]) { above.high[k] = below.high[i]; above.highTime[k] = below.highTime[i]; }
    });
    levels.push(above);
    below = above;
  }
  track.trees[order] = levels;
  return levels;
}

/** Points [time, value] of a track from `begin` to `end`: every jump and every peak of each of `columns` stretches. */
function trackPoints(track, order, begin, end, columns) {
  const thinner = new Thinner(begin, end, columns);
  const { starts } = track, count = starts.length;
  const after = (piece) => (piece < count ? starts[piece] : Math.max(end, track.end));
  const putPiece = (piece) => {
    const first = Math.max(starts[piece], begin), last = Math.max(first, Math.min(after(piece + 1), end));
    const wide = (last - first) * thinner.perSecond;
    const parts = isStraight(track, piece, order) ? 1 : Math.min(CURVED_POINTS, Math.max(4, Math.ceil(wide)));
    for (let i = 0; i <= parts; i += 1) {
      const time = i === parts ? last : first + ((last - first) * i) / parts;
      thinner.put(time, evaluate(track, piece, Math.max(0, time - starts[piece]), order));
    }
  };
  const from = indexAt(starts, begin), to = indexAt(starts, end);
  const levels = to - from > columns ? tree(track, order) : [];
  let piece = from;
  while (piece <= to) {
    // The largest block that begins here, lies in the picture and is no wider than half a column.
    let level = -1, size = 1;
    for (let k = 0, next = 1; k < levels.length && piece % next === 0 && piece + next <= to; k += 1, next *= BRANCHES) {
      if (starts[piece] < begin || (starts[piece + next] - starts[piece]) * thinner.perSecond > 0.5) break;
      level = k;
      size = next;
    }
    if (level < 0) putPiece(piece);
    else {
      const { lowTime, low, highTime, high } = levels[level], k = piece / size, last = piece + size - 1;
      const inner = [[lowTime[k], low[k]], [highTime[k], high[k]]].sort(([one], [other]) => one - other);
      thinner.put(starts[piece], evaluate(track, piece, 0, order));
      for (const [time, value] of inner) thinner.put(time, value);
      thinner.put(starts[last + 1], evaluate(track, last, starts[last + 1] - starts[last], order));
    }
    piece += size;
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

/** When a digital channel is on, in a run that ends at `end`: [begin, end] of each span. */
function spansOn({ times, values }, end) {
  const spans = [];
  let begin = null;
  times.forEach((time, i) => {
    if (values[i] && begin === null) begin = time;
    else if (!values[i] && begin !== null) {
      spans.push([begin, time]);
      begin = null;
    }
  });
  return begin === null ? spans : [...spans, [begin, end]];
}

/** Spans of time as a picture of `first` to `last` can show them, none narrower than `pixel`: `visible` of figure_layout.py. */
function visibleSpans(spans, first, last, pixel) {
  const made = [];
  for (const [start, stop] of spans) {
    if (stop < first || start > last) continue;
    let begin = Math.max(start, first), end = Math.min(stop, last);
    if (end - begin < pixel) {
      begin = Math.min(begin, last - pixel);
      end = begin + pixel;
    }
    const previous = made[made.length - 1];
    if (previous && begin - previous[1] < pixel) {
      if (begin - previous[0] >= 2 * pixel) previous[1] = begin - pixel;
      else if (end - previous[1] >= 2 * pixel) begin = previous[1] + pixel;
      else if (begin <= previous[1]) {
        previous[1] = Math.max(previous[1], end);
        continue;
      }
    }
    made.push([begin, end]);
  }
  return made;
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
