// The live board of kinoedu, in plain JavaScript: no build step, no downloads.
//
// The browser knows a *scene*: the things on the board, and which of them can be dragged. It sends
// each change to Python, which answers with a *drawing*: layers of lines, dots, arrows and texts,
// and a text below the picture. Only Python knows what they mean.
//
//   Board   shared by all views of one widget: the scene, its changes, the answers, the step shown
//   View    one picture of it on a page: painting, pointers and keys
//   Code    the code beside a picture, where the drawing has a *listing*: each step is a line that
//           has run
//   Pointer what is under the pointer, or chosen by keys: rows of layers have *notes*, numbers that
//           fill the blanks of a text
//
// A *stop* is a handle that the answer draws. A click on it moves the second handle (the goal)
// there, Shift and click the first.
//
// A *drawn* item is painted only by the answer, which may move it: an arm's tip stays within reach,
// wherever it is pulled.
//
// A *driven* item is moved only by Python, while arrow keys are held: see `hold`.
//
// In a *posed* scene the handles are pairs of a place and its tip, the point that it looks at. A
// press on the ground moves the second place there, with Shift the first, and its tip is dragged.
//
// A *thing* can be moved: {kind: "handle" | "disc" | "polygon", i}, or {kind: "vertex", i, r, v},
// which is vertex v of ring r.

const IN_FLIGHT = 3;          // most questions open at once, to hide the delay of a round trip
const SPACING = 15;           // ms between two questions, in which the page paints
const BUSY = 8;               // ms: after a slower answer two questions are open at a time
const SLOW = 100;             // ms: after a slower answer only one question is open at a time
const VERY_SLOW = 1000;       // ms: after a slower answer a question waits for a release or a rest
const LATE = 25;              // ms: where answers come later, the page is slow
const RESTED = 400;           // ms between two paintings beside a dragged board, on a slow page
const PENDING = 250;          // ms after which an outdated answer is shown pale
const QUIET = 600;            // ms without change before the text is read out
const GROWTH = 4000;          // ms to play the whole growth
const TICK = 40;              // ms between two messages while keys are held
const JITTER = 4;             // pixels: a pointer that moved less has clicked
const TURNS = 12;             // pixels: a pointer that moved less has not turned a new pose
const BATCH = 64;             // segments that are painted at once: very long paths take longer
const TEXTS = 500;            // the widths of so many texts are kept
const MANY = 200, FINE = 1.5; // more segments than this, if so narrow, are painted one pixel wide
const TINT = 0.35, STRIPES = 9;   // the opacity of a body; the distance of its stripes in pixels
const NEAR = 10, NEAR_FINGER = 24;   // pixels: what is so near a pointer is meant
const RING = 13;              // pixels: the radius of a ring round a handle that hides a dot
const ALONG = 300;            // places on a motion at which it is looked for what it meets
const NAMING = "[class^='ke-']", DIM = 0.2;   // words for things; the strength of the rest
const READING = ["pointerover", "focusin", "focusout"];   // events at a word of the lesson
const WIDEST = 640, HIGHEST = 560, PAD = 8;   // the size of the picture, in pixels

// The boards by their widgets' keys. They are global, because each widget loads this file again.
const boards = (globalThis[Symbol.for("kinoedu.boards")] ??= new Map());

export default {
  initialize({ model }) {
    const board = new Board(model);
    boards.set(board.key, board);
    return () => { board.stop(); boards.delete(board.key); };
  },
  render({ model, el }) {
    const view = new View(boards.get(model.get("key")), el);
    return () => view.close();
  },
};

// ---- small tools

const copy = (value) => JSON.parse(JSON.stringify(value));
const BESIDE = [[10, -12], [10, 14], [-10, -12], [-10, 14]];   // the spots of a label at its point
const SPOTS = [28, 44].reduce((spots, away) => [
  ...spots, [10, -away], [10, away + 2], [-10, -away], [-10, away + 2],
], BESIDE);
const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
const SIGNS = { ArrowLeft: "◀", ArrowUp: "▲", ArrowDown: "▼", ArrowRight: "▶" };
const overlap = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
const apart = ([left, top, right, bottom], [x, y]) =>   // a box and a point
  Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom));
// Whether a segment passes through a box (Liang and Barsky, 1984).
function passes([ax, ay, bx, by], [left, top, right, bottom]) {
  let from = 0, to = 1;
  for (const [a, d, low, high] of [[ax, bx - ax, left, right], [ay, by - ay, top, bottom]]) {
    const enters = (low - a) / d, leaves = (high - a) / d;   // infinite, or NaN, where d is 0
    from = Math.max(from, Math.min(enters, leaves));
    to = Math.min(to, Math.max(enters, leaves));
  }
  return from < to;
}
// A number in words: four digits, or three where it has been added up.
const short = (x, digits = 4) => {
  const rounded = Math.abs(x) < 1e4 ? Number(x.toPrecision(digits)) : Math.round(x);
  return String(rounded);
};
function floats(view) {
  const end = view.byteOffset + view.byteLength;
  return new Float32Array(view.buffer.slice(view.byteOffset, end));
}

// A name of a thing, such as "vertex-0-1-2".
function nameOf({ kind, i, r, v }) {
  return [kind, i, r, v].filter((part) => part !== undefined).join("-");
}

const LISTS = { handle: "handles", disc: "discs", polygon: "polygons" };

// The places of all things, each [kind, number, coordinates].
function placesOf(scene) {
  return Object.entries(LISTS).flatMap(([kind, list]) => scene[list].map(
    (item, i) => [kind, i, kind === "polygon" ? item.rings : item.at],
  ));
}

const solidOnes = ({ polygons }) => polygons.filter(({ colour }) => !colour);  // obstacles
const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
const distanceOnPage = (a, b) => Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);

function distanceToSegment(p, a, b) {
  const along = [b[0] - a[0], b[1] - a[1]], squared = along[0] ** 2 + along[1] ** 2;
  const dot = (p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1];
  const share = squared ? clamp(dot / squared, 0, 1) : 0;
  return distance(p, [a[0] + share * along[0], a[1] + share * along[1]]);
}

function lengthOf(line) {
  return line.reduce((sum, p, k) => (k ? sum + distance(line[k - 1], p) : 0), 0);
}

// Let Tab reach the words of the page that name things, which may have come a moment ago.
function offerWords({ key }) {
  if (key !== "Tab") return;
  document.querySelectorAll(`${NAMING}:not([tabindex])`).forEach((word) => { word.tabIndex = 0; });
}

// Copy text where a page may not use the clipboard by itself, as one without encryption.
function copyByHand(text) {
  const area = make("textarea", "", document.body);
  area.value = text;
  area.select();
  document.execCommand("copy");
  area.remove();
}

function crossings(y, rings) {           // the x where a horizontal line crosses edges, ascending
  return rings.flatMap((ring) => ring.flatMap(([ax, ay], i) => {
    const [bx, by] = ring[(i + 1) % ring.length];
    return (ay > y) !== (by > y) ? [ax + ((y - ay) / (by - ay)) * (bx - ax)] : [];
  })).sort((a, b) => a - b);
}

// Whether a point is in the first ring and outside the others. Then a ray crosses an odd number of
// edges.
function inside(x, y, rings) {
  return crossings(y, rings).filter((at) => x < at).length % 2 === 1;
}

// The middle of the longest piece of a horizontal line that is within rings; null without one.
function middleAt(y, rings) {
  const at = crossings(y, rings);
  const lengths = at.map((x, k) => (k % 2 ? x - at[k - 1] : 0));
  const k = lengths.indexOf(Math.max(...lengths));
  return k > 0 ? (at[k - 1] + at[k]) / 2 : null;
}

// A colour "#rrggbb" as a pixel of a canvas's image: bytes a, b, g, r.
function pixelOf(colour) {
  const [r, g, b] = [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16));
  return (255 << 24) | (b << 16) | (g << 8) | r;
}

// ---- shared by all views

class Board {
  constructor(model) {
    this.model = model;
    this.key = model.get("key");
    this.words = model.get("words");
    const themes = model.get("palette");
    this.themes = themes.light ? themes : { light: themes, dark: themes };
    this.palette = this.themes.light;    // the colours by their names, in the page's theme
    this.views = new Set();
    this.id = Math.random().toString(36).slice(2);       // of this page; a widget may be on several
    this.scene = copy(model.get("scene"));
    this.drawing = { text: "", warning: "", layers: [], places: [], refused: false };
    Object.assign(this.drawing, { total: 0, unit: "", stepTexts: [], listing: null });
    this.seq = 0;                                        // the number of the newest scene
    this.shown = 0;                                      // the number of the scene that is answered
    this.open = 0;                                       // questions without an answer
    Object.assign(this, { stale: 0, answers: 0, took: 0, bitmaps: 0, unkept: false });
    this.lost = false;                                   // whether Python has ended or restarted
    Object.assign(this, { waiting: false, pendingSince: null, step: 0, playing: null });
    Object.assign(this, { held: new Set(), ticking: 0, completing: 0, asked: 0 });
    Object.assign(this, { lag: 0, painted: -RESTED });   // ms until an answer; when last painted
    this.moved = new Map();                              // the things moved since the last question
    this.movedIn = new Map();                            // the number of the scene a thing moved in
    model.on("msg:custom", (message, buffers) => this.receive(message, buffers));
    model.on("change:scene", () => this.replaced());
    model.on("change:bitmap", () => this.laid());
    model.on("comm_live_update", () => { this.lost = true; this.changed(); });
    this.send({ kind: "hello" });
  }

  stop() {
    this.pause();
    this.release();
    [this.timer, this.resting, this.completing, this.painting].forEach(clearTimeout);
  }

