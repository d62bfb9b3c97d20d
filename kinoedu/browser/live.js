// Boards that answer in the page: a worker plans from the scene, with the functions that a lesson's
// board calls, compiled to WebAssembly. This is what the page does with its numbers: it makes the
// drawing that Python would send, and says it in the same words.
//
// The page's script begins with `LIVE`, what kinoedu/browser/bodies.py says of the bodies, and
// `WORKER`, the text of worker.js. A body's module is a script beside this one, which is loaded
// when a board first needs it. So pages work from a disk too, where nothing else may be loaded.

const HERE = document.currentScript?.src ?? "";
// the status of a fault, as in kinoedu/browser/scenes.py
const START_NOT_FREE = -1, GOAL_NOT_FREE = -2, RING_FAULT = -3, REFUSED = -20;
// how many points begin a row of each kind, and how many columns are in the unit of the world
const POINTS_OF = {
  edges: 2, path: 1, dots: 1, arrows: 1, labels: 1, cells: 4, nodes: 1, bodies: 50,
};
const COLUMNS_OF = {
  edges: 4, path: 2, dots: 2, arrows: 4, labels: 2, cells: 8, nodes: 2, bodies: 100,
};

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
  made.onerror = ({ message }) => {      // it has ended, as where a module gets no memory
    made.onmessage = null;
    made.terminate();
    worker = null;
    modules.clear();
    heard.forEach(({ reject }) => reject(new Error(message)));
    heard.clear();
  };
  return made;
}

// Load a body's module once and hand it to the worker. What failed is tried again when it is asked
// for again: a telephone may have lost its network.
function load(name) {
  if (!modules.has(name)) {
    const loading = script(`live/${name}.js`).then(() => {
      worker ??= startWorker();
      const { fields } = LIVE.bodies[name], module = bytesOf(globalThis.kinoeduModules[name]);
      worker.postMessage({ name, module, fields });
    });
    loading.catch(() => modules.delete(name));
    modules.set(name, loading);
  }
  return modules.get(name);
}

function script(file) {
  return new Promise((resolve, reject) => {
    const element = document.createElement("script");
    element.src = new URL(file, HERE);
    element.onload = resolve;
    element.onerror = () => reject(new Error(`${file} did not load`));
    document.head.append(element);
  });
}

// The scene that a body takes: the things on the board, and the handles of a picture beside it.
function sceneOf({ scene, live: { beside = [] } }) {
  return copy({ ...scene, handles: [...scene.handles, ...beside] });
}

// The answers to a board: each from the scene as it is when a page asks. Where the body has a
// picture beside the board, both pictures get each answer.
class Answers {
  constructor(record, key, tell) {
    const { live: { body, seed, settings }, scene, bitmap, step = null } = record;
    this.scene = sceneOf(record);
    this.own = scene.handles.length;      // the number of its own handles
    this.free = scene.size ? cellsOf(bytesOf(bitmap), scene.size) : undefined;
    // only Python knows whether a challenge is met; the page keeps its sentence
    this.challenges = (record.drawing.challenges ?? []).map(
      ({ sentence }) => ({ sentence, now: false, done: false, text: WORDS.unjudged }));
    Object.assign(this, { body, seed, settings, key, tell, step, beside: null, share: null });
  }

  take({ from, seq, moved }) {            // things were moved: answer the page that asks
    move(this.scene, moved);
    return this.answer(from, seq);
  }

  takeBeside({ from, seq, moved }) {      // the same in the picture beside
    move(this.scene, moved.map(([kind, i, where]) => [kind, i + this.own, where]));
    return this.answer(from, seq, true);
  }

  async answer(to = null, seq = null, asksBeside = false) {
    if (this.share) this.share.textContent = WORDS.share;   // the address has what was before
    const { body: name, seed, free } = this, given = this.settings[name];
    const settings = this.settings[given] ?? given;     // those of another body, or its own
    const scene = copy(this.scene);
    let drawing, second = null;
    try {
      await load(name);
      const shown = await ask({ name, scene, free, settings, seed }), body = LIVE.bodies[name];
      drawing = drawn(body, scene, settings, shown);
      if (body.beside && !drawing.message.warning) {
        second = drawn({ ...body, ...body.beside }, this.beside.scene, settings, shown);
      }
    } catch (error) {
      drawing = warned(said("live.failed", { error: error.message }));
    }
    if (name !== this.body) {            // another was chosen while the module of this one came
      (asksBeside ? this.beside : this).tell({ kind: "skipped", to, seq });
      return;
    }
    move(this.scene, drawing.message.places);
    const { message, buffers } = drawing, { total } = message;
    const first = this.step === null ? null : Math.min(this.step, total);  // of a link
    const own = asksBeside ? [null, null] : [to, seq];
    if (second) this.showBeside(second, asksBeside ? [to, seq] : [null, null]);
    else if (asksBeside) this.beside.tell({ kind: "skipped", to, seq });
    const { challenges } = this;
    const about = { kind: "drawing", to: own[0], seq: own[1], challenges, first };
    this.tell({ ...message, ...about }, buffers);
  }

