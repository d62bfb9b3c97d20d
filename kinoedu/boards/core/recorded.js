// Boards on a page without a kernel. Each element `.kinoedu-record` holds what a notebook stored of
// a board, and a picture of it. The picture gives place to the board, which can be played and
// scrubbed. It can be dragged where the page has the body that answers it: see live.js.
//
// The page's script begins with `WORDS`, `PALETTE`, `VERSION` (of records), `widget`, what board.js
// exports, and `LIVE`, the bodies that the page has. A record of another version keeps its picture.

const ARRIVING = 5000;        // ms in which the boards near a part of the page come

// A model as anywidget gives it. It answers "hello" with the recorded drawing, and a scene that was
// moved only where the board is live.
//
// main : the answers of the board beside it, where it is the second picture of a body.
function recordedModel(stored, key, team, main) {
  const heard = [], laid = [], record = arranged(stored, key);
  const values = {
    key, partner: team, scene: record.scene, home: stored.scene, palette: PALETTE, words: WORDS,
    bitmap: new DataView(bytesOf(record.bitmap).buffer), recorded: !isLive(record),
  };
  const tell = (message, buffers) => heard.forEach((hear) => hear(message, buffers));
  const isBeside = isLive(record) && !record.live.settings;
  const answers = isLive(record) && !isBeside ? new Answers(record, key, tell) : null;
  const lay = (bytes) => {
    values.bitmap = new DataView(bytes.buffer);
    laid.forEach((hear) => hear());
  };
  if (isBeside) main.beside = { scene: record.scene, under: record.live.under, tell, lay };
  const show = () => {
    if (record.moved) { answers.answer(); return; }
    const buffers = record.buffers.map((text) => new DataView(bytesOf(text).buffer));
    const { warning = record.drawing.warning } = record;   // that of a link that does not fit
    tell({ kind: "drawing", to: null, seq: null, ...record.drawing, warning }, buffers);
  };
  return {
    answers,
    get: (name) => values[name],
    on: (event, hear) => {
      if (event === "msg:custom") heard.push(hear);
      if (event === "change:bitmap") laid.push(hear);
    },
    send: (message) => {
      if (message.kind === "hello") queueMicrotask(show);
      if (message.kind === "scene" && isBeside) main.takeBeside(message);
      else if (message.kind === "scene") answers?.take(message);
    },
  };
}

const isLive = ({ live }) => Boolean(live && LIVE.bodies[live.body]);
const bytesOf = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));

async function unpacked({ boards }) {
  const packed = new Blob([bytesOf(boards)]).stream();
  return new Response(packed.pipeThrough(new DecompressionStream("deflate"))).json();
}

async function play(element, number) {
  const stored = JSON.parse(element.querySelector("script").textContent);
  if (stored.version !== VERSION) return;
  const records = await unpacked(stored);
  const row = document.createElement("div");
  row.className = "kinoedu-row";
  element.append(row);
  let main = null;
  records.forEach((record, k) => {
    const place = document.createElement("div");
    row.append(place);
    const model = recordedModel(record, `${number}-${k}`, `${number}-${record.team}`, main);
    main = model.answers ?? main;
    if (model.answers) place.append(controlsOf(model.answers));
    widget.initialize({ model });
    widget.render({ model, el: place });
  });
  element.classList.add("kinoedu-plays");
  const about = element.querySelector(".still"), grows = ({ drawing }) => drawing.total > 0;
  if (about && records.some(isLive)) about.textContent = WORDS.live;
  else if (about && records.some(grows)) about.textContent = WORDS.recorded;
}

// A board is unpacked when it comes near the screen.
function begin() {
  const elements = [...document.querySelectorAll(".kinoedu-record")];
  const seen = new IntersectionObserver((entries) => {
    for (const { target } of entries.filter((entry) => entry.isIntersecting)) {
      seen.unobserve(target);
      play(target, elements.indexOf(target));
    }
  }, { rootMargin: "600px" });
  elements.forEach((element) => seen.observe(element));
  // at once: a smooth scroll, as the site's style asks for, ends when more of the page comes
  elements[parseInt(linked()?.key, 10)]?.scrollIntoView({ behavior: "instant" });
  keepPlace();
}

// Boards take more or less room than their pictures. The part of the page that its address names
// stays in its place meanwhile, unless the reader does something.
function keepPlace() {
  const part = document.getElementById(location.hash.slice(1));
  if (!part) return;
  const grown = new ResizeObserver(() => part.scrollIntoView({ behavior: "instant" }));
  const end = () => grown.disconnect();
  document.querySelectorAll(".kinoedu-record").forEach((element) => grown.observe(element));
  ["wheel", "touchstart", "pointerdown", "keydown"].forEach(
    (event) => addEventListener(event, end, { once: true, passive: true }));
  setTimeout(end, ARRIVING);
}

// A link that is put into the address of an open page is followed too.
addEventListener("hashchange", () => {
  if (linked()) location.reload();
  else keepPlace();
});

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", begin);
else begin();