  // Paint. On a slow page a board is painted seldom while its partner is dragged.
  changed() {
    clearTimeout(this.painting);
    const rest = this.painted + RESTED - performance.now();
    if (rest > 0 && this.partners().some((other) => other.isDragged() && other.lag > LATE)) {
      this.painting = setTimeout(() => this.changed(), rest);
      return;
    }
    this.painted = performance.now();
    this.views.forEach((view) => view.request());
  }

  isDragged() { return [...this.views].some((view) => view.grabs.size > 0); }

  // the scene: the places of things, and moving them

  things() {
    if (this.model.get("recorded")) return [];
    const { handles, polygons, discs } = this.scene;
    const found = handles.map((_, i) => ({ kind: "handle", i }));
    polygons.forEach((polygon, i) => { if (polygon.movable) found.push({ kind: "polygon", i }); });
    discs.forEach((disc, i) => { if (disc.movable) found.push({ kind: "disc", i }); });
    return found;
  }

  vertices(i) {
    const polygon = this.scene.polygons[i];
    if (!polygon.vertices) return [];
    return polygon.rings.flatMap((ring, r) => ring.map((_, v) => ({ kind: "vertex", i, r, v })));
  }

  item({ kind, i }) {
    const { handles, discs, polygons } = this.scene;
    return { handle: handles, disc: discs, polygon: polygons, vertex: polygons }[kind][i];
  }

  shape(thing) {                         // the coordinates: a point, or the rings of a polygon
    const item = this.item(thing);
    if (thing.kind === "polygon") return item.rings;
    return thing.kind === "vertex" ? item.rings[thing.r][thing.v] : item.at;
  }

  place(thing) {                         // one point; of a polygon one inside, at best its middle
    if (thing.kind !== "polygon") return this.shape(thing);
    const rings = this.shape(thing);
    const [x, y] = [0, 1].map((k) => {
      const values = rings[0].map((p) => p[k]);
      return (Math.min(...values) + Math.max(...values)) / 2;
    });
    return inside(x, y, rings) ? [x, y] : [middleAt(y, rings) ?? x, y];
  }

  // Move a thing of the shape `from` by the vector from `anchor` to `to`. `to` stays in the world.
  move(thing, from, anchor, to) {
    const { decimals } = this.scene, kept = this.kept(to);
    const shift = [0, 1].map((k) => kept[k] - anchor[k]);
    const item = this.item(thing), taken = this.riders(item);
    const moved = (point, by, digits) => point.map((x, k) => Number((x + by[k]).toFixed(digits)));
    if (thing.kind === "polygon") {
      const rounded = shift.map((d) => Number(d.toFixed(decimals)));
      item.rings = from.map((ring) => ring.map((p) => moved(p, rounded, decimals + 3)));
    } else {
      const point = moved(from, shift, decimals);
      if (thing.kind === "vertex") item.rings[thing.r][thing.v] = point; else item.at = point;
      for (const i of taken) this.scene.handles[i].at = [...point];
    }
    const kind = thing.kind === "vertex" ? "polygon" : thing.kind;
    this.hasMoved({ kind, i: thing.i }, ...taken.map((i) => ({ kind: "handle", i })));
  }

  kept([x, y]) {                         // clamped to the world, or wrapped where sides are glued
    const { lo, hi, glued } = this.scene;
    if (!glued) return [clamp(x, lo[0], hi[0]), clamp(y, lo[1], hi[1])];
    return [x, y].map((value, k) => {
      const low = glued.lo[k], period = glued.hi[k] - low;
      return low + ((((value - low) % period) + period) % period);
    });
  }

  riders(stop) {                         // the handles exactly on a stop, which move with it
    const { handles } = this.scene;
    if (!stop.stop) return [];
    return [...handles.keys()].filter((i) => !handles[i].stop && same(handles[i].at, stop.at));
  }

  call(i, stop) {                        // move handle i to a stop
    this.scene.handles[i].at = [...stop.at];
    this.hasMoved({ kind: "handle", i });
  }

  hasMoved(...things) {
    this.seq += 1;
    this.mark(things);
    this.pendingSince ??= performance.now();
    clearTimeout(this.completing);
    this.ask(false);
    this.changed();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.changed(), PENDING + 20);
  }

  mark(things) {                         // as moved here: Python hears of them next
    for (const { kind, i } of things) {
      this.moved.set(`${kind}-${i}`, [kind, i]);
      this.movedIn.set(`${kind}-${i}`, this.seq);
    }
  }

  settle() {                             // after a release: keep the scene when it is answered
    this.unkept = true;
    this.ask(true);
    if (this.shown === this.seq) this.complete(0);
    this.keep();
  }

  complete(wait) {                       // ask for the whole of a brief drawing, after some ms
    clearTimeout(this.completing);
    if (!this.drawing.brief || this.drawing.refused) return;
    this.completing = setTimeout(() => this.send({ kind: "hello" }), wait);
  }

  keep() {
    if (!this.unkept || this.shown !== this.seq) return;
    this.unkept = false;
    this.put(this.drawing.places);
    this.send({ kind: "keep" });
  }

  reset() {
    this.scene = copy(this.model.get("home"));
    this.seq += 1;
    this.mark(placesOf(this.scene).map(([kind, i]) => ({ kind, i })));
    this.settle();
    this.changed();
  }

  replaced() {                           // Python or another page set the scene: get its drawing
    const before = copy(this.scene);
    this.put(placesOf(this.model.get("scene")));
    if (same(before, this.scene)) return;
    this.send({ kind: "hello" });
    this.changed();
  }

  laid() {                               // Python set another bitmap
    this.bitmaps += 1;
    this.views.forEach((view) => { view.laid = false; });
    this.changed();
  }

  // Move things to places that Python sent, except those held, and those that have moved since the
  // newest scene that is answered.
  put(places) {
    const grabs = [...this.views].flatMap((view) => [...view.grabs.values()]);
    const held = grabs.map(({ thing }) => this.item(thing));
    for (const [kind, i, where] of places) {
      const item = this.item({ kind, i }), isNewer = this.movedIn.get(`${kind}-${i}`) > this.shown;
      if (isNewer || held.includes(item)) continue;
      item[kind === "polygon" ? "rings" : "at"] = copy(where);
    }
  }

  // questions and answers

  send(message) {
    if (this.lost) return;
    try {
      this.model.send({ ...message, from: this.id });
    } catch (error) {                    // Python was shut down
      this.lost = true;
      this.changed();
      reportError(error);
    }
  }

  ask(released) {
    const limit = this.took > SLOW ? 1 : this.took > BUSY ? 2 : IN_FLIGHT;
    const early = this.asked + SPACING - performance.now();
    clearTimeout(this.resting);
    if (early > 0 && !this.unkept) {
      this.resting = setTimeout(() => this.ask(released), early);
      return;
    }
    if (this.took > VERY_SLOW && !released) {
      this.resting = setTimeout(() => this.ask(true), REST);
      return;
    }
    this.waiting = this.open >= limit;
    if (this.waiting || this.moved.size === 0) return;
    const moved = [...this.moved.values()].map(([kind, i]) => [kind, i, this.shape({ kind, i })]);
    this.moved.clear();
    this.open += 1;
    this.asked = performance.now();
    keepStill();
    this.send({ kind: "scene", seq: this.seq, moved });
    this.emit("sent", this.seq);
  }

  receive(message, buffers) {
    if (message.kind === "code" && message.to === this.id) this.copy(message.text);
    if (!["drawing", "skipped"].includes(message.kind)) return;
    if (message.to && message.to !== this.id) return;
    if (message.seq !== null) this.open = Math.max(this.open - 1, 0);
    if (message.kind === "drawing") {
      const stale = message.seq !== null && message.seq < this.shown;
      if (stale) this.stale += 1; else this.show(message, buffers);
    }
    if (this.waiting) this.ask(true);
  }

  async copy(text) {                     // put code on the clipboard, and say so
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      copyByHand(text);
    }
    this.sayOfCode(this.words.copied);
  }

  sayOfCode(text) { this.views.forEach(({ copying }) => write(copying, text)); }

  // driving: while keys are held, Python gets a message every TICK and moves the driven handle

  hold(key, down) {
    if (down) this.held.add(key); else this.held.delete(key);
    if (down && !this.ticking) this.tick();
  }

  release() { this.held.clear(); }

  tick() {
    this.ticking = this.held.size ? setTimeout(() => this.tick(), TICK) : 0;
    if (!this.held.size || this.open >= IN_FLIGHT) return;
    this.open += 1;
    keepStill();
    this.send({ kind: "keys", seq: this.seq, held: [...this.held] });
    this.emit("sent", this.seq);
  }

  show(message, buffers) {
    const layers = message.layers.map((layer, i) => ({ ...layer, data: floats(buffers[i]) }));
    const { seq, text, warning, total, unit, step_texts: stepTexts, places, took } = message;
    const { listing, first, challenges = [], brief = false } = message, before = this.drawing;
    const completed = before.brief && !brief;   // the same answer, now whole
    const scrubbed = (before.listing || completed) && this.step < before.total;
    const refused = Boolean(warning) && layers.length === 0;   // the last good picture stays
    this.drawing = refused ? { ...before, warning, places, refused }
      : { text, warning, layers, total, unit, stepTexts, places, listing, refused, brief };
    this.drawing.challenges = challenges;
    // the lines stay beside the picture, though of before, until there are new ones
    if (brief) Object.assign(this.drawing, { listing: before.listing });
    if (brief && before.listing) this.drawing.total = before.total;
    if (!completed) this.sayOfCode(this.words.copy);   // what was copied is of before
    this.took = took;
    this.answers += 1;
    if (seq !== null) this.shown = seq;
    const lag = this.pendingSince === null ? 0 : performance.now() - this.pendingSince;
    this.lag += (lag - this.lag) / 4;
    this.put(places);
    this.complete(this.unkept ? 0 : REST);
    this.keep();
    this.pendingSince = seq !== null && seq < this.seq ? performance.now() : null;
    this.playing = null;
    if (!refused) {
      const end = this.drawing.total, opened = this.answers === 1 ? first ?? end : end;
      this.step = scrubbed ? Math.min(this.step, end) : opened;
      if (opened < end) this.lead();     // all pictures of a link open at its step
      if (completed) this.join();
    }
    this.emit("answered", seq);
    this.changed();
    if (refused !== before.refused) this.partners().forEach((other) => other.changed());
  }

  emit(name, seq) { this.views.forEach((view) => view.emit(name, seq)); }

  // growth

  growTo(step) {
    this.step = clamp(Math.round(step), 0, this.drawing.total);
    this.lead();
    this.changed();
  }

  team() { return this.model.get("partner") || this.key; }

  partners() {                           // the boards that show more of the same
    return [...boards.values()].filter((it) => it !== this && it.team() === this.team());
  }

  lead() {                               // scrub the partners that have the same number of steps
    for (const other of this.partners()) {
      if (other.drawing.total !== this.drawing.total) continue;
      Object.assign(other, { step: this.step, playing: null });
      other.changed();
    }
  }

  join() {                               // once whole, take the step of scrubbed partners
    const end = this.drawing.total;
    const ahead = this.partners().find(({ step, drawing: { brief, total } }) => (
      !brief && total === end && step < end));
    if (ahead) this.step = ahead.step;
    else if (this.step < end) this.lead();
  }

  pause() { this.playing = null; this.changed(); }

  play() {
    if (this.playing) { this.pause(); return; }
    const { total } = this.drawing;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.growTo(this.step >= total ? 0 : this.step + Math.ceil(total / 20));
      return;
    }
    const from = this.step >= total ? 0 : this.step;
    const playing = this.playing = { since: null };
    const tick = (now) => {
      if (this.playing !== playing) return;
      playing.since ??= now;
      this.step = Math.min(Math.floor(from + ((now - playing.since) / GROWTH) * total), total);
      if (this.step >= total) this.playing = null; else requestAnimationFrame(tick);
      this.lead();
      this.changed();
    };
    requestAnimationFrame(tick);
  }

  // The variables after the present step, by name, those that its line has changed, and those that
  // have the value of an earlier round of their loop.
  variables() {
    const { changes, old = [] } = this.drawing.listing, values = new Map();
    for (const changed of changes.slice(0, this.step)) {
      for (const [name, text] of Object.entries(changed)) {
        if (text === null) values.delete(name); else values.set(name, text);
      }
    }
    return {
      values,
      changed: Object.keys(changes[this.step - 1] ?? {}),
      old: old.slice(0, this.step).findLast((names) => names !== null) ?? [],
    };
  }

  line() { return this.drawing.listing.ran[this.step - 1] ?? -1; }

  // Go to the next time that a line runs, after the last one to its first time.
  goToLine(line) {
    const { ran } = this.drawing.listing;
    const next = ran.indexOf(line, this.step);
    this.playing = null;
    this.growTo((next < 0 ? ran.indexOf(line) : next) + 1);
  }

  lineText() {                           // the present line in words, for those who hear it
    const { lines } = this.drawing.listing, { values, changed } = this.variables();
    const news = changed.filter((name) => values.has(name) && name !== this.words.condition);
    if (values.has(this.words.condition)) news.unshift(this.words.condition);
    const texts = news.map((name) => `${name} = ${values.get(name)}`);
    return [lines[this.line()]?.trim().replace(/:$/, ""), ...texts].filter(Boolean).join("; ");
  }

  text() {
    const { text, warning, total, unit, stepTexts, listing, brief, refused } = this.drawing;
    if (this.isLate()) return this.lost ? this.words.lost : this.words.thinking;
    if (refused) return warning;
    if (this.step < total && listing && !brief) return this.lineText() || this.words.begin;
    if (this.step < total && !warning && !brief) {
      return stepTexts[this.step] ?? fill(this.words.growth, { shown: this.step, total, unit });
    }
    return warning || text;
  }

  // Also where the board beside is refused, of which this one shows more.
  isPale() {
    const first = boards.get(this.team());
    return this.isLate() || this.drawing.refused || Boolean(first?.drawing.refused);
  }

  isLate() {                             // whether the newest change has waited long for its answer
    return this.pendingSince !== null && performance.now() - this.pendingSince > PENDING;
  }
}

