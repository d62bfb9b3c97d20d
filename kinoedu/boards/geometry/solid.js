// The board of solids, in plain JavaScript: no build step, no downloads, no animation.
//
// On the left is a mesh, painted from the farthest triangle to the nearest; above the plane it is
// transparent, so that the cut is visible. On the right is the section that Python computes. One
// question to Python is open at a time; the newest scene is asked next.

const STEP = Math.PI / 36, NEAREST = 4, FARTHEST = 0.4, GLASS = 0.2, WAIT = 2000;

const make = (tag, className, parent, attributes = {}) => {
  const element = document.createElement(tag);
  element.className = className;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  parent.append(element);
  return element;
};
const fill = (words, values) => words.replace(/\{(\w+)\}/g, (_, name) => values[name]);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const degrees = (angle) => Math.round((angle * 180) / Math.PI);
const array = (Kind, view) => new Kind(view.buffer.slice(view.byteOffset, view.byteOffset + view.byteLength));

export default {
  render({ model, el }) {
    const board = new Solid(model, el);
    return () => board.close();
  },
};

class Solid {
  constructor(model, el) {
    Object.assign(this, { model, words: model.get("words"), palette: model.get("palette"), box: model.get("box") });
    Object.assign(this, { azimuth: -1.05, height: 0.42, zoom: 1, asked: null, paints: 0, queued: false });
    this.theta = model.get("theta");
    this.place = model.get("place");
    this.points = array(Float32Array, model.get("vertices"));
    this.faces = array(Uint32Array, model.get("faces"));
    this.colours = array(Uint8Array, model.get("colours"));
    this.normalise();
    this.build(el);
    this.listen();
    this.answered = () => { this.asked = null; this.ask(); this.request(); };
    this.replaced = () => { if (this.asked === null) { this.theta = model.get("theta"); this.place = model.get("place"); this.request(); } };
    model.on("change:section", this.answered);
    model.on("change:theta", this.replaced);
    model.on("change:place", this.replaced);
    this.resizing = new ResizeObserver(() => this.request());
    this.resizing.observe(this.root);
    this.request();
  }

  close() {
    this.resizing.disconnect();
    this.model.off("change:section", this.answered);
    this.model.off("change:theta", this.replaced);
    this.model.off("change:place", this.replaced);
  }

  normalise() {                          // centre the box; one scale for x and y, theta scaled to their width
    const [lo, hi] = this.box;
    this.middle = lo.map((l, k) => (l + hi[k]) / 2);
    const wide = Math.max(hi[0] - lo[0], hi[1] - lo[1]);
    this.scales = [2 / wide, 2 / wide, 2 / (hi[2] - lo[2])];
    this.unit = Float32Array.from(this.points, (x, i) => (x - this.middle[i % 3]) * this.scales[i % 3]);
  }

  build(el) {
    const { words } = this;
    this.root = make("div", "kinoedu-solid", el, { "data-lm-suppress-shortcuts": "true" });
    const panels = make("div", "kinoedu-solid-panels", this.root);
    this.solid = make("canvas", "kinoedu-solid-mesh", panels, { tabindex: 0, role: "img" });
    this.slice = make("canvas", "kinoedu-solid-slice", panels, { tabindex: 0, role: "img" });
    const row = make("label", "kinoedu-solid-plane", this.root);
    make("span", "", row).textContent = words.theta;
    const [lo, hi] = this.box;
    this.slider = make("input", "kinoedu-solid-slider", row, { type: "range", min: lo[2], max: hi[2], step: "any" });
    this.reading = make("output", "", row);
    this.text = make("div", "kinoedu-solid-text", this.root, { role: "status", "aria-live": "polite" });
    make("div", "kinoedu-solid-hint", this.root).textContent = words.hint;
  }

