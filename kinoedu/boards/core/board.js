// The live board of kinoedu, in plain JavaScript: no build step, no downloads.
//
// The browser knows a *scene*: the things on the board, and which of them can be dragged. It sends
// each change to Python, which answers with a *drawing*: layers of lines, dots, arrows and texts,
// and a text below the picture. Only Python knows what they mean.
//
//   Board   shared by all views of one widget: the scene, its changes, the answers, the growth shown
//   View    one picture of it on a page: painting, pointers and keys
//
// A *stop* is a handle that the answer draws. A click on it moves the second handle (the goal)
// there, Shift and click the first.
//
// A *drawn* item is painted only by the answer, which may move it: an arm's tip stays within reach,
// wherever it is pulled.
//
// A *driven* item is moved only by Python, while arrow keys are held: see `hold`. In a *posed* scene
// the handles are pairs of a place and its tip, the point that it looks at. A press on the ground
// moves the second place there, with Shift the first, and its tip is dragged.
//
// A *thing* can be moved: {kind: "handle" | "disc" | "polygon", i}, or {kind: "vertex", i, r, v} for
// vertex v of ring r.

const IN_FLIGHT = 3;          // questions open at once, to hide the delay of a round trip
const SLOW = 100;             // ms: after a slower answer only one question is open at a time
const VERY_SLOW = 1000;       // ms: after a slower answer nothing is asked until the thing is released or rests
const REST = 300;             // ms: a thing rests that was not moved for so long
const PENDING = 250;          // ms after which an outdated answer is shown pale
const QUIET = 600;            // ms without change before the text is read out
const GROWTH = 4000;          // ms to play the whole growth
const TICK = 40;              // ms between two messages while keys are held
const JITTER = 4;             // pixels: a pointer that moved less has clicked
const TURNS = 12;             // pixels: a pointer that moved less has not pulled the tip of a new pose
const TINT = 0.35, STRIPES = 9;   // the opacity of a body; the distance of its stripes in pixels
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
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
const SIGNS = { ArrowLeft: "◀", ArrowUp: "▲", ArrowDown: "▼", ArrowRight: "▶" };
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const fill = (words, values) => words.replace(/\{(\w+)\}/g, (_, name) => values[name]);
const floats = (view) => new Float32Array(view.buffer.slice(view.byteOffset, view.byteOffset + view.byteLength));
const nameOf = (thing) => [thing.kind, thing.i, thing.r, thing.v].filter((part) => part !== undefined).join("-");

function make(tag, className, parent, attributes = {}) {
  const element = document.createElement(tag);
  element.className = className;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  parent?.append(element);
  return element;
}

function crossings(y, rings) {           // the x where a horizontal line crosses edges, ascending
  return rings.flatMap((ring) => ring.flatMap(([ax, ay], i) => {
    const [bx, by] = ring[(i + 1) % ring.length];
    return (ay > y) !== (by > y) ? [ax + ((y - ay) / (by - ay)) * (bx - ax)] : [];
  })).sort((a, b) => a - b);
}

// Whether a point is in the first ring and outside the others: a ray crosses an odd number of edges.
function inside(x, y, rings) {
  return crossings(y, rings).filter((at) => x < at).length % 2 === 1;
}

function middleAt(y, rings) {            // the middle of the longest piece of a horizontal line in rings
  const at = crossings(y, rings), wide = at.map((x, k) => (k % 2 ? x - at[k - 1] : 0)), k = wide.indexOf(Math.max(...wide));
  return k > 0 ? (at[k - 1] + at[k]) / 2 : null;
}

// ---- shared by all views

class Board {
  constructor(model) {
    Object.assign(this, { model, key: model.get("key"), words: model.get("words"), palette: model.get("palette") });
    this.views = new Set();
    this.id = Math.random().toString(36).slice(2);       // of this page; several may show one widget
    this.scene = copy(model.get("scene"));
    this.drawing = { text: "", warning: "", layers: [], total: 0, unit: "", stepTexts: [], places: [] };
    Object.assign(this, { seq: 0, shown: 0, asked: 0, stale: 0, answers: 0, took: 0, bitmaps: 0, unkept: false });
    Object.assign(this, { waiting: false, pendingSince: null, step: 0, playing: null });
    Object.assign(this, { held: new Set(), ticking: 0 });
    this.moved = new Map();                              // the things moved since the last question
    model.on("msg:custom", (message, buffers) => this.receive(message, buffers));
    model.on("change:scene", () => this.replaced());
    model.on("change:bitmap", () => this.laid());
    this.model.send({ kind: "hello", from: this.id });
  }