// The arrow key of an event, as a direction. With another key it is the browser's: Alt goes back.
function wayOf({ key, ctrlKey, metaKey, altKey }) {
  return ctrlKey || metaKey || altKey ? undefined : WAYS[key];
}

function keepKeys(event) {               // the notebook must not handle the keys that a board uses
  if (!event.ctrlKey && !event.metaKey) event.stopPropagation();
}

// ---- one picture of a board

class View {
  constructor(board, el) {
    this.board = board;
    this.grabs = new Map();              // the thing dragged by each pointer or finger
    this.buttons = new Map();            // a button for each thing, by its name
    this.entered = null;                 // the polygon whose vertices have buttons
    this.paints = 0;
    this.widths = new Map();             // of texts in the picture
    this.build(el);
    this.listen();
    this.endTheme = followTheme((theme) => this.dress(theme), () => this.paint());
    this.endPixels = followPixels(() => this.request());
    this.word = null;                    // the colour that a word under the pointer names
    this.read = ({ type, target, relatedTarget }) => {
      this.light(type === "focusout" ? relatedTarget : target);
    };
    READING.forEach((kind) => document.addEventListener(kind, this.read));
    document.addEventListener("keydown", offerWords, true);
    this.resizing = new ResizeObserver(() => this.resize());
    this.resizing.observe(this.root);
    board.views.add(this);
    this.resize();
  }

  close() {
    this.resizing.disconnect();
    this.endTheme();
    this.endPixels();
    READING.forEach((kind) => document.removeEventListener(kind, this.read));
    [this.speaking, this.settling].forEach(clearTimeout);
    this.board.views.delete(this);
    if (!this.board.views.size) document.removeEventListener("keydown", offerWords, true);
  }

  dress(theme) {                         // take the colours of the page's theme
    const { board, root } = this;
    board.palette = board.themes[theme] ?? board.themes.light;
    root.dataset.theme = theme;
    root.style.setProperty("--kinoedu-focus", board.palette.ink);
    root.style.setProperty("--kinoedu-beside", board.palette.free);
    root.style.setProperty("--kinoedu-warning", board.palette.hit);
    root.style.setProperty("--kinoedu-done", board.palette.clear);
    this.laid = false;                   // the bitmap has the colours of before
    this.request();
  }

  emit(name, seq) {
    this.root.dispatchEvent(new CustomEvent(`kinoedu-${name}`, { detail: seq, bubbles: true }));
  }

  build(el) {
    const { words } = this.board;
    this.root = make("div", "kinoedu-board", el, { "data-lm-suppress-shortcuts": "true" });
    this.column = make("div", "kinoedu-column", this.root);
    this.stage = make("div", "kinoedu-stage", this.column);
    this.canvas = make("canvas", "kinoedu-canvas", this.stage, { role: "img" });
    const group = { role: "group", "aria-label": this.inLane(words.movable) };
    this.overlay = make("div", "kinoedu-overlay", this.stage, group);
    this.growth = make("div", "kinoedu-growth", this.column);
    this.button = make("button", "kinoedu-play", this.growth, { type: "button" });
    const range = { type: "range", min: 0, step: 1, "aria-label": words.slider };
    this.slider = make("input", "kinoedu-slider", this.growth, range);
    this.code = new Code(this);
    this.pointer = new Pointer(this);
    this.back = make("button", "kinoedu-reset", this.growth, { type: "button" });
    this.back.textContent = words.reset;
    this.copying = make("button", "kinoedu-copy", this.growth, { type: "button" });
    this.copying.textContent = words.copy;
    this.copying.hidden = !this.board.model.get("copies");
    this.driven = this.board.scene.handles.findIndex((handle) => handle.driven);
    const recorded = this.board.model.get("recorded");
    this.back.hidden = !this.board.things().length;   // nothing has moved
    if (this.driven >= 0 && !recorded) this.buildPad();
    this.text = make("div", "kinoedu-text", this.column, { "aria-hidden": "true" });
    this.goals = make("ul", "kinoedu-goals", this.column);
    const spoken = { role: "status", "aria-live": "polite" };
    this.state = make("div", "kinoedu-state", this.column, spoken);
    this.how = make("div", "kinoedu-hint", this.root);   // below the code, where there is some
    this.pen = this.canvas.getContext("2d");
  }

  hint() {                               // how to use this board
    const { words } = this.board, { handles, polygons, posed } = this.board.scene;
    const pointing = this.pointer.layers().length ? [words.pointing] : [];
    if (!this.board.things().length) return pointing.join(" ");
    const hints = [words.hint, ...pointing];
    if (polygons.some((polygon) => polygon.vertices)) hints.push(words.deeper);
    if (handles.some((handle) => handle.stop)) hints.push(words.stops);
    if (posed) hints.push(words.posed);
    if (this.driven >= 0) hints.push(words.driving);
    return hints.join(" ");
  }

