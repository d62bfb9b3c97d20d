// Boards that answer in the page: a worker plans from the scene, with the functions that a lesson's
// board calls, compiled to WebAssembly. This is what the page does with its numbers: it makes the
// drawing that Python would send, and says it in the same words.
//
// The page's script begins with `LIVE`, what kinoedu/browser/bodies.py says of the bodies, and
// `WORKER`, the text of worker.js. A body's module is a script beside this one, which is loaded
// when a board first needs it. So pages work from a disk too, where nothing else may be loaded.

const HERE = document.currentScript?.src ?? "";
const FOUND = 0, NOT_FOUND = 1, START_NOT_FREE = 2, GOAL_NOT_FREE = 3, RING_FAULT = 4;
const POINTS_OF = { edges: 2, path: 1, dots: 1 };

let worker = null, asked = 0;
const heard = new Map();                // what to do with the answer of each question
const modules = new Map();              // a promise for each body's module

function ask(question) {
  worker ??= startWorker();
  return new Promise((resolve, reject) => {
    asked += 1;
    heard.set(asked, { resolve, reject });
    worker.postMessage({ ...question, ask: asked });
  });
}

function startWorker() {
  const text = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
  const made = new Worker(text);
  made.onmessage = ({ data }) => {
    const { resolve, reject } = heard.get(data.ask);
    heard.delete(data.ask);
    if (!data.error) { resolve(data); return; }
    modules.delete(data.name);
    reject(new Error(data.error));
  };
  return made;
}

// Load a body's module once and hand it to the worker.
function load(name) {
  if (!modules.has(name)) {
    modules.set(name, script(`live/${name}.js`).then(() => {
      worker ??= startWorker();
      worker.postMessage({ name, module: bytesOf(globalThis.kinoeduModules[name]) });
    }));
  }
  return modules.get(name);
}

function script(file) {
  return new Promise((resolve, reject) => {
    const element = document.createElement("script");
    element.src = new URL(file, HERE);
    element.onload = resolve;
    element.onerror = () => reject(new Error(`${file} is not beside this page`));
    document.head.append(element);
  });
}

// The answers to a board: each from the scene as it is when a page asks.
class Answers {
  constructor({ body, seed, settings }, scene, key, tell) {
    this.scene = copy(scene);
    Object.assign(this, { body, seed, settings, key, tell });
  }

  take({ from, seq, moved }) {            // things were moved: answer the page that asks
    move(this.scene, moved);
    return this.answer(from, seq);
  }

  async answer(to = null, seq = null) {
    const { body: name, seed } = this, settings = this.settings[name];
    const scene = copy(this.scene);
    let drawing;
    try {
      await load(name);
      const shown = await ask({ name, scene, settings, seed });
      drawing = drawn(LIVE.bodies[name], scene, settings[0], shown);
    } catch (error) {
      drawing = warned(said("live.failed", { error: error.message }));
    }
    this.tell({ kind: "drawing", to, seq, ...drawing.message }, drawing.buffers);
  }
}

const LISTS = { handle: "handles", disc: "discs", polygon: "polygons" };

// The places of all things, each [kind, number, coordinates].
function placesOf(scene) {
  return Object.entries(LISTS).flatMap(([kind, list]) => scene[list].map(
    (item, i) => [kind, i, kind === "polygon" ? item.rings : item.at],
  ));
}

function move(scene, places) {
  for (const [kind, i, where] of places) {
    scene[LISTS[kind]][i][kind === "polygon" ? "rings" : "at"] = where;
  }
}

// ---- a board in the address of its page, so that a teacher can send a world

const MARK = "#kinoedu=";

function linkTo({ key, body, seed, scene }) {
  const board = { version: VERSION, key, body, seed, places: placesOf(scene) };
  return MARK + btoa(JSON.stringify(board)).replaceAll("+", "-").replaceAll("/", "_");
}

// The board of the page's address; null without one, {} for nonsense.
function linked() {
  if (!location.hash.startsWith(MARK)) return null;
  try {
    const text = location.hash.slice(MARK.length).replaceAll("-", "+").replaceAll("_", "/");
    return JSON.parse(atob(text)) ?? {};
  } catch {
    return {};
  }
}

// Whether a link has the things of a scene, and a planner and a seed of this page.
function fits({ version, body, seed, places }, scene) {
  const form = (value) => JSON.stringify(value, (_, v) => (Number.isFinite(v) ? "number" : v));
  const formOf = (parts) => parts.map(([kind, i, where]) => `${kind} ${i} ${form(where)}`).join();
  return version === VERSION && body in LIVE.bodies && Number.isInteger(seed) && seed >= 0
    && seed < 2 ** 32 && Array.isArray(places) && places.every(Array.isArray)
    && formOf(places) === formOf(placesOf(scene));
}

// Arrange a record as the page's address says, if that names it. A link that does not fit leaves
// the record as it was, and says so.
function arranged(record, key) {
  const link = linked();
  if (!isLive(record) || !link || (link.key ?? key) !== key) return record;
  if (!fits(link, record.scene)) return { ...record, warning: said("live.bad_link", {}) };
  const scene = copy(record.scene), { body, seed } = link;
  move(scene, link.places);
  return { ...record, scene, live: { ...record.live, body, seed }, moved: true };
}