  stop() { this.pause(); this.release(); clearTimeout(this.timer); clearTimeout(this.resting); }
  changed() { this.views.forEach((view) => view.request()); }

  // the scene: the places of things, and moving them

  things() {
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

  item(thing) { return this.scene[{ handle: "handles", disc: "discs" }[thing.kind] ?? "polygons"][thing.i]; }

  shape(thing) {                         // the coordinates: a point, or the rings of a polygon
    const item = this.item(thing);
    if (thing.kind === "polygon") return item.rings;
    return thing.kind === "vertex" ? item.rings[thing.r][thing.v] : item.at;
  }

  place(thing) {                         // one point; for a polygon one inside, if possible its box's middle
    if (thing.kind !== "polygon") return this.shape(thing);
    const rings = this.shape(thing);
    const [x, y] = [0, 1].map((k) => (Math.min(...rings[0].map((p) => p[k])) + Math.max(...rings[0].map((p) => p[k]))) / 2);
    return inside(x, y, rings) ? [x, y] : [middleAt(y, rings) ?? x, y];
  }

  // Move a thing of the shape `from` by the vector from `anchor` to `to`; `to` is kept in the world.
  move(thing, from, anchor, to) {
    const { decimals } = this.scene, kept = this.kept(to);
    const shift = [0, 1].map((k) => kept[k] - anchor[k]);
    const item = this.item(thing), taken = this.riders(item);
    if (thing.kind === "polygon") {
      const rounded = shift.map((d) => Number(d.toFixed(decimals)));
      item.rings = from.map((ring) => ring.map((p) => p.map((x, k) => Number((x + rounded[k]).toFixed(decimals + 3)))));
    } else {
      const point = from.map((x, k) => Number((x + shift[k]).toFixed(decimals)));
      if (thing.kind === "vertex") item.rings[thing.r][thing.v] = point; else item.at = point;
      for (const i of taken) this.scene.handles[i].at = [...point];
    }
    this.hasMoved({ kind: thing.kind === "vertex" ? "polygon" : thing.kind, i: thing.i }, ...taken.map((i) => ({ kind: "handle", i })));
  }

  kept([x, y]) {                         // a place clamped to the world, or wrapped where sides are glued
    const { lo, hi, glued } = this.scene;
    if (!glued) return [clamp(x, lo[0], hi[0]), clamp(y, lo[1], hi[1])];
    return [x, y].map((value, k) => { const low = glued.lo[k], round = glued.hi[k] - low; return low + ((((value - low) % round) + round) % round); });
  }

  riders(stop) {                         // the handles that stand exactly on a stop and move with it
    const { handles } = this.scene;
    return stop.stop ? [...handles.keys()].filter((i) => !handles[i].stop && same(handles[i].at, stop.at)) : [];
  }

  call(i, stop) {                        // move handle i to a stop
    this.scene.handles[i].at = [...stop.at];
    this.hasMoved({ kind: "handle", i });
  }

  hasMoved(...things) {
    things.forEach(({ kind, i }) => this.moved.set(`${kind}-${i}`, [kind, i]));
    this.seq += 1;
    this.pendingSince ??= performance.now();
    this.ask(false);
    this.changed();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.changed(), PENDING + 20);
  }

  settle() {                             // a thing was released: store the scene when it is answered
    this.unkept = true;
    this.ask(true);
    this.keep();
  }

  keep() {
    if (!this.unkept || this.shown !== this.seq) return;
    this.unkept = false;
    this.put();
    this.model.set("scene", copy(this.scene));
    this.model.save_changes();
  }

  reset() {
    const home = this.model.get("home");
    const mark = (kind) => (_, i) => this.moved.set(`${kind}-${i}`, [kind, i]);
    this.scene = copy(home);
    home.handles.forEach(mark("handle"));
    home.polygons.forEach(mark("polygon"));
    home.discs.forEach(mark("disc"));
    this.seq += 1;
    this.settle();
    this.changed();
  }

  replaced() {                           // Python or another page set the scene: ask for its drawing
    if (same(this.model.get("scene"), this.scene)) return;
    this.scene = copy(this.model.get("scene"));
    this.moved.clear();
    this.model.send({ kind: "hello", from: this.id });
    this.changed();
  }