  buildPad() {                           // a button for each arrow key, for touch screens
    const { board } = this, { words } = board;
    this.pad = make("div", "kinoedu-pad", this.growth, { role: "group", "aria-label": words.pad });
    for (const [key, sign] of Object.entries(SIGNS)) {
      const label = { type: "button", "data-key": key, "aria-label": words[key] };
      const button = make("button", "", this.pad, label);
      const press = () => board.hold(key, true), release = () => board.hold(key, false);
      button.textContent = sign;
      button.addEventListener("pointerdown", (event) => {
        button.setPointerCapture(event.pointerId);
        press();
      });
      button.addEventListener("lostpointercapture", release);   // also after each release
      button.addEventListener("contextmenu", (event) => event.preventDefault());  // of a long touch
      button.addEventListener("click", (event) => {
        if (event.detail !== 0) return;  // the pointer's; a click by a key has detail 0
        press();
        release();
      });
    }
    this.steered(this.pad);
  }

  steered(element) {                     // let arrow keys drive while the element has the focus
    const held = (down) => (event) => {
      if (!(down ? wayOf(event) : WAYS[event.key])) return;
      this.board.hold(event.key, down);
      event.preventDefault();
      if (down) event.stopPropagation();
    };
    element.addEventListener("keydown", held(true));
    element.addEventListener("keyup", held(false));
    element.addEventListener("focusout", () => this.board.release());
  }

  listen() {
    const { board, canvas } = this;
    canvas.addEventListener("pointerdown", (e) => this.grab(e));
    canvas.addEventListener("touchstart", (e) => {   // a finger that holds nothing scrolls
      if (this.grabs.size) e.preventDefault();
    }, { passive: false });
    canvas.addEventListener("pointermove", (e) => this.drag(e));
    canvas.addEventListener("pointerup", (e) => this.letGo(e));
    canvas.addEventListener("pointercancel", (e) => this.drop(e));
    canvas.addEventListener("lostpointercapture", (e) => this.drop(e));
    canvas.addEventListener("pointerleave", (e) => this.pointer.leave(e));
    this.root.addEventListener("keydown", keepKeys);
    this.button.addEventListener("click", () => board.play());
    this.back.addEventListener("click", () => board.reset());
    this.copying.addEventListener("click", () => {
      board.send({ kind: "code" });
    });
    this.slider.addEventListener("input", () => {
      board.playing = null;
      board.growTo(this.slider.valueAsNumber);
    });
  }

  // The controls above: the notebook must leave them their keys, and their sliders get the names of
  // their labels, since ipywidgets gives them none.
  prepareControls() {
    const frame = this.root.closest(".kinoedu-framed");
    if (!frame) return;
    frame.addEventListener("keydown", keepKeys);
    for (const slider of frame.querySelectorAll(".widget-hslider")) {
      const name = slider.querySelector(".widget-label").textContent;
      const parts = slider.querySelectorAll(".noUi-handle, .widget-readout");
      parts.forEach((part) => part.setAttribute("aria-label", name));
    }
  }

  // coordinates: the world's (x, y) with y up, and the picture's pixels with y down

  resize() {
    this.prepareControls();
    const { lo, hi } = this.board.scene;
    const [wide, high] = [hi[0] - lo[0], hi[1] - lo[1]];
    const room = Math.max(Math.min(this.column.clientWidth || WIDEST, WIDEST), 160) - 2 * PAD;
    this.fit = Math.min(room / wide, (HIGHEST - 2 * PAD) / high);
    this.width = Math.round(wide * this.fit + 2 * PAD);
    this.height = Math.round(high * this.fit + 2 * PAD);
    this.look();
    this.stage.style.width = `${this.width}px`;
    this.stage.style.height = `${this.height}px`;
    this.stage.style.aspectRatio = `${this.width} / ${this.height}`;   // for paper
    this.growth.style.maxWidth = `${Math.max(this.width, 320)}px`;
    this.request();
  }

  look() {                               // at the whole world, or where an eye looks at this step
    const { board, fit } = this, { lo, hi } = board.scene;
    const size = Math.max(hi[0] - lo[0], hi[1] - lo[1]);
    Object.assign(this, { scale: fit, unit: fit * size, left: PAD, bottom: this.height - PAD });
    const eye = board.drawing.layers.find((layer) => layer.kind === "eye");
    if (!eye) return;
    const { data } = eye;
    let [x, y, seen] = [0, 0, 1];
    for (let k = 0; k + 4 <= data.length && data[k + 3] <= board.step; k += 4) {
      [x, y, seen] = data.subarray(k, k + 3);
    }
    this.scale = fit / seen;
    this.unit = (fit * size) / seen;
    this.left = this.width / 2 - x * this.unit;
    this.bottom = this.height / 2 + y * this.unit;
  }

  toPixels([x, y]) {
    const { lo } = this.board.scene;
    return [this.left + (x - lo[0]) * this.scale, this.bottom - (y - lo[1]) * this.scale];
  }

  toWorld(event) {
    const { lo } = this.board.scene, [px, py] = this.onPicture(event);
    return [lo[0] + (px - this.left) / this.scale, lo[1] + (this.bottom - py) / this.scale];
  }

  onPicture(event) {
    const box = this.canvas.getBoundingClientRect(), { width, height } = this;
    const px = ((event.clientX - box.left) / box.width) * width;
    return [px, ((event.clientY - box.top) / box.height) * height];
  }

  // pointers

  // The thing nearest to a place, if it is within `reach` pixels. Ties go to the first one.
  nearest(things, at, reach) {
    const far = things.map((thing) => distance(this.board.place(thing), at) * this.scale);
    const best = far.indexOf(Math.min(...far));
    return far[best] <= reach ? things[best] : null;
  }

  handleAt(at, touch) {
    const handles = this.board.things().filter((thing) => thing.kind === "handle");
    return this.nearest(handles, at, touch ? 28 : 16);
  }

  stopAt(at, touch) {
    const stops = this.board.things().filter((thing) => this.board.item(thing).stop);
    return this.nearest(stops, at, touch ? 28 : 16);
  }

  vertexAt(at, touch) {
    const vertices = this.board.scene.polygons.flatMap((_, i) => this.board.vertices(i));
    return this.nearest(vertices, at, touch ? 18 : 12);
  }

  covers(thing, at) {                    // a small disc can be grabbed near its centre too
    const item = this.board.item(thing);
    if (thing.kind === "polygon") return inside(...at, item.rings);
    return thing.kind === "disc" && distance(item.at, at) <= Math.max(item.radius, 12 / this.scale);
  }

  under(at, touch) {                     // the thing at a place: a point near it, or what covers it
    const point = this.handleAt(at, touch) ?? this.vertexAt(at, touch);
    return point ?? this.board.things().findLast((thing) => this.covers(thing, at)) ?? null;
  }

  grab(event) {
    const { board } = this, anchor = this.toWorld(event);
    this.pointer.hover(event);
    const thing = this.under(anchor, event.pointerType === "touch");
    if (board.model.get("recorded") || event.button > 0 || (!thing && !board.scene.posed)) return;
    event.preventDefault();
    if (thing && board.item(thing).driven) { this.focus(thing); return; }
    this.canvas.setPointerCapture(event.pointerId);
    if (!thing) { this.pose(event, anchor); return; }
    const { clientX, clientY } = event, from = copy(board.shape(thing)), place = board.place(thing);
    // Points keep their distance from the pointer, so that they do not jump.
    const held = thing.kind === "polygon"
      ? { thing, from, anchor, offset: [0, 0] }
      : { thing, from, anchor: place, offset: place.map((x, k) => x - anchor[k]) };
    this.grabs.set(event.pointerId, { ...held, clientX, clientY, still: true });
    if (thing.kind === "vertex") this.enter(thing.i);
    this.focus(thing);
    this.stage.classList.add("kinoedu-held");    // its button stays where it is, without a ring
    this.request();
  }

  focus(thing) { this.buttons.get(nameOf(thing))?.focus({ preventScroll: true }); }

  pose(event, anchor) {                  // move a place to the pointer, and drag its tip
    const { board } = this, { clientX, clientY } = event;
    const place = { kind: "handle", i: event.shiftKey ? 0 : 2 };
    const tip = { kind: "handle", i: place.i + 1 };
    board.move(place, board.place(place), board.place(place), anchor);
    const held = { thing: tip, from: anchor, anchor, offset: [0, 0] };
    this.grabs.set(event.pointerId, { ...held, clientX, clientY, fresh: true });
    this.focus(place);
  }

  drag(event) {
    const held = this.grabs.get(event.pointerId), at = this.toWorld(event);
    if (!held) {
      this.canvas.style.cursor = this.under(at, false) ? "grab" : "";
      if (event.pointerType !== "touch") this.pointer.hover(event);
      return;
    }
    const moved = distanceOnPage(event, held);
    held.still &&= moved < JITTER && this.stopAt(at, false) !== null;
    held.fresh &&= moved < TURNS;
    if (held.still || held.fresh) return;
    this.canvas.style.cursor = "grabbing";
    this.board.move(held.thing, held.from, held.anchor, at.map((x, k) => x + held.offset[k]));
  }

  letGo(event) {                         // near a stop, or a click on one
    const held = this.grabs.get(event.pointerId);
    if (!held) return;
    const { board } = this, { thing, still } = held, item = board.item(thing);
    const at = still || !item.at ? this.toWorld(event) : item.at;
    const stop = this.stopAt(at, event.pointerType === "touch");
    const isHandle = thing.kind === "handle" && !item.stop;
    if (stop && still) board.call(event.shiftKey ? 0 : 1, board.item(stop));
    else if (stop && isHandle) board.call(thing.i, board.item(stop));      // released near the stop
    this.drop(event);
  }

  drop(event) {                          // end a drag; a browser may end one without a release
    if (!this.grabs.delete(event.pointerId)) return;
    this.stage.classList.toggle("kinoedu-held", this.grabs.size > 0);
    this.canvas.style.cursor = "";
    this.board.settle();
    this.placeButtons();
    this.request();
  }

  // keys: every thing has a button over it, visible only while it has the focus