// A choice of planners, a button for another seed, and one that puts the board into the address.
function controlsOf(answers) {
  const row = document.createElement("div"), menu = document.createElement("select");
  const planners = Object.entries(LIVE.bodies);
  planners.forEach(([name, { planner }]) => menu.add(new Option(planner, name)));
  menu.value = answers.body;
  menu.setAttribute("aria-label", LIVE.words["board.planner"]);
  menu.addEventListener("change", () => { answers.body = menu.value; answers.answer(); });
  const again = document.createElement("button");
  again.textContent = WORDS.seed;
  again.addEventListener("click", () => { answers.seed += 1; answers.answer(); });
  const share = document.createElement("button");
  share.textContent = WORDS.share;
  share.addEventListener("click", () => {
    history.replaceState(null, "", linkTo(answers));
    navigator.clipboard?.writeText(location.href).catch(() => {});
    share.textContent = WORDS.shared;
  });
  row.className = "kinoedu-live";
  row.append(menu, again, share);
  return row;
}

// ---- drawings, as kinoedu/boards/core/drawing.py encodes them

function drawn(body, scene, clearance, { facts, layers, took }) {
  if (facts[0] > NOT_FOUND) return warned(faultOf(scene, clearance, facts));
  const steps = facts[2], message = [], buffers = [];
  for (const { field, kind, colour, width, grows, says, names } of body.layers) {
    const { numbers, shape: [count, columns] } = layers[field];
    if (count === 0) continue;
    const size = SIZES[width]?.(width === "line" ? steps : count) ?? width;
    const path = kind === "path";
    message.push({
      kind, colour, width: size, dash: [], grows, ends: false, last: path, casing: path, texts: [],
      points: POINTS_OF[kind], hatched: false, ...(says.length ? { says, names } : {}),
    });
    buffers.push(new DataView(scaled(numbers, columns, POINTS_OF[kind], scene).buffer));
  }
  const text = textOf(body, facts), unit = LIVE.words[body.unit];
  return { message: { ...PLAIN, layers: message, text, total: steps, unit, took }, buffers };
}

// Sizes that fall with the number of lines or dots, as in kinoedu/figures/drawing.py.
const SIZES = {
  line: (n) => clamp(2 - 0.4 * Math.log10(Math.max(n, 1)), 0.5, 1.6),
  dot: (n) => clamp(9 - 2 * Math.log10(Math.max(n, 1)), 1.5, 8) / 2,
};
const PLAIN = {
  layers: [], text: "", warning: "", total: 0, unit: "", step_texts: [], listing: null, first: null,
  places: [], took: 0,
};
const warned = (warning) => ({ message: { ...PLAIN, warning }, buffers: [] });

// Rows with their points as parts of the world's size from its corner.
function scaled(numbers, columns, points, { lo, hi }) {
  const size = Math.max(hi[0] - lo[0], hi[1] - lo[1]);
  return Float32Array.from(numbers, (value, k) => {
    const column = k % columns;
    return column < 2 * points ? (value - lo[column % 2]) / size : value;
  });
}

// ---- words

const said = (key, values) => fill(LIVE.words[key], values);
const counted = (n) => n.toLocaleString("en");

function textOf(body, [status, cost, steps, iterations, nodes, reason]) {
  const { planner } = body;
  if (status === FOUND) {
    const unit = LIVE.words[body.unit];
    return said("figure.path", { planner, length: general(cost, 4), total: counted(steps), unit });
  }
  const values = { iterations: counted(iterations), nodes: counted(nodes) };
  return said("figure.no_path", { planner, reason: said(body.reasons[reason], values) });
}

function faultOf(scene, clearance, [status, ring, i, j]) {
  if (status >= RING_FAULT) {
    const points = [scene.boundary, ...scene.polygons.map(({ rings }) => rings[0])][ring];
    const name = ring === 0 ? "boundary" : `obstacle ${ring - 1}`;
    const [a, b, c, d] = [i, i + 1, j, j + 1].map((k) => pair(points.at(k % points.length)));
    const fault = LIVE.faults[status - RING_FAULT];
    const key = fault === "repeats" && j === 0 ? "repeats_first" : fault;
    return said(`ring.${key}`, { name, i, j, a, b, c, d });
  }
  const q = scene.handles[status - START_NOT_FREE].at, { lo, hi } = scene;
  const margin = clearance ? said("not_free.margin", { clearance: general(clearance, 6) }) : "";
  const outside = q.some((x, k) => x <= lo[k] || x >= hi[k]);
  const why = said(outside ? "not_free.outside" : "not_free.touches",
    { lo: pair(lo), hi: pair(hi), margin });
  return said(status === START_NOT_FREE ? "not_free.start" : "not_free.goal", { q: pair(q), why });
}

// Numbers as Python writes them.
const pair = ([x, y]) => `(${spelled(x)}, ${spelled(y)})`;
const spelled = (x) => (Number.isInteger(x) && Math.abs(x) < 1e16 ? `${x}.0` : padded(String(x)));
const padded = (text) => text.replace(/e([+-])(\d)$/, "e$10$2");

function general(x, digits) {            // as Python's format "g"
  const power = Math.floor(Math.log10(Math.abs(Number(x.toPrecision(digits)))));
  if (x !== 0 && (power < -4 || power >= digits)) {
    return padded(x.toExponential(digits - 1).replace(/\.?0+e/, "e"));
  }
  return String(Number(x.toPrecision(digits)));
}