  laid() {                               // Python set another bitmap
    this.bitmaps += 1;
    this.views.forEach((view) => { view.bitmap = view.bitmapPicture(); });
    this.changed();
  }

  put() {                                // move things as the newest answer says, except those being dragged
    if (this.shown !== this.seq) return;
    const held = [...this.views].flatMap((view) => [...view.grabs.values()].map(({ thing }) => this.item(thing)));
    for (const [kind, i, where] of this.drawing.places) {
      const item = this.item({ kind, i });
      if (!held.includes(item)) item[kind === "polygon" ? "rings" : "at"] = where;
    }
  }

  // questions and answers

  ask(released) {
    const limit = this.took > SLOW ? 1 : IN_FLIGHT;
    clearTimeout(this.resting);
    if (this.took > VERY_SLOW && !released) { this.resting = setTimeout(() => this.ask(true), REST); return; }
    this.waiting = this.asked >= limit;
    if (this.waiting) return;
    if (this.moved.size === 0) return;
    const moved = [...this.moved.values()].map(([kind, i]) => [kind, i, this.shape({ kind, i })]);
    this.moved.clear();
    this.asked += 1;
    this.model.send({ kind: "scene", from: this.id, seq: this.seq, moved });
    this.tell("asked", this.seq);
  }

  receive(message, buffers) {
    if (!["drawing", "skipped"].includes(message.kind) || (message.to && message.to !== this.id)) return;
    if (message.seq !== null) this.asked = Math.max(this.asked - 1, 0);
    if (message.kind === "drawing") {
      if (message.seq !== null && message.seq < this.shown) this.stale += 1; else this.show(message, buffers);
    }
    if (this.waiting) this.ask(true);
  }

  // driving: while keys are held, Python gets a message every TICK and moves the driven handle

  hold(key, down) {
    if (down) this.held.add(key); else this.held.delete(key);
    if (down && !this.ticking) this.tick();
  }

  release() { this.held.clear(); }

  tick() {
    this.ticking = this.held.size ? setTimeout(() => this.tick(), TICK) : 0;
    if (!this.held.size || this.asked >= IN_FLIGHT) return;
    this.asked += 1;
    this.model.send({ kind: "keys", from: this.id, seq: this.seq, held: [...this.held] });
    this.tell("asked", this.seq);
  }

  show(message, buffers) {
    const layers = message.layers.map((layer, i) => ({ ...layer, data: floats(buffers[i]) }));
    const { seq, text, warning, total, unit, step_texts: stepTexts, places, took } = message;
    this.drawing = { text, warning, layers, total, unit, stepTexts, places };
    this.took = took;
    this.answers += 1;
    if (seq !== null) this.shown = seq;
    this.put();
    this.keep();
    this.pendingSince = seq !== null && seq < this.seq ? performance.now() : null;
    this.playing = null;
    this.step = total;
    this.tell("answered", seq);
    this.changed();
  }

  tell(what, seq) { this.views.forEach((view) => view.root.dispatchEvent(new CustomEvent(`kinoedu-${what}`, { detail: seq, bubbles: true }))); }

  // growth

  growTo(step) { this.step = clamp(Math.round(step), 0, this.drawing.total); this.lead(); this.changed(); }

  team() { return this.model.get("partner") || this.key; }

  lead() {                               // scrub the partners that have the same number of steps
    for (const other of boards.values()) {
      if (other === this || other.team() !== this.team() || other.drawing.total !== this.drawing.total) continue;
      Object.assign(other, { step: this.step, playing: null });
      other.changed();
    }
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

  text() {
    const { text, warning, total, unit, stepTexts } = this.drawing;
    if (this.pendingSince !== null && performance.now() - this.pendingSince > PENDING) return this.words.thinking;
    if (this.step < total && !warning) {
      return stepTexts[this.step] ?? fill(this.words.growth, { shown: this.step, total, unit });
    }
    return warning || text;
  }
}

// ---- one picture of a board

class View {
  constructor(board, el) {
    this.board = board;
    this.grabs = new Map();              // the thing dragged by each pointer or finger
    this.buttons = new Map();            // a button for each thing, by its name
    this.entered = null;                 // the polygon whose vertices have buttons
    this.paints = 0;
    this.build(el);
    this.listen();
    this.bitmap = this.bitmapPicture();
    this.resizing = new ResizeObserver(() => this.resize());
    this.resizing.observe(this.root);
    board.views.add(this);
    this.resize();
  }

  close() { this.resizing.disconnect(); clearTimeout(this.speaking); this.board.views.delete(this); }