  press(event, thing) {
    const { board } = this, way = wayOf(event);
    const opens = event.key === "Enter" && thing.kind === "polygon";
    if (way) {
      this.nudge(thing, way, event.shiftKey ? 0.05 : 0.01);
    } else if (event.key === "Enter" && board.item(thing).stop) {
      board.call(event.shiftKey ? 0 : 1, board.item(thing));
      board.settle();
    } else if (opens && board.vertices(thing.i).length) {
      this.enter(thing.i);
      this.buttons.get(nameOf(board.vertices(thing.i)[0])).focus();
    } else if (event.key === "Escape" && thing.kind === "vertex") {
      this.buttons.get(nameOf({ kind: "polygon", i: thing.i }))?.focus();
      this.enter(null);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  nudge(thing, way, share) {             // move a thing by a share of the world's size
    const { board } = this, { lo, hi } = board.scene, at = board.place(thing);
    const size = share * Math.max(hi[0] - lo[0], hi[1] - lo[1]);
    board.move(thing, copy(board.shape(thing)), at, at.map((x, k) => x + way[k] * size));
    clearTimeout(this.settling);
    this.settling = setTimeout(() => board.settle(), 300);
  }

  enter(i) { this.entered = i; this.placeButtons(); }

  placeButtons() {
    const { board } = this, wanted = new Map();
    for (const thing of board.things()) {
      wanted.set(nameOf(thing), thing);
      if (thing.kind !== "polygon" || thing.i !== this.entered) continue;
      board.vertices(thing.i).forEach((vertex) => wanted.set(nameOf(vertex), vertex));
    }
    if (!same([...wanted.keys()], [...this.buttons.keys()])) this.makeButtons(wanted);
    for (const [name, thing] of wanted) {
      const button = this.buttons.get(name), at = board.place(thing), [px, py] = this.toPixels(at);
      button.style.transform = `translate(${px - 14}px, ${py - 14}px)`;
      const label = this.label(thing, at);
      if (button.ariaLabel !== label) button.ariaLabel = label;
    }
  }

  makeButtons(wanted) {                  // in Tab order: a polygon's vertices follow it
    const before = this.buttons;
    const kept = ([name, thing]) => [name, before.get(name) ?? this.makeButton(name, thing)];
    this.buttons = new Map([...wanted].map(kept));
    before.forEach((button, name) => { if (!wanted.has(name)) button.remove(); });
    const { overlay } = this;
    [...this.buttons.values()].forEach((button, k) => {
      const present = overlay.children[k] ?? null;
      if (present !== button) overlay.insertBefore(button, present);
    });
  }

  makeButton(name, thing) {
    const button = make("button", "kinoedu-thing", null, { type: "button", "data-thing": name });
    if (this.board.item(thing).driven) this.steered(button);
    else button.addEventListener("keydown", (event) => this.press(event, thing));
    return button;
  }

  label(thing, [x, y]) {
    const { words, scene } = this.board, { name } = this.board.item(thing);
    const [xText, yText] = [x, y].map((value) => value.toFixed(scene.decimals));
    const values = { name, number: thing.v, x: xText, y: yText };
    return this.inLane(fill(words[this.role(thing)], values));
  }

  inLane(text) {                         // a spoken name; several boards may show the same things
    const lane = this.board.model.get("lane");
    return lane ? `${lane}: ${text}` : text;
  }

  role(thing) {                          // the key of the words that describe a thing
    const item = this.board.item(thing);
    if (thing.kind === "vertex") return "vertex";
    if (thing.kind === "polygon" && item.vertices) return "polygon";
    if (item.stop) return "stop";
    return item.driven ? "driven" : "handle";
  }

  // painting: at most once a frame. Where only the pointer has moved, the picture is a copy.

  request(onlyPointer = false) {
    this.onlyPointer = onlyPointer && (!this.frame || this.onlyPointer);
    this.frame ||= requestAnimationFrame(() => { this.frame = 0; this.paint(); });
  }

  paint() {
    const { board, pen, canvas, onlyPointer } = this;
    if (onlyPointer && this.copied) {
      pen.setTransform(1, 0, 0, 1, 0, 0);
      pen.drawImage(this.copied, 0, 0);
      pen.setTransform(canvas.width / this.width, 0, 0, canvas.height / this.height, 0, 0);
    } else {
      this.paintPicture();
      const { width, height } = canvas;
      this.copied = onlyPointer ? make("canvas", "", null, { width, height }) : null;
      this.copied?.getContext("2d").drawImage(canvas, 0, 0);
    }
    this.pointer.show();
    if (!this.grabs.size) this.placeButtons();   // moved during a drag, they cost a new layout
    this.showState(board.isLate());
    this.code.show();
    this.paints += 1;
    this.emit("painted", board.shown);
  }

  light(target) {                        // what a word names: <b class="ke-goal">goal</b>
    const name = target?.closest?.(NAMING)?.classList[0].slice(3).replaceAll("-", "_") ?? null;
    const { drawing, scene } = this.board;
    const coloured = [...drawing.layers, ...scene.handles, ...scene.polygons];
    const there = coloured.some(({ colour }) => colour === name);
    const solids = name === "obstacle" && solidOnes(scene).length + scene.discs.length > 0;
    const word = there || solids ? name : null;
    if (word === this.word) return;
    this.word = word;
    this.request();
  }

  strength(colour) { return this.word === null || this.word === colour ? 1 : DIM; }

  paintPicture() {
    const { board, pen, canvas } = this, ratio = window.devicePixelRatio || 1;
    const [across, down] = [this.width, this.height].map((size) => Math.round(size * ratio));
    if (canvas.width !== across) canvas.width = across;
    if (canvas.height !== down) canvas.height = down;
    pen.setTransform(across / this.width, 0, 0, down / this.height, 0, 0);
    pen.lineJoin = pen.lineCap = "round";
    if (!this.grabs.size) {              // the view and the names' sides stay during a drag
      this.look();
      this.chooseSides();
    }
    const { brief, total } = board.drawing, pale = board.isPale();
    const complete = brief || board.step >= total;
    const layers = board.drawing.layers.filter((layer) => complete || !layer.last);
    const paint = (wanted, by = (layer) => this[`paint_${layer.kind}`]?.(layer)) => {
      wanted.forEach((layer) => {
        pen.globalAlpha = (pale ? 0.35 : 1) * this.strength(layer.colour);
        by(layer);
      });
      pen.globalAlpha = 1;
    };
    this.taken = this.namedHandles().map((handle) => this.nameBox(handle));
    this.paintGround();
    paint(layers.filter((layer) => layer.kind === "cells"));
    pen.globalAlpha = this.strength("obstacle");
    this.paintSolids();
    paint(layers.filter(({ kind }) => kind !== "cells" && kind !== "labels"));
    const texts = layers.filter((layer) => layer.kind === "labels");
    texts.forEach((layer) => this.eachRow(layer, 2, (px, py) => {     // no text covers their points
      this.taken.push([px - 6, py - 6, px + 6, py + 6]);
    }));
    paint(texts);
    this.namedHandles().forEach((handle) => {
      pen.globalAlpha = this.strength(handle.colour);
      this.paintHandle(handle);
    });
    const ringed = layers.filter(({ kind, casing }) => kind === "dots" && casing);
    paint(ringed, (layer) => this.paintRings(layer));
  }

  // A ring in the colour of each dot that a handle hides, such as q_near where it is the start.
  paintRings(layer) {
    const { pen } = this, spots = this.namedHandles().map(({ at }) => this.toPixels(at));
    pen.beginPath();
    this.eachRow(layer, 2, (px, py) => {
      if (!spots.some(([x, y]) => Math.hypot(x - px, y - py) < 6)) return;
      pen.moveTo(px + RING, py);
      pen.arc(px, py, RING, 0, 7);
    });
    this.stroke({ ...layer, width: 3 });
  }

  paintGround() {
    const { pen, board } = this, { scene, palette } = board;
    if (!this.laid) this.bitmap = this.bitmapPicture();
    this.laid = true;
    const shaped = scene.boundary || (this.bitmap && !scene.glued);
    pen.fillStyle = shaped ? palette.outside : palette.free;
    pen.fillRect(0, 0, this.width, this.height);
    if (this.bitmap) this.paintBitmap();
    pen.lineWidth = 1.5;
    pen.strokeStyle = palette.obstacle;
    if (!scene.boundary) return;
    this.trace([scene.boundary]);
    pen.fillStyle = palette.free;
    pen.fill();
    pen.stroke();
  }

  paintSolids() {
    const { pen } = this, { scene, palette } = this.board;
    const polygons = scene.polygons.filter((polygon) => !polygon.drawn);
    for (const { rings, colour } of polygons) {
      this.trace(rings);
      pen.fillStyle = palette[colour ?? "obstacle"];
      pen.fill("evenodd");
      if (colour) pen.stroke();
    }
    pen.fillStyle = palette.obstacle;
    for (const { at, radius } of scene.discs) {
      pen.beginPath();
      pen.arc(...this.toPixels(at), radius * this.scale, 0, 7);
      pen.fill();
    }
    for (const { rings, vertices } of polygons) {
      if (vertices) rings.flat().forEach((p) => this.dot(p, 4, palette.free, palette.obstacle));
    }
  }

  trace(rings) {
    this.pen.beginPath();
    for (const ring of rings) {
      ring.forEach((p, k) => this.pen[k ? "lineTo" : "moveTo"](...this.toPixels(p)));
      this.pen.closePath();
    }
  }

  // A bitmap has one bit for each cell, or with own colours one byte; the lowest row is first.
  bitmapPicture() {
    const { model, palette } = this.board, { size, colours } = this.board.scene;
    const view = model.get("bitmap");
    if (!size || !view || !view.byteLength) return null;
    const [rows, columns] = size;
    const bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
    const bit = (cell) => (bytes[cell >> 3] >> (7 - (cell & 7))) & 1;
    const number = this.numberAt = colours ? (cell) => bytes[cell] : bit;
    const names = colours ?? ["obstacle", "free"];
    const shades = Uint32Array.from(names, (name) => pixelOf(palette[name]));
    const picture = make("canvas", "", null, { width: columns, height: rows });
    const pen = picture.getContext("2d");
    const image = pen.createImageData(columns, rows), pixels = new Uint32Array(image.data.buffer);
    for (let row = 0, cell = 0; row < rows; row += 1) {
      for (let at = (rows - 1 - row) * columns, end = at + columns; at < end; at += 1, cell += 1) {
        pixels[at] = shades[number(cell)];
      }
    }
    pen.putImageData(image, 0, 0);
    return picture;
  }

  paintBitmap() {
    const { lo, hi } = this.board.scene.glued ?? this.board.scene;
    const [x0, y1] = this.toPixels(lo), [x1, y0] = this.toPixels(hi);
    // Smooth only when the bitmap is made smaller, so that cells stay sharp.
    this.pen.imageSmoothingEnabled = (x1 - x0) * (window.devicePixelRatio || 1) < this.bitmap.width;
    this.pen.drawImage(this.bitmap, x0, y0, x1 - x0, y1 - y0);
  }

  namedHandles() {                       // those that the answer does not draw
    return this.board.scene.handles.filter(({ stop, drawn }) => !stop && !drawn);
  }

  paintHandle(handle) {
    const { name, at, colour, marker, radius } = handle;
    const { pen } = this, { palette } = this.board;
    const [px, py] = this.toPixels(at), paint = palette[colour];
    if (radius) {
      pen.globalAlpha *= TINT;
      pen.fillStyle = paint;
      pen.beginPath();
      pen.arc(px, py, radius * this.scale, 0, 7);
      pen.fill();
      pen.globalAlpha /= TINT;
    }
    if (marker === "star") this.star(px, py, 12, paint); else this.dot(at, 7, paint, palette.free);
    const [x, y, align] = this.nameSpot(handle);
    this.write(name, x, y, paint, align, "bold");
  }

  // The names of handles stand on the first side where they cover no line, no arrow and no other
  // name; or else none of these but lines that are not the path; or else where most room is.
  chooseSides() {
    const { layers } = this.board.drawing, names = [];
    const all = this.passedSegments(layers);
    const ways = this.passedSegments(layers.filter(({ colour }) => colour === "path"));
    this.sides = new Map();
    for (const handle of this.namedHandles()) {
      const sides = this.sidesOf(handle);
      const first = (passed) => sides.find((side) => {
        const box = this.nameBox(handle, side);
        const inside = box[0] > 0 && box[1] > 0 && box[2] < this.width && box[3] < this.height;
        return inside && !passed.some((segment) => passes(segment, box))
          && !names.some((other) => overlap(other, box));
      });
      this.sides.set(handle.name, first(all) ?? first(ways) ?? sides[0]);
      names.push(this.nameBox(handle));
    }
  }

  passedSegments(layers) {               // of paths and of arrows, in pixels
    const { left, bottom } = this, segments = [];
    for (const layer of layers) {
      const { kind, colour } = layer;
      if (kind === "edges" ? colour !== "path" : kind !== "path" && kind !== "arrows") continue;
      let before = null;
      this.eachRow(layer, kind === "path" ? 2 : 4, (px, py, x, y) => {
        if (kind === "arrows") segments.push([px, py, px + x, py - y]);
        else if (kind === "edges") segments.push([px, py, left + x, bottom - y]);
        else if (before) segments.push([...before, px, py]);
        before = [px, py];
      });
    }
    return segments;
  }

  sidesOf({ at }) {                      // right 1 or left -1, above 1 or below -1; most room first
    const { lo, hi, handles } = this.board.scene;
    const right = at[0] < lo[0] + 0.75 * (hi[0] - lo[0]) ? 1 : -1;
    if (handles.some(({ stop }) => stop)) return [[right, -1], [-right, -1]];   // stops are above
    const up = at[1] < lo[1] + 0.85 * (hi[1] - lo[1]) ? 1 : -1;
    return [[right, up], [right, -up], [-right, up], [-right, -up]];
  }

  nameSpot(handle, side = this.sides.get(handle.name)) {   // where a name is written, and how
    const [px, py] = this.toPixels(handle.at), [right, up] = side ?? this.sidesOf(handle)[0];
    return [px + 11 * right, py - 15 * up, right > 0 ? "left" : "right"];
  }

  nameBox(handle, side) { return this.boxOf(handle.name, ...this.nameSpot(handle, side), "bold"); }

  boxOf(text, x, y, align, weight = "normal") {  // the box of a text that is written
    const wide = this.widthOf(text, weight), left = align === "left" ? x : x - wide;
    return [left, y - 8, left + wide, y + 8];
  }

  widthOf(text, weight) {                // measured once: the spots of a label have one width
    const key = `${weight} ${text}`;
    if (!this.widths.has(key)) {
      if (this.widths.size >= TEXTS) this.widths.clear();
      this.pen.font = `${weight} 14px system-ui, sans-serif`;
      this.widths.set(key, this.pen.measureText(text).width);
    }
    return this.widths.get(key);
  }

  dot(at, size, inner, rim) {
    const { pen } = this;
    pen.beginPath();
    pen.arc(...this.toPixels(at), size, 0, 7);
    Object.assign(pen, { fillStyle: inner, strokeStyle: rim, lineWidth: 1.5 });
    pen.fill();
    pen.stroke();
  }

  star(px, py, size, colour) {
    const { pen } = this;
    pen.beginPath();
    for (let k = 0; k < 10; k += 1) {
      const r = k % 2 ? size * 0.42 : size, angle = (k * Math.PI) / 5;
      pen.lineTo(px + r * Math.sin(angle), py - r * Math.cos(angle));
    }
    pen.closePath();
    Object.assign(pen, { fillStyle: colour, strokeStyle: this.board.palette.free, lineWidth: 1.5 });
    pen.stroke();
    pen.fill();
  }

  write(text, px, py, colour, align, weight = "normal") {
    const { pen } = this;
    pen.font = `${weight} 14px system-ui, sans-serif`;
    Object.assign(pen, { textAlign: align, textBaseline: "middle" });
    Object.assign(pen, { strokeStyle: this.board.palette.free, lineWidth: 4, fillStyle: colour });
    pen.strokeText(text, px, py);
    pen.fillText(text, px, py);
  }

  // layers: coordinates are multiples of the world's size, from its lower left corner. In a layer
  // that grows each row ends with the step at which it appears, and where rows do not stay, also
  // with the step at which it disappears. Before these are its notes.

  stride({ grows, ends, names = [] }, size) {
    return size + names.length + (grows ? 1 : 0) + (ends ? 1 : 0);
  }

  eachRow(layer, size, visit) {
    const { unit, left, bottom } = this, { step } = this.board, { data, grows, ends } = layer;
    const stride = this.stride(layer, size), when = size + (layer.names ?? []).length;
    for (let k = 0; k + stride <= data.length; k += stride) {
      if (grows && data[k + when] > step) break;
      if (ends && data[k + stride - 1] <= step) continue;
      const [px, py] = [left + data[k] * unit, bottom - data[k + 1] * unit];
      visit(px, py, data[k + 2] * unit, data[k + 3] * unit, k / stride);
    }
  }

  stroke({ colour, width, dash }) {
    const { pen } = this;
    Object.assign(pen, { strokeStyle: this.board.palette[colour], lineWidth: width });
    pen.setLineDash(dash);
    pen.stroke();
    pen.setLineDash([]);
  }

  paint_edges(layer) {
    const { pen, left, bottom } = this, { data, width, dash } = layer;
    // lines of one pixel, and without round ends, are painted in a tenth of the time
    const fine = width < FINE && data.length > MANY * this.stride(layer, 4);
    const style = fine ? { ...layer, width: Math.min(width, 1) } : layer;
    let segments = 0, endX = NaN, endY = NaN;  // dashes go on from one segment to the next
    pen.lineCap = fine || dash.length ? "butt" : "round";
    pen.beginPath();
    this.eachRow(layer, 4, (px, py, x, y) => {
      if (!dash.length || px !== endX || py !== endY) pen.moveTo(px, py);
      endX = left + x;
      endY = bottom - y;
      pen.lineTo(endX, endY);
      segments += 1;
      if (segments % BATCH) return;
      this.stroke(style);
      pen.beginPath();
      endX = NaN;
    });
    this.stroke(style);
    pen.lineCap = "round";
  }

  outline(layer) {                       // trace the polygon of each row
    const { pen, unit, left, bottom } = this, { data } = layer;
    const size = 2 * layer.points, stride = this.stride(layer, size);
    pen.beginPath();
    this.eachRow(layer, size, (_px, _py, _dx, _dy, k) => {
      for (let c = k * stride; c < k * stride + size; c += 2) {
        const at = [left + data[c] * unit, bottom - data[c + 1] * unit];
        pen[c > k * stride ? "lineTo" : "moveTo"](...at);
      }
      pen.closePath();
    });
  }

  paint_cells(layer) {
    this.outline(layer);
    this.pen.fillStyle = this.board.palette[layer.colour];
    this.pen.fill();
  }

  hatch() {                              // trace stripes over the whole picture
    const { pen, width, height } = this;
    for (let x = -height; x < width; x += STRIPES) {
      pen.moveTo(x, height);
      pen.lineTo(x + height, 0);
    }
  }

  paint_bodies(layer) {
    const { pen } = this;
    pen.save();
    this.outline(layer);
    pen.fillStyle = this.board.palette[layer.colour];
    pen.globalAlpha *= TINT;
    pen.fill();
    pen.globalAlpha /= TINT;
    pen.clip();
    pen.beginPath();
    if (layer.hatched) this.hatch();
    this.stroke(layer);
    pen.restore();
    this.outline(layer);
    this.stroke(layer);
  }

  paint_path(layer) {
    const { pen } = this;
    pen.beginPath();
    this.eachRow(layer, 2, (px, py) => pen.lineTo(px, py));
    if (layer.casing) this.stroke({ ...layer, colour: "ink", width: layer.width + 2, dash: [] });
    this.stroke(layer);
  }

  paint_dots(layer) {
    const { pen } = this;
    pen.beginPath();
    this.eachRow(layer, 2, (px, py) => { pen.moveTo(px, py); pen.arc(px, py, layer.width, 0, 7); });
    pen.fillStyle = this.board.palette[layer.colour];
    pen.fill();
  }

  paint_arrows(layer) {
    const { pen } = this;
    pen.beginPath();
    this.eachRow(layer, 4, (px, py, dx, dy) => {
      const ex = px + dx, ey = py - dy, angle = Math.atan2(ey - py, ex - px);
      pen.moveTo(px, py);
      pen.lineTo(ex, ey);
      for (const turn of [2.6, -2.6]) {
        pen.moveTo(ex, ey);
        pen.lineTo(ex + 12 * Math.cos(angle + turn), ey + 12 * Math.sin(angle + turn));
      }
    });
    this.stroke(layer);
  }

  // Each at its first spot, if no other text is there; or else at a free one to which no other
  // point is nearer than its own, if there is one.
  paint_labels(layer) {
    const points = [];
    this.eachRow(layer, 2, (px, py) => points.push([px, py]));
    this.eachRow(layer, 2, (px, py, _dx, _dy, k) => {
      const text = layer.texts[k], colour = this.board.palette[layer.colour];
      const spots = SPOTS.map(([dx, dy]) => {
        const align = dx > 0 ? "left" : "right";
        const [x, y] = [px + dx, clamp(py + dy, 12, this.height - 12)];
        return { x, y, align, box: this.boxOf(text, x, y, align) };
      });
      const inside = spots.filter(({ box }) => box[0] > 3 && box[2] < this.width - 3);
      const free = inside.filter(({ box }) => !this.taken.some((other) => overlap(box, other)));
      const best = free.find((spot) => spot === spots[0] || points.every((point) =>
        apart(spot.box, point) >= apart(spot.box, [px, py])));
      const { x, y, align, box } = best ?? free[0] ?? inside[0] ?? spots[0];
      this.taken.push(box);
      this.write(text, x, y, colour, align);
    });
  }

  // the text below the picture

  showState(late) {
    const { board } = this, { warning, brief, refused } = board.drawing;
    write(this.text, board.text());
    this.text.classList.toggle("kinoedu-warning", Boolean(warning) && !late);
    if (!brief || refused) this.showGrowth();
    if (!brief) write(this.how, this.hint());
    this.storeState();
    const won = this.showGoals();
    this.speakLater([this.text.textContent, ...won].join(" "));
  }

  showGrowth() {
    const { board, slider } = this, { drawing, words, step } = board, { total, unit } = drawing;
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    // a brief drawing cannot be scrubbed, and where a refused scene follows it stays brief
    this.growth.classList.toggle("kinoedu-nothing", total === 0 || drawing.brief);
    Object.assign(slider, { max: total, value: step });
    slider.ariaValueText = fill(words.growth, { shown: step, total, unit });
    write(this.button, board.playing ? words.pause : still ? words.next : words.play);
  }

  showGoals() {                          // the challenges; returns the answers to those reached now
    const { board, goals } = this, { words, drawing } = board, { challenges = [] } = drawing;
    if (same(challenges, this.shownGoals ?? null)) return this.won;
    this.shownGoals = challenges;
    const recorded = board.model.get("recorded");
    goals.replaceChildren(...challenges.map(({ sentence, now, done, text }) => {
      const item = make("li", now ? "kinoedu-goal-now" : "", null, { "data-done": done });
      make("b", "", item).textContent = `${done ? "★" : "☆"} ${words.challenge}: `;
      item.append(sentence);
      const state = now ? `${words.reached} ` : done ? `${words.done} ` : "";
      if (!recorded) make("div", "kinoedu-goal-text", item).textContent = state + text;
      return item;
    }));
    this.won = challenges.filter(({ now }) => now).map(({ text }) => `${words.reached} ${text}`);
    return this.won;
  }

  storeState() {                         // the data- attributes of the board, for tests
    const { drawing, shown: seq, seq: newest, answers, stale, step, bitmaps } = this.board;
    const layers = drawing.layers.map((layer) => layer.kind).join(" ");
    const { total, warning, refused } = drawing, { paints } = this, word = this.word ?? "";
    const state = { seq, newest, answers, stale, step, layers, bitmaps };
    Object.assign(state, { total, paints, warning, refused, word });
    for (const [name, value] of Object.entries(state)) {
      if (this.root.dataset[name] !== String(value)) this.root.dataset[name] = value;
    }
  }

  speakLater(text) {                     // read a text out once it has not changed for a while
    if (text === this.last) return;
    this.last = text;
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => {
      // what is pointed at by keys is spoken in the same place
      if (document.activeElement !== this.pointer.button) this.state.textContent = text;
      this.canvas.ariaLabel = text;
    }, QUIET);
  }
}

// ---- what is under the pointer, or chosen by keys

class Pointer {
  constructor(view) {
    const { words } = view.board;
    this.view = view;
    this.at = null;                      // the place on the picture that is pointed at
    this.near = NEAR;                    // pixels
    this.tip = make("div", "kinoedu-tip", view.stage, { "aria-hidden": "true" });
    const over = make("div", "kinoedu-overlay", view.stage);
    this.button = make("button", "kinoedu-pointer", over, { type: "button" });
    this.button.ariaLabel = words.pointer;
    this.button.addEventListener("keydown", (event) => this.press(event));
    this.button.addEventListener("focus", () => this.choose(this.targets()[0]));
    this.button.addEventListener("blur", () => this.point(null));
  }

