// The board of solids, in plain JavaScript: no build step, no downloads, no animation.
//
// On the left is a mesh, painted from the farthest triangle to the nearest; above the plane it is
// transparent, so that the cut is visible. On the right is the section that Python computes. One
// question to Python is open at a time, and Python answers each; the next one is about the newest
// scene.

const STEP = Math.PI / 36;    // radians that an arrow key turns the mesh
const NEAREST = 4, FARTHEST = 0.4;
const GLASS = 0.2;            // the opacity of what is above the plane

const degrees = (angle) => Math.round((angle * 180) / Math.PI);
const array = (Kind, view) => {
  const end = view.byteOffset + view.byteLength;
  return new Kind(view.buffer.slice(view.byteOffset, end));
};

export default {
  render({ model, el }) {
    const board = new Solid(model, el);
    return () => board.close();
  },
};

class Solid {
  constructor(model, el) {
    this.model = model;
    this.words = model.get("words");
    this.themes = model.get("palette");
    this.box = model.get("box");
    this.theta = model.get("theta");
    this.place = model.get("place");
    this.open = false;                   // whether a question is open
    this.asked = 0;                      // questions so far
    Object.assign(this, { azimuth: -1.05, height: 0.42, zoom: 1, paints: 0, queued: false });
    this.points = array(Float32Array, model.get("vertices"));
    this.faces = array(Uint32Array, model.get("faces"));
    this.colours = array(Uint8Array, model.get("colours"));
    this.normalise();
    this.build(el);
    this.measure();
    this.listen();
    this.endTheme = followTheme((theme) => this.dress(theme), () => this.paint());
    this.endPixels = followPixels(() => this.request());
    this.answered = () => this.receive();
    this.replaced = () => this.replace();
    model.on("change:section", this.answered);
    model.on("change:theta", this.replaced);
    model.on("change:place", this.replaced);
    this.resizing = new ResizeObserver(() => { this.measure(); this.request(); });
    this.resizing.observe(this.root);
  }

  close() {
    this.resizing.disconnect();
    this.endTheme();
    this.endPixels();
    this.model.off("change:section", this.answered);
    this.model.off("change:theta", this.replaced);
    this.model.off("change:place", this.replaced);
  }

  dress(theme) {                         // take the colours of the page's theme
    this.palette = this.themes[theme] ?? this.themes.light;
    this.root.dataset.theme = theme;
    this.root.style.setProperty("--kinoedu-free", this.palette.free);
    this.request();
  }

  receive() {                            // the answer to the open question has come
    this.open = false;
    this.emit("answered", this.asked);
    this.ask();
    this.request();
  }

  replace() {                            // Python has moved the plane or the point
    if (this.open) return;
    this.theta = this.model.get("theta");
    this.place = this.model.get("place");
    this.request();
  }

  normalise() {                          // centre the box; x and y have one scale, theta another
    const [lo, hi] = this.box;
    this.middle = lo.map((l, k) => (l + hi[k]) / 2);
    const wide = Math.max(hi[0] - lo[0], hi[1] - lo[1]);
    this.scales = [2 / wide, 2 / wide, 2 / (hi[2] - lo[2])];
    const scaled = (x, i) => (x - this.middle[i % 3]) * this.scales[i % 3];
    this.unit = Float32Array.from(this.points, scaled);
  }

  build(el) {
    const { words } = this;
    this.root = make("div", "kinoedu-solid", el, { "data-lm-suppress-shortcuts": "true" });
    const panels = make("div", "kinoedu-solid-panels", this.root);
    // not images: with that role screen readers keep the arrow keys for themselves
    const moved = { tabindex: 0, role: "application" };
    this.solid = make("canvas", "kinoedu-solid-mesh", panels, moved);
    this.slice = make("canvas", "kinoedu-solid-slice", panels, moved);
    const row = make("label", "kinoedu-solid-plane", this.root);
    make("span", "", row).textContent = words.theta;
    const [lo, hi] = this.box;
    const range = { type: "range", min: lo[2], max: hi[2], step: "any" };
    this.slider = make("input", "kinoedu-solid-slider", row, range);
    this.reading = make("output", "", row);
    const status = { role: "status", "aria-live": "polite" };
    this.text = make("div", "kinoedu-solid-text", this.root, status);
    make("div", "kinoedu-solid-hint", this.root).textContent = words.hint;
  }

  listen() {
    this.drags(this.solid, (dx, dy, size) => this.turn((-4 * dx) / size, (4 * dy) / size));
    this.drags(this.slice, (dx, dy) => this.shift(dx / this.scale, -dy / this.scale));
    const turn = (x, y) => this.turn(-x * STEP, -y * STEP);
    const shift = (x, y) => this.shift((x * 8) / this.scale, (y * 8) / this.scale);
    this.keys(this.solid, turn, (sign) => this.nearer(1.15 ** sign));
    this.keys(this.slice, shift, () => {});
    this.root.addEventListener("keydown", (e) => {
      if (!e.ctrlKey && !e.metaKey) e.stopPropagation();
    });
    this.solid.addEventListener("wheel", (e) => {
      if (document.activeElement !== this.solid) return;       // so that pages can be scrolled
      e.preventDefault();
      this.nearer(Math.exp(-e.deltaY / 500));
    }, { passive: false });
    this.slider.addEventListener("input", () => {
      this.theta = this.slider.valueAsNumber;
      this.ask();
      this.request();
    });
  }