  build(el) {
    const { words, palette } = this.board;
    this.root = make("div", "kinoedu-board", el, { "data-lm-suppress-shortcuts": "true" });
    this.root.style.setProperty("--kinoedu-focus", palette.ink);
    this.root.style.setProperty("--kinoedu-warning", palette.goal);
    this.stage = make("div", "kinoedu-stage", this.root);
    this.canvas = make("canvas", "kinoedu-canvas", this.stage, { role: "img" });
    this.overlay = make("div", "kinoedu-overlay", this.stage, { role: "group", "aria-label": words.movable });
    this.growth = make("div", "kinoedu-growth", this.root);
    this.button = make("button", "kinoedu-play", this.growth, { type: "button" });
    this.slider = make("input", "kinoedu-slider", this.growth, { type: "range", min: 0, step: 1, "aria-label": words.slider });
    this.back = make("button", "kinoedu-reset", this.growth, { type: "button" });
    this.back.textContent = words.reset;
    this.driven = this.board.scene.handles.findIndex((handle) => handle.driven);
    if (this.driven >= 0) this.buildPad();
    this.text = make("div", "kinoedu-text", this.root, { "aria-hidden": "true" });
    this.state = make("div", "kinoedu-state", this.root, { role: "status", "aria-live": "polite" });
    const { handles, polygons, posed } = this.board.scene;
    const hints = [words.hint, polygons.some((p) => p.vertices) && words.deeper, handles.some((h) => h.stop) && words.stops,
      posed && words.posed, this.driven >= 0 && words.driving];
    if (this.board.things().length) make("div", "kinoedu-hint", this.root).textContent = hints.filter(Boolean).join(" ");
    this.pen = this.canvas.getContext("2d");
  }

  buildPad() {                           // a button for each arrow key, for touch screens
    const { board } = this;
    this.pad = make("div", "kinoedu-pad", this.growth, { role: "group", "aria-label": board.words.pad });
    for (const [key, sign] of Object.entries(SIGNS)) {
      const button = make("button", "", this.pad, { type: "button", "data-key": key, "aria-label": board.words[key] });
      button.textContent = sign;
      button.addEventListener("pointerdown", (event) => { button.setPointerCapture(event.pointerId); board.hold(key, true); });
      for (const end of ["pointerup", "pointercancel"]) button.addEventListener(end, () => board.hold(key, false));
      button.addEventListener("contextmenu", (event) => event.preventDefault());         // of a long touch
      button.addEventListener("click", (event) => { if (event.detail === 0) { board.hold(key, true); board.hold(key, false); } });
    }
    this.steered(this.pad);
  }

  steered(element) {                     // let arrow keys drive while the element has the focus
    const held = (down) => (event) => {
      if (!WAYS[event.key] || event.ctrlKey || event.metaKey) return;
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
    canvas.addEventListener("pointermove", (e) => this.drag(e));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (e) => this.letGo(e));
    // The notebook must not handle the keys that the board uses.
    this.root.addEventListener("keydown", (e) => { if (!e.ctrlKey && !e.metaKey) e.stopPropagation(); });
    this.button.addEventListener("click", () => board.play());
    this.back.addEventListener("click", () => board.reset());
    this.slider.addEventListener("input", () => { board.playing = null; board.growTo(this.slider.valueAsNumber); });
  }

  // coordinates: the world's (x, y) with y up, and the picture's pixels with y down

  resize() {
    const { lo, hi } = this.board.scene;
    const [wide, high] = [hi[0] - lo[0], hi[1] - lo[1]];
    const room = Math.max(Math.min(this.root.clientWidth || WIDEST, WIDEST), 160) - 2 * PAD;
    this.fit = Math.min(room / wide, (HIGHEST - 2 * PAD) / high);
    this.width = Math.round(wide * this.fit + 2 * PAD);
    this.height = Math.round(high * this.fit + 2 * PAD);
    this.look();
    this.stage.style.width = `${this.width}px`;
    this.stage.style.height = `${this.height}px`;
    this.growth.style.maxWidth = `${Math.max(this.width, 320)}px`;
    this.request();
  }