  layers() {                             // those whose rows say something now
    const { drawing, step } = this.view.board;
    return drawing.layers.filter(({ says, last }) => says && (!last || step >= drawing.total));
  }

  point(at, near = NEAR) {
    if (at === this.at) return;
    Object.assign(this, { at, near });
    this.view.request(true);
  }

  hover(event) {
    this.point(this.view.onPicture(event), event.pointerType === "touch" ? NEAR_FINGER : NEAR);
  }

  leave(event) { if (event.pointerType !== "touch") this.point(null); }

  eachRow(layer, visit) {
    this.view.eachRow(layer, 2 * layer.points, (px, py, dx, dy, row) => visit(row, px, py, dx, dy));
  }

  // A row of a layer: its corners on the picture and its notes. A node is at the end of its edge.
  target(layer, row) {
    const { left, bottom, unit } = this.view, { names, data, points } = layer, shape = [];
    const size = 2 * points, from = row * this.view.stride(layer, size);
    for (let k = from; k < from + size; k += 2) {
      shape.push([left + data[k] * unit, bottom - data[k + 1] * unit]);
    }
    const noted = names.map((name, k) => [name, data[from + size + k]]);
    return { layer, shape, values: Object.fromEntries(noted) };
  }

  targets() {                            // all that are there now
    const found = [];
    this.layers().forEach((layer) => {
      this.eachRow(layer, (row) => found.push(this.target(layer, row)));
    });
    return found;
  }