  showBeside({ message, buffers, image }, [to, seq]) {
    const { own, beside: { under, tell, lay } } = this, count = message.places.length;
    if (image) lay(Uint8Array.from(image));
    for (const [kind, i, at] of message.places) {
      move(this.scene, [[kind, own + i, at], [kind, own + count + i, at]]);
    }
    const { drawing: { layers }, buffers: below } = under;
    const beneath = below.map((text) => new DataView(bytesOf(text).buffer));
    const drawing = { ...message, layers: [...layers, ...message.layers], first: null };
    tell({ kind: "drawing", to, seq, ...drawing }, [...beneath, ...buffers]);
  }
}

// The cells of a bitmap, one bit each, as the worker takes them.
function cellsOf(bits, shape) {
  return [Uint8Array.from({ length: shape[0] * shape[1] },
    (_, k) => (bits[k >> 3] >> (7 - (k & 7))) & 1), shape];
}

function move(scene, places) {
  for (const [kind, i, where] of places) {
    scene[LISTS[kind]][i][kind === "polygon" ? "rings" : "at"] = where;
  }
}

// ---- a board in the address of its page, so that a teacher can send a world

const MARK = "#kinoedu=", SEEDS = 2 ** 32;

function linkTo({ key, body, seed, scene }) {
  const { step, drawing: { total } } = boards.get(key);
  const board = { version: VERSION, key, body, seed, places: placesOf(scene) };
  if (step < total) board.step = step;
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

// Whether a link has the things of a scene, and a planner and a seed of this page, and a step.
function fits({ version, body, seed, places, step = 0 }, record) {
  const form = (value) => JSON.stringify(value, (_, v) => (Number.isFinite(v) ? "number" : v));
  const formOf = (parts) => parts.map(([kind, i, where]) => `${kind} ${i} ${form(where)}`).join();
  return version === VERSION && Object.hasOwn(record.live.settings, body)
    && Number.isInteger(seed) && seed >= 0 && seed < SEEDS && Number.isInteger(step) && step >= 0
    && Array.isArray(places) && places.every(Array.isArray)
    && formOf(places) === formOf(placesOf(sceneOf(record)));
}

// Arrange a record as the page's address says, if that names it. A link that does not fit leaves
// the record as it was, and says so.
function arranged(record, key) {
  const link = linked();
  if (!isLive(record) || !record.live.settings || !link || (link.key ?? key) !== key) return record;
  if (!fits(link, record)) return { ...record, warning: said("live.bad_link", {}) };
  const scene = sceneOf(record), { body, seed, step = null } = link;
  move(scene, link.places);
  const own = record.scene.handles.length, beside = scene.handles.splice(own);
  return { ...record, scene, step, live: { ...record.live, body, seed, beside }, moved: true };
}

// A choice of what answers, a button for another seed where that is random, and one that puts the
// board into the address.
function controlsOf(answers) {
  const row = document.createElement("div");
  row.className = "kinoedu-live";
  const names = Object.keys(answers.settings).filter((name) => name in LIVE.bodies);
  if (names.length > 1) row.append(menuOf(answers, names));
  if (names.some((name) => LIVE.bodies[name].random)) {
    row.append(button(WORDS.seed, () => {
      answers.seed = (answers.seed + 1) % SEEDS;
      answers.answer();
    }));
  }
  answers.share = button(WORDS.share, () => {
    history.replaceState(null, "", linkTo(answers));
    navigator.clipboard?.writeText(location.href).catch(() => {});
    answers.share.textContent = WORDS.shared;
  });
  row.append(answers.share);
  return row;
}

function menuOf(answers, names) {
  const menu = document.createElement("select");
  names.forEach((name) => menu.add(new Option(LIVE.bodies[name].title, name)));
  menu.value = answers.body;
  menu.setAttribute("aria-label", LIVE.bodies[answers.body].menu);
  menu.addEventListener("change", () => { answers.body = menu.value; answers.answer(); });
  return menu;
}

function button(text, press) {
  const made = document.createElement("button");
  made.textContent = text;
  made.addEventListener("click", press);
  return made;
}

// ---- drawings, as kinoedu/boards/core/shown.py makes and drawing.py encodes them

function drawn(body, scene, settings, { facts: [status, ...facts], layers, took }) {
  if (status <= REFUSED) return warned(fill(body.warns[REFUSED - status], { q: pair(facts) }));
  if (status < 0) return warned(faultOf(body, scene, settings, [status, ...facts]));
  const values = Object.fromEntries(body.facts.map(([name], k) => [name, facts[k]]));
  const spoken = body.facts.filter(([, form]) => form);
  const texts = Object.fromEntries(
    spoken.map(([name, form]) => [name, inForm(values[name], form)]));
  const total = values.total ?? 0, message = [], buffers = [], places = [], steps = [];
  let image = null;
  for (const look of body.layers) {
    const rows = rowsOf(layers[look.field]);
    if (look.kind === "handles") {
      places.push(...rows.map(([number, ...at]) => ["handle", number, at]));
    } else if (look.kind === "texts") {
      steps.push(...rows.map((row) => textOf(look, row)));
    } else if (look.kind === "image") {
      image = layers[look.field].numbers;
    } else if (look.kind === "list") {
      texts[look.field] = rows.map((row) => textOf(look, row)).join(", ");
    } else if (rows.length > 0) {
      message.push(encoded(look, rows, values));
      buffers.push(bufferOf(look, rows, scene));
    }
  }
  const text = fill(body.says[values[body.chosen] ?? status], texts), { unit } = body;
  const about = { text, total, unit, step_texts: steps, places, took };
  return { message: { ...PLAIN, layers: message, ...about }, buffers, image };
}

function textOf({ says, names }, row) {
  const forms = names.map((name) => name.split(":"));
  return fill(says[says.length > 1 ? row[0] : 0],
    Object.fromEntries(forms.map(([name, form], k) => [name, inForm(row[k], form)])));
}

const rowsOf = ({ numbers, shape: [count, columns] }) => Array.from({ length: count },
  (_, k) => [...numbers.subarray(columns * k, columns * (k + 1))]);

function encoded(look, rows, values) {
  const { kind, colour, width, dash, grows, ends, form, says, names, hatched } = look;
  const count = width === "line" ? values.total : rows.length;
  const size = SIZES[width]?.(count) ?? values[width] ?? width;
  const path = kind === "path";
  const worded = (row) => (says.length ? textOf(look, row.slice(2)) : inForm(row[2], form));
  const texts = kind === "labels" ? rows.map(worded) : [];
  return {
    kind, colour, width: size, dash, grows, ends, last: path, casing: path, texts,
    points: POINTS_OF[kind], hatched,
    ...(says.length && kind !== "labels" ? { says, names } : {}),
  };
}

// Rows with their points as parts of the world's size from its corner.
function bufferOf({ kind, grows }, rows, { lo, hi }) {
  const size = Math.max(hi[0] - lo[0], hi[1] - lo[1]);
  const points = 2 * POINTS_OF[kind], columns = COLUMNS_OF[kind];
  const kept = (row) => (kind !== "labels" ? row
    : [...row.slice(0, columns), ...(grows ? row.slice(-1) : [])]);
  const scaled = rows.flatMap((row) => kept(row).map(
    (value, k) => (k < points ? (value - lo[k % 2]) / size : k < columns ? value / size : value)));
  return new DataView(Float32Array.from(scaled).buffer);
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

// ---- words

const said = (key, values) => fill(LIVE.words[key], values);

function faultOf(body, scene, settings, [status, ring, i, j]) {
  if (status <= RING_FAULT) {
    const item = scene.polygons[ring - 1] ?? { name: "boundary", rings: [scene.boundary] };
    const { name, rings: [points] } = item;
    const [a, b, c, d] = [i, i + 1, j, j + 1].map((k) => pair(points.at(k % points.length)));
    const fault = LIVE.faults[RING_FAULT - status];
    const key = fault === "repeats" && j === 0 ? "repeats_first" : fault;
    return said(`ring.${key}`, { name, i, j, a, b, c, d });
  }
  const q = scene.handles[START_NOT_FREE - status].at, { lo, hi } = scene;
  const clearance = settings[body.settings.indexOf("clearance")];
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

// A number as it is written, see `Body.facts` in kinoedu/browser/looks.py.
function inForm(value, form) {
  if (form === ",") return value.toLocaleString("en");
  if (form === "d") return String(value);
  if (form.endsWith("f")) return value.toFixed(parseInt(form.slice(1), 10));
  if (form.includes("|")) return `${form[value > 0 ? 0 : 2]}${Math.abs(value)}`;
  if (/^[A-Z]+$/.test(form)) {
    return [...String(value)].map((digit) => form[digit - 1] ?? "").join("") || "-";
  }
  return general(value, parseInt(form.slice(1), 10));
}

function general(x, digits) {            // as Python's format "g"
  const power = Math.floor(Math.log10(Math.abs(Number(x.toPrecision(digits)))));
  if (x !== 0 && (power < -4 || power >= digits)) {
    return padded(x.toExponential(digits - 1).replace(/\.?0+e/, "e"));
  }
  return String(Number(x.toPrecision(digits)));
}