  listen() {
    const grabbed = (canvas, move) => {
      let last = null;
      canvas.addEventListener("pointerdown", (e) => { last = [e.clientX, e.clientY]; canvas.setPointerCapture(e.pointerId); canvas.focus(); });
      canvas.addEventListener("pointermove", (e) => {
        if (last === null) return;
        move(e.clientX - last[0], e.clientY - last[1], canvas.clientWidth);
        last = [e.clientX, e.clientY];
      });
      for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { last = null; });
    };
    grabbed(this.solid, (dx, dy, size) => this.turn((-4 * dx) / size, (4 * dy) / size));
    grabbed(this.slice, (dx, dy) => this.shift(dx / this.scale, -dy / this.scale));
    this.solid.addEventListener("wheel", (e) => {       // only with the focus, so that pages can be scrolled
      if (document.activeElement !== this.solid) return;
      e.preventDefault();
      this.nearer(Math.exp(-e.deltaY / 500));
    }, { passive: false });
    this.root.addEventListener("keydown", (e) => { if (!e.ctrlKey && !e.metaKey) e.stopPropagation(); });
    this.keys(this.solid, (x, y) => this.turn(-x * STEP, -y * STEP), (sign) => this.nearer(1.15 ** sign));
    this.keys(this.slice, (x, y) => this.shift((x * 8) / this.scale, (y * 8) / this.scale), () => {});
    this.slider.addEventListener("input", () => { this.theta = this.slider.valueAsNumber; this.ask(); this.request(); });
  }

  keys(canvas, arrow, sign) {
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
    this.place = this.place.map((x, k) => clamp(x + [dx, dy][k], this.window[0][k], this.window[1][k]));
    this.ask();
    this.request();
  }

  ask() {                                // ask for the section, unless a question is open
    const { theta, place } = this.model.get("section");
    if (theta === this.theta && JSON.stringify(place) === JSON.stringify(this.place)) return;
    if (this.asked !== null && performance.now() - this.asked < WAIT) return;
    if (this.model.get("theta") === this.theta && JSON.stringify(this.model.get("place")) === JSON.stringify(this.place)) return;
    this.asked = performance.now();
    this.model.set({ theta: this.theta, place: this.place });
    this.model.save_changes();
  }

  request() {
    if (this.queued) return;
    this.queued = true;
    requestAnimationFrame(() => { this.queued = false; this.paint(); });
  }

  // painting

  pen(canvas) {
    const size = canvas.clientWidth || 400, sharp = devicePixelRatio || 1;
    if (canvas.width !== Math.round(size * sharp)) canvas.width = canvas.height = Math.round(size * sharp);
    const pen = canvas.getContext("2d");
    pen.setTransform(sharp, 0, 0, sharp, 0, 0);
    pen.clearRect(0, 0, size, size);
    pen.lineJoin = "round";
    return [pen, size];
  }

  projected([x, y, z], size) {           // right, up, and towards the reader, from unit-box coordinates
    const c = Math.cos(this.azimuth), s = Math.sin(this.azimuth), h = Math.sin(this.height), k = Math.cos(this.height);
    const right = -s * x + c * y, ahead = c * x + s * y, zoom = 0.27 * size * this.zoom;
    return [size / 2 + zoom * right, size / 2 - zoom * (k * z - h * ahead), k * ahead + h * z];
  }

  paint() {
    this.slider.value = this.theta;
    this.reading.textContent = `${degrees(this.theta)}°`;
    this.paintSolid();
    this.paintSlice();
    const values = { azimuth: degrees(this.azimuth), height: degrees(this.height), theta: degrees(this.theta) };
    this.solid.setAttribute("aria-label", fill(this.words.solid, values));
    this.slice.setAttribute("aria-label", fill(this.words.slice, values));
    const { text, theta } = this.model.get("section");
    if (this.text.textContent !== text) this.text.textContent = text;
    Object.assign(this.root.dataset, { paints: ++this.paints, theta, azimuth: this.azimuth, zoom: this.zoom });
  }

  paintSolid() {
    const [pen, size] = this.pen(this.solid), { unit, faces, colours } = this;
    const at = new Float32Array(unit.length);
    for (let i = 0; i < unit.length; i += 3) at.set(this.projected([unit[i], unit[i + 1], unit[i + 2]], size), i);
    const level = (this.theta - this.middle[2]) * this.scales[2], below = [], above = [];
    for (let f = 0; f < faces.length; f += 3) {
      const [a, b, c] = [3 * faces[f], 3 * faces[f + 1], 3 * faces[f + 2]];
      if ((at[b] - at[a]) * (at[c + 1] - at[a + 1]) - (at[b + 1] - at[a + 1]) * (at[c] - at[a]) >= 0) continue;    // back face
      const face = { a, b, c, f, depth: at[a + 2] + at[b + 2] + at[c + 2] };
      (unit[a + 2] + unit[b + 2] + unit[c + 2] > 3 * level ? above : below).push(face);
    }
    const triangles = (list, alpha) => {
      pen.globalAlpha = alpha;
      for (const { a, b, c, f } of list.sort((p, q) => p.depth - q.depth)) {
        pen.beginPath();
        pen.moveTo(at[a], at[a + 1]);
        pen.lineTo(at[b], at[b + 1]);
        pen.lineTo(at[c], at[c + 1]);
        pen.closePath();
        pen.fillStyle = pen.strokeStyle = `rgb(${colours[f]},${colours[f + 1]},${colours[f + 2]})`;
        pen.fill();
        if (alpha === 1) { pen.lineWidth = 0.7; pen.stroke(); }        // hides seams
      }
      pen.globalAlpha = 1;
    };
    const fromBelow = this.height < 0;
    if (fromBelow) triangles(above, GLASS); else triangles(below, 1);
    this.paintPlane(pen, size, level);
    if (fromBelow) triangles(below, 0.6); else triangles(above, GLASS);
  }

  paintPlane(pen, size, level) {
    const trace = (points) => points.forEach(([x, y], i) => {
      const flat = [0, 1].map((k) => ([x, y][k] - this.middle[k]) * this.scales[k]);
      pen[i ? "lineTo" : "moveTo"](...this.projected([...flat, level], size).slice(0, 2));
    });
    const [lo, hi] = this.box, m = [0, 1].map((k) => 0.06 * (hi[k] - lo[k]));
    pen.beginPath();
    trace([[lo[0] - m[0], lo[1] - m[1]], [hi[0] + m[0], lo[1] - m[1]], [hi[0] + m[0], hi[1] + m[1]], [lo[0] - m[0], hi[1] + m[1]]]);
    pen.closePath();
    pen.globalAlpha = 0.25;
    pen.fillStyle = this.palette.path;
    pen.fill();
    pen.globalAlpha = 1;
    pen.strokeStyle = this.palette.goal;
    pen.lineWidth = 1;
    pen.stroke();
    pen.lineWidth = 3;
    pen.beginPath();
    this.model.get("cut").forEach(trace);
    pen.stroke();
    if (this.place) {
      pen.fillStyle = this.palette.ink;
      pen.beginPath();
      const flat = [0, 1].map((k) => (this.place[k] - this.middle[k]) * this.scales[k]);
      pen.arc(...this.projected([...flat, level], size).slice(0, 2), 4.5, 0, 7);
      pen.fill();
    }
  }

  paintSlice() {
    const [pen, size] = this.pen(this.slice), [lo, hi] = this.box, { shapes, place } = this.model.get("section");
    const reach = 0.66 * Math.max(hi[0] - lo[0], hi[1] - lo[1]);
    this.window = [0, 1].map((side) => [0, 1].map((k) => this.middle[k] + (side ? reach : -reach)));
    this.scale = size / (2 * reach);
    const pixel = ([x, y]) => [(x - this.window[0][0]) * this.scale, size - (y - this.window[0][1]) * this.scale];
    for (const { points, fill: inner, line, alpha, closed } of shapes) {
      pen.beginPath();
      points.forEach((p, i) => pen[i ? "lineTo" : "moveTo"](...pixel(p)));
      if (closed) pen.closePath();
      if (inner && closed) { pen.globalAlpha = alpha; pen.fillStyle = this.palette[inner]; pen.fill(); pen.globalAlpha = 1; }
      if (line) { pen.strokeStyle = this.palette[line]; pen.lineWidth = 2; pen.stroke(); }
    }
    pen.strokeStyle = this.palette.goal;
    pen.lineWidth = 2.5;
    pen.beginPath();
    this.model.get("cut").forEach((line) => line.forEach((p, i) => pen[i ? "lineTo" : "moveTo"](...pixel(p))));
    pen.stroke();
    if (place) {
      pen.fillStyle = this.palette.ink;
      pen.beginPath();
      pen.arc(...pixel(place), 5, 0, 7);
      pen.fill();
    }
  }
}