  drags(canvas, move) {                  // call `move` for each move of a pressed pointer
    let last = null;
    const end = () => { last = null; };
    canvas.addEventListener("pointerdown", (e) => {
      last = [e.clientX, e.clientY];
      canvas.setPointerCapture(e.pointerId);
      canvas.focus();
    });
    canvas.addEventListener("pointermove", (e) => {
      if (last === null) return;
      move(e.clientX - last[0], e.clientY - last[1], canvas.clientWidth);
      last = [e.clientX, e.clientY];
    });
    canvas.addEventListener("lostpointercapture", end);        // also after each release
  }

  keys(canvas, arrow, sign) {            // call `arrow` for arrow keys and `sign` for + and -
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    canvas.addEventListener("keydown", (e) => {
      if (e.ctrlKey || e.metaKey || e.altKey) return;
      if (arrows[e.key]) arrow(...arrows[e.key]);
      else if (e.key === "+" || e.key === "=") sign(1);
      else if (e.key === "-") sign(-1);
      else return;
      e.preventDefault();
    });
  }

  turn(round, up) {
    this.azimuth += round;
    this.height = clamp(this.height + up, -Math.PI / 2, Math.PI / 2);
    this.request();
  }

  nearer(factor) { this.zoom = clamp(this.zoom * factor, FARTHEST, NEAREST); this.request(); }

  shift(dx, dy) {
    if (this.place === null) return;
    const [lo, hi] = this.window;
    this.place = this.place.map((x, k) => clamp(x + [dx, dy][k], lo[k], hi[k]));
    this.ask();
    this.request();
  }

  ask() {                                // ask for the section, unless a question is open
    const { model, theta, place } = this, section = model.get("section");
    if (section.theta === theta && same(section.place, place)) return;
    if (this.open || (model.get("theta") === theta && same(model.get("place"), place))) return;
    this.open = true;
    keepStill();
    this.emit("sent", this.asked += 1);
    model.set({ theta, place });
    model.save_changes();
  }

  emit(name, detail) {
    this.root.dispatchEvent(new CustomEvent(`kinoedu-${name}`, { detail, bubbles: true }));
  }

  request() {
    if (this.queued) return;
    this.queued = true;
    requestAnimationFrame(() => { this.queued = false; this.paint(); });
  }

  // painting

  measure() {                            // not in each paint, which would lay out the page anew
    this.sizes = new Map([this.solid, this.slice].map((canvas) => [canvas, canvas.clientWidth]));
  }

  pen(canvas) {
    const size = this.sizes.get(canvas) || 400, sharp = devicePixelRatio || 1;
    const pixels = Math.round(size * sharp);
    if (canvas.width !== pixels) canvas.width = canvas.height = pixels;
    const pen = canvas.getContext("2d");
    pen.setTransform(sharp, 0, 0, sharp, 0, 0);
    pen.clearRect(0, 0, size, size);
    pen.lineJoin = "round";
    return [pen, size];
  }

  projected([x, y, z], size) {           // from the unit box to right, down, towards the reader
    const c = Math.cos(this.azimuth), s = Math.sin(this.azimuth);
    const k = Math.cos(this.height), h = Math.sin(this.height);
    const right = -s * x + c * y, ahead = c * x + s * y, zoom = 0.27 * size * this.zoom;
    return [size / 2 + zoom * right, size / 2 - zoom * (k * z - h * ahead), k * ahead + h * z];
  }

  paint() {
    this.slider.value = this.theta;
    write(this.reading, `${degrees(this.theta)}°`);
    this.slider.ariaValueText = this.reading.textContent;
    this.paintSolid();
    this.paintSlice();
    const { azimuth, height, theta: level, zoom } = this;
    const values = { azimuth: degrees(azimuth), height: degrees(height), theta: degrees(level) };
    this.solid.ariaLabel = fill(this.words.solid, values);
    this.slice.ariaLabel = fill(this.words.slice, values);
    const { text, theta } = this.model.get("section");
    write(this.text, text);
    this.paints += 1;
    this.emit("painted", this.asked);
    Object.assign(this.root.dataset, { paints: this.paints, theta, azimuth, zoom });
  }