  look() {                               // at the whole world, or at the part that an eye shows at this step
    const { lo, hi } = this.board.scene, eye = this.board.drawing.layers.find((layer) => layer.kind === "eye");
    const size = Math.max(hi[0] - lo[0], hi[1] - lo[1]);
    Object.assign(this, { scale: this.fit, unit: this.fit * size, left: PAD, bottom: this.height - PAD });
    if (!eye) return;
    let [x, y, seen] = [0, 0, 1];
    for (let k = 0; k + 4 <= eye.data.length && eye.data[k + 3] <= this.board.step; k += 4) [x, y, seen] = eye.data.subarray(k, k + 3);
    Object.assign(this, { scale: this.fit / seen, unit: (this.fit * size) / seen });
    Object.assign(this, { left: this.width / 2 - x * this.unit, bottom: this.height / 2 + y * this.unit });
  }

  toPixels([x, y]) {
    const { lo } = this.board.scene;
    return [this.left + (x - lo[0]) * this.scale, this.bottom - (y - lo[1]) * this.scale];
  }

  toWorld(event) {
    const box = this.canvas.getBoundingClientRect(), { lo } = this.board.scene;
    const px = ((event.clientX - box.left) / box.width) * this.width, py = ((event.clientY - box.top) / box.height) * this.height;
    return [lo[0] + (px - this.left) / this.scale, lo[1] + (this.bottom - py) / this.scale];
  }

  // pointers

  nearest(things, at, reach) {           // the thing nearest to a place within `reach` pixels; ties: the first
    const far = things.map((thing) => { const p = this.board.place(thing); return Math.hypot(p[0] - at[0], p[1] - at[1]) * this.scale; });
    const best = far.indexOf(Math.min(...far));
    return far[best] <= reach ? things[best] : null;
  }

  handleAt(at, touch) { return this.nearest(this.board.things().filter((thing) => thing.kind === "handle"), at, touch ? 28 : 16); }

  stopAt(at, touch) { return this.nearest(this.board.things().filter((thing) => this.board.item(thing).stop), at, touch ? 28 : 16); }

  under(at, touch) {                     // the thing at a place: the nearest point in reach, or what covers it
    const { board } = this, { scene } = board;
    const point = this.handleAt(at, touch) ?? this.nearest(scene.polygons.flatMap((_, i) => board.vertices(i)), at, touch ? 18 : 12);
    if (point) return point;
    return board.things().findLast((thing) => {
      const item = board.item(thing);
      if (thing.kind === "disc") return Math.hypot(item.at[0] - at[0], item.at[1] - at[1]) <= Math.max(item.radius, 12 / this.scale);
      return thing.kind === "polygon" && inside(...at, item.rings);
    }) ?? null;
  }

  grab(event) {
    const anchor = this.toWorld(event), thing = this.under(anchor, event.pointerType === "touch");
    if (event.button > 0 || (!thing && !this.board.scene.posed)) return;
    event.preventDefault();
    if (thing && this.board.item(thing).driven) { this.buttons.get(nameOf(thing)).focus({ preventScroll: true }); return; }
    this.canvas.setPointerCapture(event.pointerId);
    if (!thing) { this.pose(event, anchor); return; }
    const point = thing.kind !== "polygon";
    // Points keep their distance from the pointer, so that they do not jump.
    const offset = point ? this.board.place(thing).map((x, k) => x - anchor[k]) : [0, 0];
    const held = { thing, offset, anchor: point ? this.board.place(thing) : anchor, from: copy(this.board.shape(thing)) };
    this.grabs.set(event.pointerId, { ...held, x: event.clientX, y: event.clientY, still: true });
    if (thing.kind === "vertex") this.enter(thing.i);
    this.buttons.get(nameOf(thing))?.focus({ preventScroll: true });
    this.request();
  }

  pose(event, anchor) {                  // move a place to the pointer, and drag its tip
    const { board } = this, place = { kind: "handle", i: event.shiftKey ? 0 : 2 }, tip = { kind: "handle", i: place.i + 1 };
    board.move(place, board.place(place), board.place(place), anchor);
    this.grabs.set(event.pointerId, { thing: tip, offset: [0, 0], anchor, from: anchor, x: event.clientX, y: event.clientY, fresh: true });
    this.buttons.get(nameOf(place))?.focus({ preventScroll: true });
  }

  drag(event) {
    const held = this.grabs.get(event.pointerId), at = this.toWorld(event);
    if (!held) { this.canvas.style.cursor = this.under(at, false) ? "grab" : ""; return; }
    held.still &&= this.stopAt(at, false) !== null && Math.hypot(event.clientX - held.x, event.clientY - held.y) < JITTER;
    held.fresh &&= Math.hypot(event.clientX - held.x, event.clientY - held.y) < TURNS;
    if (held.still || held.fresh) return;
    this.canvas.style.cursor = "grabbing";
    this.board.move(held.thing, held.from, held.anchor, at.map((x, k) => x + held.offset[k]));
  }