  nodeRows(layer) {                      // the rows of a tree's nodes that are there now
    const size = 2 * layer.points, at = size + layer.names.indexOf("node"), found = new Map();
    const stride = this.view.stride(layer, size);
    this.eachRow(layer, (row) => found.set(layer.data[row * stride + at], row));
    return found;
  }

  isNode({ layer, values }) { return layer.points === 1 || "parent" in values; }

  place(target) {                        // a point in the middle of a target
    const { shape } = target, end = shape.at(-1);
    if (this.isNode(target)) return end;
    return [0, 1].map((k) => shape.reduce((sum, p) => sum + p[k], 0) / shape.length);
  }

  // How far rows of a layer are from a place, to be asked for each; points go before lines.
  far(layer, at) {
    const { left, bottom, unit } = this.view, { kind, points, width } = layer;
    const easier = kind === "nodes" ? Math.min(1, NEAR / (width * unit)) : 1;
    if (points === 1) return (_row, px, py) => easier * Math.hypot(px - at[0], py - at[1]);
    if (points > 2) {
      return (row) => (inside(...at, [this.target(layer, row).shape]) ? NEAR - 1 : Infinity);
    }
    return (_row, px, py, x, y) => {
      const end = [left + x, bottom - y];
      return Math.min(distance(end, at), 3 + distanceToSegment(at, [px, py], end));
    };
  }

  nearest(at, near) {                    // the target nearest to a place; the later one on top
    let [least, best] = [near, null];
    for (const layer of this.layers()) {
      const far = this.far(layer, at);
      this.eachRow(layer, (row, ...where) => {
        const away = far(row, ...where);
        if (away <= least) [least, best] = [away, [layer, row]];
      });
    }
    return best && this.target(...best);
  }

  // What is pointed at. It is kept, because it is asked for at each painting.
  found() {
    const { board } = this.view, { answers, step } = board, { scale, left } = this.view;
    const key = [this.at, answers, step, scale, left, this.near].join();
    if (this.at && key !== this.key) {
      this.meant = this.nearest(this.at, this.near);
      this.lit = this.meant && this.branch(this.meant);
      this.key = key;
    }
    return this.at && !this.view.grabs.size ? this.meant : null;
  }