  // The triangles that look towards the reader, the farthest first, and all points on the picture.
  // They stay the same while only the plane moves.
  look(size) {
    const { azimuth, height, zoom, unit, faces } = this, view = { azimuth, height, zoom, size };
    if (same(this.seen?.view, view)) return this.seen;
    const at = new Float32Array(unit.length), towards = [];
    for (let i = 0; i < unit.length; i += 3) {
      at.set(this.projected(unit.subarray(i, i + 3), size), i);
    }
    for (let f = 0; f < faces.length; f += 3) {
      const [a, b, c] = [3 * faces[f], 3 * faces[f + 1], 3 * faces[f + 2]];
      const [ux, uy] = [at[b] - at[a], at[b + 1] - at[a + 1]];
      const [vx, vy] = [at[c] - at[a], at[c + 1] - at[a + 1]];
      if (ux * vy - uy * vx >= 0) continue;                    // it looks away from the reader
      const middle = (unit[a + 2] + unit[b + 2] + unit[c + 2]) / 3;
      const [red, green, blue] = this.colours.subarray(f, f + 3);
      const depth = at[a + 2] + at[b + 2] + at[c + 2];
      towards.push({ a, b, c, middle, depth, colour: `rgb(${red},${green},${blue})` });
    }
    towards.sort((p, q) => p.depth - q.depth);
    return (this.seen = { view, at, towards });
  }

  paintSolid() {
    const [pen, size] = this.pen(this.solid), { at, towards } = this.look(size);
    const level = (this.theta - this.middle[2]) * this.scales[2], fromBelow = this.height < 0;
    const below = towards.filter(({ middle }) => middle <= level);
    const above = towards.filter(({ middle }) => middle > level);
    const [farther, nearer] = fromBelow ? [above, below] : [below, above];
    this.paintFaces(pen, at, farther, fromBelow ? GLASS : 1);
    this.paintPlane(pen, size, level);
    this.paintFaces(pen, at, nearer, fromBelow ? 0.6 : GLASS);
  }

  paintFaces(pen, at, faces, alpha) {
    pen.globalAlpha = alpha;
    pen.lineWidth = 0.7;
    for (const { a, b, c, colour } of faces) {
      pen.beginPath();
      pen.moveTo(at[a], at[a + 1]);
      pen.lineTo(at[b], at[b + 1]);
      pen.lineTo(at[c], at[c + 1]);
      pen.closePath();
      pen.fillStyle = pen.strokeStyle = colour;
      pen.fill();
      if (alpha === 1) pen.stroke();     // hides seams
    }
    pen.globalAlpha = 1;
  }

  paintPlane(pen, size, level) {
    const pixel = (point) => {
      const flat = [0, 1].map((k) => (point[k] - this.middle[k]) * this.scales[k]);
      return this.projected([...flat, level], size).slice(0, 2);
    };
    const trace = (points) => points.forEach((p, i) => pen[i ? "lineTo" : "moveTo"](...pixel(p)));
    const [lo, hi] = this.box, margin = [0, 1].map((k) => 0.06 * (hi[k] - lo[k]));
    const [left, low] = [0, 1].map((k) => lo[k] - margin[k]);
    const [right, high] = [0, 1].map((k) => hi[k] + margin[k]);
    pen.beginPath();
    trace([[left, low], [right, low], [right, high], [left, high]]);
    pen.closePath();
    pen.globalAlpha = 0.25;
    pen.fillStyle = this.palette.path;
    pen.fill();
    pen.globalAlpha = 1;
    pen.strokeStyle = this.palette.cut;
    pen.lineWidth = 1;
    pen.stroke();
    pen.lineWidth = 3;
    pen.beginPath();
    this.model.get("cut").forEach(trace);
    pen.stroke();
    if (this.place) this.dot(pen, pixel(this.place), 4.5);
  }

  dot(pen, at, radius) {                 // the place of the point
    pen.fillStyle = this.palette.ink;
    pen.beginPath();
    pen.arc(...at, radius, 0, 7);
    pen.fill();
  }

  paintSlice() {
    const [pen, size] = this.pen(this.slice), [lo, hi] = this.box;
    const { shapes, place } = this.model.get("section");
    const reach = 0.66 * Math.max(hi[0] - lo[0], hi[1] - lo[1]);
    this.window = [-reach, reach].map((shift) => [0, 1].map((k) => this.middle[k] + shift));
    this.scale = size / (2 * reach);
    const [[left, low]] = this.window;
    const pixel = ([x, y]) => [(x - left) * this.scale, size - (y - low) * this.scale];
    const trace = (points) => points.forEach((p, i) => pen[i ? "lineTo" : "moveTo"](...pixel(p)));
    for (const shape of shapes) {
      pen.beginPath();
      trace(shape.points);
      this.paintShape(pen, shape);
    }
    pen.strokeStyle = this.palette.cut;
    pen.lineWidth = 2.5;
    pen.beginPath();
    this.model.get("cut").forEach(trace);
    pen.stroke();
    if (place) this.dot(pen, pixel(place), 5);
  }

  paintShape(pen, { fill: inner, line, alpha, closed }) {      // fill and stroke what was traced
    if (closed) pen.closePath();
    if (inner && closed) {
      pen.globalAlpha = alpha;
      pen.fillStyle = this.palette[inner];
      pen.fill();
      pen.globalAlpha = 1;
    }
    if (!line) return;
    pen.strokeStyle = this.palette[line];
    pen.lineWidth = 2;
    pen.stroke();
  }
}