  letGo(event) {
    const held = this.grabs.get(event.pointerId);
    if (!held) return;
    this.grabs.delete(event.pointerId);
    this.canvas.style.cursor = "";
    const { board } = this, item = board.item(held.thing);
    const stop = this.stopAt(held.still || !item.at ? this.toWorld(event) : item.at, event.pointerType === "touch");
    if (stop && held.still) board.call(event.shiftKey ? 0 : 1, board.item(stop));
    else if (stop && held.thing.kind === "handle" && !item.stop) board.call(held.thing.i, board.item(stop));   // released near it
    board.settle();
    this.request();
  }

  // keys: every thing has a button over it, visible only while it has the focus

  press(event, thing) {
    const way = WAYS[event.key];
    const { board } = this, { lo, hi } = board.scene;
    if (way) {
      const size = Math.max(hi[0] - lo[0], hi[1] - lo[1]) * (event.shiftKey ? 0.05 : 0.01), at = board.place(thing);
      board.move(thing, copy(board.shape(thing)), at, at.map((x, k) => x + way[k] * size));
      clearTimeout(this.settling);
      this.settling = setTimeout(() => board.settle(), 300);
    } else if (event.key === "Enter" && board.item(thing).stop) {
      board.call(event.shiftKey ? 0 : 1, board.item(thing));
      board.settle();
    } else if (event.key === "Enter" && thing.kind === "polygon" && board.vertices(thing.i).length) {
      this.enter(thing.i);
      this.buttons.get(nameOf(board.vertices(thing.i)[0])).focus();
    } else if (event.key === "Escape" && thing.kind === "vertex") {
      this.buttons.get(nameOf({ kind: "polygon", i: thing.i }))?.focus();
      this.enter(null);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  enter(i) { this.entered = i; this.placeButtons(); }

  placeButtons() {
    const { board } = this, wanted = new Map();
    for (const thing of board.things()) {
      wanted.set(nameOf(thing), thing);
      if (thing.kind === "polygon" && thing.i === this.entered) board.vertices(thing.i).forEach((v) => wanted.set(nameOf(v), v));
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
    this.buttons = new Map([...wanted].map(([name, thing]) => {
      const button = before.get(name) ?? make("button", "kinoedu-thing", null, { type: "button", "data-thing": name });
      if (before.has(name)) return [name, button];
      if (this.board.item(thing).driven) this.steered(button); else button.addEventListener("keydown", (event) => this.press(event, thing));
      return [name, button];
    }));
    before.forEach((button, name) => { if (!wanted.has(name)) button.remove(); });
    const inOrder = [...this.buttons.values()];
    inOrder.forEach((button, k) => { if (this.overlay.children[k] !== button) this.overlay.insertBefore(button, this.overlay.children[k] ?? null); });
  }

  label(thing, [x, y]) {
    const { words, scene } = this.board, show = (value) => value.toFixed(scene.decimals);
    const item = this.board.item(thing);
    const kind = thing.kind === "polygon" && item.vertices ? "polygon" : thing.kind === "vertex" ? "vertex" : item.stop ? "stop" : item.driven ? "driven" : "handle";
    return fill(words[kind], { name: item.name, number: thing.v, x: show(x), y: show(y) });
  }

  // painting: at most once a frame

  request() { this.frame ||= requestAnimationFrame(() => { this.frame = 0; this.paint(); }); }

  paint() {
    const { board, pen } = this, ratio = window.devicePixelRatio || 1;
    const [across, down] = [Math.round(this.width * ratio), Math.round(this.height * ratio)];
    if (this.canvas.width !== across || this.canvas.height !== down) Object.assign(this.canvas, { width: across, height: down });
    pen.setTransform(across / this.width, 0, 0, down / this.height, 0, 0);
    pen.lineJoin = pen.lineCap = "round";
    if (!this.grabs.size) this.look();   // the view does not move during a drag
    const late = board.pendingSince !== null && performance.now() - board.pendingSince > PENDING;
    const layers = board.drawing.layers.filter((layer) => !layer.last || board.step >= board.drawing.total);
    const paint = (wanted) => {
      pen.globalAlpha = late ? 0.35 : 1;
      for (const layer of layers) if ((layer.kind === "cells") === wanted) this[`paint_${layer.kind}`]?.(layer);
      pen.globalAlpha = 1;
    };
    this.paintGround();
    paint(true);
    this.paintSolids();
    paint(false);
    board.scene.handles.forEach((handle) => this.paintHandle(handle));
    this.placeButtons();
    this.tellState(late);
    this.paints += 1;
    this.root.dispatchEvent(new CustomEvent("kinoedu-painted", { detail: board.shown, bubbles: true }));
  }

  paintGround() {
    const { pen, board } = this, { scene, palette } = board;
    pen.fillStyle = scene.boundary || (this.bitmap && !scene.glued) ? palette.outside : palette.free;
    pen.fillRect(0, 0, this.width, this.height);
    if (this.bitmap) this.paintBitmap();
    pen.lineWidth = 1.5;
    pen.strokeStyle = palette.obstacle;
    if (scene.boundary) { this.trace([scene.boundary]); pen.fillStyle = palette.free; pen.fill(); pen.stroke(); }
  }

  paintSolids() {
    const { pen } = this, { scene, palette } = this.board, polygons = scene.polygons.filter((polygon) => !polygon.drawn);
    pen.fillStyle = palette.obstacle;
    for (const polygon of polygons) { this.trace(polygon.rings); pen.fill("evenodd"); }
    for (const { at, radius } of scene.discs) { pen.beginPath(); pen.arc(...this.toPixels(at), radius * this.scale, 0, 7); pen.fill(); }
    for (const polygon of polygons) if (polygon.vertices) polygon.rings.flat().forEach((p) => this.dot(p, 4, palette.free, palette.obstacle));
  }

  trace(rings) {
    this.pen.beginPath();
    for (const ring of rings) {
      ring.forEach((p, k) => (k ? this.pen.lineTo(...this.toPixels(p)) : this.pen.moveTo(...this.toPixels(p))));
      this.pen.closePath();
    }
  }

  bitmapPicture() {                      // one bit per cell, or one byte with own colours; lowest row first
    const { size, colours } = this.board.scene, view = this.board.model.get("bitmap"), { palette } = this.board;
    if (!size || !view || !view.byteLength) return null;
    const [rows, columns] = size, bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
    const picture = make("canvas", "", null, { width: columns, height: rows }), pen = picture.getContext("2d");
    const image = pen.createImageData(columns, rows), pixels = new Uint32Array(image.data.buffer);
    const colour = (hex) => { const [r, g, b] = [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16)); return (255 << 24) | (b << 16) | (g << 8) | r; };
    const shades = (colours ?? ["obstacle", "free"]).map((name) => colour(palette[name]));
    const number = colours ? (cell) => bytes[cell] : (cell) => (bytes[cell >> 3] >> (7 - (cell & 7))) & 1;
    for (let cell = 0; cell < rows * columns; cell += 1) {
      const row = rows - 1 - Math.floor(cell / columns);
      pixels[row * columns + (cell % columns)] = shades[number(cell)];
    }
    pen.putImageData(image, 0, 0);
    return picture;
  }

  paintBitmap() {
    const { lo, hi } = this.board.scene.glued ?? this.board.scene, [x0, y1] = this.toPixels(lo), [x1, y0] = this.toPixels(hi);
    // Smooth only when the bitmap is made smaller, so that cells stay sharp.
    this.pen.imageSmoothingEnabled = (x1 - x0) * (window.devicePixelRatio || 1) < this.bitmap.width;
    this.pen.drawImage(this.bitmap, x0, y0, x1 - x0, y1 - y0);
  }

  paintHandle({ name, at, colour, marker, radius, stop, drawn }) {
    if (stop || drawn) return;
    const { pen } = this, { palette, scene } = this.board, [px, py] = this.toPixels(at), paint = palette[colour];
    if (radius) { pen.globalAlpha = 0.35; pen.fillStyle = paint; pen.beginPath(); pen.arc(px, py, radius * this.scale, 0, 7); pen.fill(); pen.globalAlpha = 1; }
    if (marker === "star") this.star(px, py, 12, paint); else this.dot(at, 7, paint, palette.free);
    const right = at[0] < scene.lo[0] + 0.75 * (scene.hi[0] - scene.lo[0]), low = scene.handles.some((h) => h.stop);
    const up = !low && at[1] < scene.lo[1] + 0.85 * (scene.hi[1] - scene.lo[1]);       // stops' names are above
    this.write(name, px + (right ? 11 : -11), py + (up ? -15 : 15), paint, right ? "left" : "right", true);
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

  write(text, px, py, colour, align = "left", bold = false) {
    const { pen } = this;
    Object.assign(pen, { font: `${bold ? "bold " : ""}14px system-ui, sans-serif`, textAlign: align, textBaseline: "middle" });
    Object.assign(pen, { strokeStyle: this.board.palette.free, lineWidth: 4, fillStyle: colour });
    pen.strokeText(text, px, py);
    pen.fillText(text, px, py);
  }

  // layers: coordinates are multiples of the world's size, from its lower left corner. In a layer
  // that grows each row ends with the step at which it appears, and where rows do not stay, also
  // with the step at which it disappears.

  eachRow({ data, grows, ends }, size, visit) {
    const stride = size + (grows ? 1 : 0) + (ends ? 1 : 0), { unit, left, bottom } = this;
    for (let k = 0; k + stride <= data.length; k += stride) {
      if (grows && data[k + size] > this.board.step) break;
      if (ends && data[k + stride - 1] <= this.board.step) continue;
      visit(left + data[k] * unit, bottom - data[k + 1] * unit, data[k + 2] * unit, data[k + 3] * unit, k / stride);
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
    const { pen, left, bottom } = this;
    pen.beginPath();
    this.eachRow(layer, 4, (px, py, x, y) => { pen.moveTo(px, py); pen.lineTo(left + x, bottom - y); });
    this.stroke(layer);
  }

  outline(layer) {                       // trace the polygon of each row
    const { pen, unit, left, bottom } = this, size = 2 * layer.points, stride = size + (layer.grows ? 1 : 0) + (layer.ends ? 1 : 0);
    pen.beginPath();
    this.eachRow(layer, size, (_px, _py, _dx, _dy, k) => {
      for (let c = k * stride; c < k * stride + size; c += 2) {
        const at = [left + layer.data[c] * unit, bottom - layer.data[c + 1] * unit];
        if (c === k * stride) pen.moveTo(...at); else pen.lineTo(...at);
      }
      pen.closePath();
    });
  }

  paint_cells(layer) {
    this.outline(layer);
    this.pen.fillStyle = this.board.palette[layer.colour];
    this.pen.fill();
  }

  paint_bodies(layer) {
    const { pen, height } = this;
    pen.save();
    this.outline(layer);
    pen.fillStyle = this.board.palette[layer.colour];
    pen.globalAlpha *= TINT;
    pen.fill();
    pen.globalAlpha /= TINT;
    pen.clip();
    pen.beginPath();
    if (layer.hatched) for (let x = -height; x < this.width; x += STRIPES) { pen.moveTo(x, height); pen.lineTo(x + height, 0); }
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
      for (const turn of [2.6, -2.6]) { pen.moveTo(ex, ey); pen.lineTo(ex + 12 * Math.cos(angle + turn), ey + 12 * Math.sin(angle + turn)); }
    });
    this.stroke(layer);
  }

  paint_labels(layer) {
    this.pen.font = "14px system-ui, sans-serif";
    this.eachRow(layer, 2, (px, py, _dx, _dy, k) => {
      const right = px + 12 + this.pen.measureText(layer.texts[k]).width < this.width;
      this.write(layer.texts[k], px + (right ? 10 : -10), clamp(py - 12, 12, this.height - 12), this.board.palette[layer.colour], right ? "left" : "right");
    });
  }

  // the text below the picture

  tellState(late) {
    const { board } = this, { drawing, words } = board, text = board.text();
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.text.textContent = text;
    this.text.classList.toggle("kinoedu-warning", Boolean(drawing.warning) && !late);
    this.growth.classList.toggle("kinoedu-nothing", drawing.total === 0);
    this.slider.max = drawing.total;
    this.slider.value = board.step;
    this.slider.setAttribute("aria-valuetext", fill(words.growth, { shown: board.step, total: drawing.total, unit: drawing.unit }));
    this.button.textContent = board.playing ? words.pause : still ? words.next : words.play;
    const layers = drawing.layers.map((layer) => layer.kind).join(" "), { shown: seq, seq: newest, answers, stale, step, bitmaps } = board;
    Object.assign(this.root.dataset, { seq, newest, answers, stale, step, layers, bitmaps, total: drawing.total, paints: this.paints, warning: drawing.warning });
    if (text === this.last) return;
    this.last = text;
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => { this.state.textContent = this.last; this.canvas.ariaLabel = this.last; }, QUIET);
  }
}
