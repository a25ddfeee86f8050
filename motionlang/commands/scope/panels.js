// What there is to see: the panels that are switched on, from the top down, with their curves, lanes and bands.

const LANE = 22;
const HEIGHTS = { position: 118, velocity: 118, acceleration: 96, jerk: 84, "following error": 96, output: 96 };
const EVENT_HEIGHT = 26;

/** Every panel that is switched on. */
function chosenPanels() {
  const made = [];
  if (data.events.length && !hidden.has("events")) made.push({ events: data.events, height: EVENT_HEIGHT, head: "events" });
  for (const axis of data.axes) {
    if (hidden.has(axis.name)) continue;
    const group = data.quantities.map((quantity) => motionPanel(axis, quantity)).concat(axis.servo.map(servoPanel));
    const shown = group.filter((panel) => panel && !hidden.has(panel.quantity));
    if (shown.length) shown[0].head = axis.name;
    for (const panel of shown) made.push({ ...panel, axis });
  }
  if (data.bands.length && !hidden.has("waits")) {
    made.push({ bands: data.bands, height: LANE * data.bands.length, head: "waits" });
  }
  if (hidden.has("channels")) return made;
  const channels = data.lanes.filter((lane) => !lane.digital).map(analoguePanel);
  const digital = data.lanes.filter((lane) => lane.digital);
  if (digital.length) channels.push({ lanes: digital, height: LANE * digital.length });
  if (channels.length) channels[0].head = "channels";
  return made.concat(channels);
}

function trackCurve(track, kind, order) {
  return {
    kind,
    points: (begin, end) => trackPoints(track, order, begin, end, width),
    at: (time) => valueAt(track, time, order),
  };
}

function motionPanel(axis, [quantity, unit]) {
  const order = ORDERS[quantity], other = data.against && data.against.axes.find((each) => each.name === axis.name);
  if (quantity === "jerk" && !axis.jerks && !(other && other.jerks)) return null;
  const curves = [trackCurve(axis.track, quantity, order)];
  if (quantity === "position" && axis.motor) curves.unshift(seriesCurve(axis.motor, "motor"));
  const recorded = data.measured.find((each) => each.axis === axis.name && each.quantity === quantity);
  if (recorded) curves.unshift(seriesCurve(recorded, "measured"));
  if (other) curves.unshift(trackCurve(other.track, "against", order));
  return { quantity, unit, height: HEIGHTS[quantity], curves, zero: quantity !== "position" };
}

function servoPanel(series) {
  const kind = series.quantity === "output" ? "output" : "error";
  return { quantity: series.quantity, unit: series.unit, height: HEIGHTS[series.quantity], curves: [seriesCurve(series, kind, kind === "output")], zero: true };
}

function analoguePanel(lane) {
  return { quantity: lane.name, unit: "%", height: 70, curves: [seriesCurve(lane, "analogue", true)] };
}

function seriesCurve({ times, values }, kind, isStepped = false) {
  return {
    kind,
    points: (begin, end) => seriesPoints(times, values, isStepped, begin, end, width),
    at: (time) => seriesAt(times, values, isStepped, time),
  };
}

/** What a chip can switch: names of axes, groups of lanes, and quantities. */
function switches() {
  const groups = data.axes.map((axis) => axis.name);
  if (data.events.length) groups.push("events");
  if (data.bands.length) groups.push("waits");
  if (data.lanes.length) groups.push("channels");
  const quantities = data.quantities.map(([quantity]) => quantity).filter((each) => each !== "jerk" || data.axes.some((axis) => axis.jerks));
  for (const axis of data.axes) for (const { quantity } of axis.servo) if (!quantities.includes(quantity)) quantities.push(quantity);
  return { groups, quantities };
}