  // What is lit: of a node the branch to its root, of others the outline.
  branch(target) {
    const { layer, shape, values } = target;
    if (!("parent" in values)) return shape.length > 2 ? [...shape, shape[0]] : shape;
    const rows = this.nodeRows(layer), line = [...shape].reverse();
    let edges = layer.points - 1;
    for (let above = values.parent; rows.has(above); edges += 1) {
      const parent = this.target(layer, rows.get(above));
      line.push(parent.shape[0]);
      above = parent.values.parent;
    }
    target.depth = edges;
    return line.reverse();
  }

  text({ layer, values, shape, depth }) {
    const { view } = this, { words } = view.board, { which = 0, ...others } = values;
    const numbers = Object.entries(others).map(([name, x]) => [name, short(x)]);
    const length = short(lengthOf(this.lit) / view.scale, 3);
    const says = layer.says[which];
    const why = says.includes("{why}") ? this.reason(...shape, words) : "";
    return fill(says, { ...Object.fromEntries(numbers), depth, length, why });
  }

  // What a motion meets first: the browser has the obstacles, so no reason is sent.
  reason(a, b, words) {
    const { scene } = this.view.board, { scale } = this.view, { discs, boundary } = scene;
    const wide = Math.max(0, ...scene.handles.map(({ radius }) => radius ?? 0)) * scale;
    const pixels = (ring) => ring.map((p) => this.view.toPixels(p));
    const solids = solidOnes(scene).map(({ name, rings }) => ({ name, rings: rings.map(pixels) }));
    const touches = (p, rings) => inside(...p, rings) || rings.some((ring) => ring.some((q, k) => (
      distanceToSegment(p, q, ring[(k + 1) % ring.length]) <= Math.max(wide, 1))));
    for (let k = 0; k <= ALONG; k += 1) {
      const p = [0, 1].map((axis) => a[axis] + (k / ALONG) * (b[axis] - a[axis]));
      const solid = solids.find(({ rings }) => touches(p, rings));
      const disc = discs.find(({ at, radius }) => (
        distance(this.view.toPixels(at), p) <= radius * scale + wide));
      if (solid ?? disc) return fill(words.meets, solid ?? disc);
      if (boundary && !inside(...p, [pixels(boundary)])) return words.outside;
      if (this.view.bitmap && this.shade(p) === 0) return words.cell;
    }
    return words.unknown;
  }

  shade(p) {                             // the number of the bitmap's cell at a place, or null
    const { view } = this, { scene } = view.board, { lo, hi } = scene.glued ?? scene;
    const [x0, y0] = view.toPixels([lo[0], hi[1]]), [x1, y1] = view.toPixels([hi[0], lo[1]]);
    const [rows, columns] = scene.size;
    const i = Math.floor(((y1 - p[1]) / (y1 - y0)) * rows);
    const j = Math.floor(((p[0] - x0) / (x1 - x0)) * columns);
    return i < 0 || j < 0 || i >= rows || j >= columns ? null : view.numberAt(i * columns + j);
  }

  // The meaning of the bitmap's cell under the pointer.
  meaning() {
    const { board, bitmap, left, bottom, scale } = this.view, { scene, words } = board;
    if (!this.at || !scene.meanings || !bitmap || this.view.grabs.size) return "";
    const meaning = scene.meanings[this.shade(this.at)];
    const [px, py] = this.at, { lo, decimals } = scene;
    const x = (lo[0] + (px - left) / scale).toFixed(Math.min(decimals, 2));
    const y = (lo[1] + (bottom - py) / scale).toFixed(Math.min(decimals, 2));
    return meaning ? fill(words.here, { x, y, meaning }) : "";
  }

  show() {                               // light what is pointed at, and say what it is
    const { view } = this, target = this.found();
    if (target) this.light(target);
    const text = target ? this.text(target) : this.meaning();
    if (!view.board.drawing.brief) this.button.hidden = !this.layers().length;
    view.root.dataset.pointed = text;
    if (this.tip.hidden !== !text) this.tip.hidden = !text;
    if (this.tip.textContent !== text) this.tip.textContent = text;
    if (document.activeElement === this.button && text !== this.said) {
      view.state.textContent = this.said = text;
    }
    const [px, py] = target ? this.place(target) : this.at ?? [0, 0];
    this.button.style.transform = `translate(${px - 14}px, ${py - 14}px)`;
    if (!text) return;
    const { offsetWidth: wide, offsetHeight: high } = this.tip;
    const x = clamp(px + 14, 2, Math.max(view.width - wide - 2, 2));
    const y = py - high - 12 > 0 ? py - high - 12 : py + 14;
    this.tip.style.transform = `translate(${x}px, ${y}px)`;
  }

  light(target) {
    const { view } = this, { pen } = view, end = this.place(target);
    for (const [colour, width] of [["ink", 6.5], ["free", 2.5]]) {
      pen.beginPath();
      this.lit.forEach((p) => pen.lineTo(...p));
      view.stroke({ colour, width, dash: [] });
    }
    if (!this.isNode(target)) return;
    const { ink, free } = view.board.palette;
    pen.beginPath();
    pen.arc(...end, 6, 0, 7);
    Object.assign(pen, { fillStyle: free, strokeStyle: ink, lineWidth: 2.5 });
    pen.fill();
    pen.stroke();
  }

  // keys: from target to target, and to the parent

  choose(target) { if (target) this.point(this.place(target), NEAR); }

  press(event) {
    const way = wayOf(event), here = this.found();
    if (way) this.choose(this.next(way));
    else if (event.key === "Enter") this.choose(this.parentOf(here));
    else if (event.key === "Escape") this.button.blur();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // The nearest target in a direction; what lies aside counts as farther away.
  next([x, y]) {
    const [px, py] = this.at ?? [0, 0];
    const cost = (target) => {
      const [tx, ty] = this.place(target), along = (tx - px) * x - (ty - py) * y;
      const aside = Math.abs((tx - px) * y) + Math.abs((ty - py) * x);
      return along > 0.5 && along >= aside * 0.5 ? along + 2 * aside : Infinity;
    };
    const targets = this.targets(), costs = targets.map(cost);
    const least = costs.reduce((a, b) => Math.min(a, b), Infinity);
    return least < Infinity ? targets[costs.indexOf(least)] : null;
  }

  parentOf(target) {
    if (!target || !("parent" in target.values)) return null;
    const row = this.nodeRows(target.layer).get(target.values.parent);
    return row === undefined ? null : this.target(target.layer, row);
  }
}

// ---- the code beside a picture

class Code {
  constructor(view) {
    const { words } = view.board;
    this.view = view;
    this.shown = null;                   // the listing whose lines are on the page
    this.back = this.stepper("◀", words.lineBack, -1);
    this.on = this.stepper("▶", words.lineOn, 1);
    const group = { role: "group", "aria-label": words.code };
    this.panel = make("div", "kinoedu-code", view.root, group);
    this.lines = make("div", "kinoedu-lines", this.panel);
    this.table = make("table", "kinoedu-values", this.panel);
    this.hint = make("div", "kinoedu-hint", this.panel);
  }

  stepper(sign, label, by) {             // a button that goes some steps on
    const { board, growth } = this.view;
    const button = make("button", "kinoedu-step", growth, { type: "button", "aria-label": label });
    button.textContent = sign;
    button.title = label;
    button.addEventListener("click", () => {
      board.playing = null;
      board.growTo(board.step + by);
    });
    return button;
  }

  show() {
    const { board, root } = this.view, { listing, total } = board.drawing;
    root.classList.toggle("kinoedu-coded", Boolean(listing));
    if (!listing) return;
    this.panel.classList.toggle("kinoedu-past", board.drawing.brief);
    if (board.drawing.brief) return;
    if (!same(listing.lines, this.shown?.lines)) this.write(listing);
    this.shown = listing;
    const ran = new Set(listing.ran), now = board.line();
    [...this.lines.children].forEach((line, k) => {
      line.classList.toggle("kinoedu-lit", k === now);
      line.disabled = !ran.has(k);
      if (k === now) line.ariaCurrent = "step"; else line.ariaCurrent = null;
    });
    write(this.hint, [board.words.coded, listing.legend].filter(Boolean).join(" "));
    this.back.disabled = board.step <= 0;
    this.on.disabled = board.step >= total;
    this.list(listing);
  }

  write({ lines }) {                     // each line is a button that goes to its next run
    const { board } = this.view;
    this.lines.replaceChildren(...lines.map((text, k) => {
      const line = make("button", "kinoedu-line", null, { type: "button", "data-line": k });
      line.textContent = text.trimStart() || " ";   // a line may not break after its indent
      line.style.setProperty("--kinoedu-indent", text.search(/\S|$/));
      line.addEventListener("click", () => board.goToLine(k));
      return line;
    }));
  }

  list({ colours }) {
    const { board } = this.view, { values, changed, old } = board.variables();
    const rank = ([name]) =>               // then what the picture shows
      (name === board.words.condition ? 0 : colours[name] ? 1 : 2);
    const rows = [...values].sort((one, other) => rank(one) - rank(other));
    this.table.replaceChildren(...rows.map(([name, text]) => {
      const row = make("tr", changed.includes(name) ? "kinoedu-changed" : "", null);
      const head = make("th", "", row, { scope: "row" });
      head.textContent = name;
      if (colours[name]) head.style.setProperty("--kinoedu-own", board.palette[colours[name]]);
      const value = make("td", "", row);
      value.textContent = text;
      if (old.includes(name)) {
        row.classList.add("kinoedu-old");
        make("span", "", value).textContent = ` ${board.words.old}`;
      }
      return row;
    }));
  }
}
