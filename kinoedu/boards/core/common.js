// What the scripts of all widgets use. It stands at the head of each, because each is one file.

const REST = 300;             // ms: what has not moved for this time is at rest
const THEMED = ["data-jp-theme-light", "data-theme", "class"];   // what a page says of its theme
const ICON = "favicon", SET_ASIDE = "kinoedu-icon";   // classes of JupyterLab's icons of its tab
const TOOL_BAR = ".jp-NotebookPanel-toolbar", LOOKS = "childItemsChanged";   // and its method

const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const fill = (words, values) => words.replace(/\{(\w+)\}/g, (_, name) => values[name]);

function make(tag, className, parent, attributes = {}) {
  const element = document.createElement(tag);
  element.className = className;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  parent?.append(element);
  return element;
}

// Write a text into an element, unless it is there: a page lays out anew what is written.
function write(element, text) { if (element.textContent !== text) element.textContent = text; }

// Call `dress` with the theme of the page, "light" or "dark", now and at each change, until the
// returned function is called. board.css knows the theme. Paper is light; before a page is printed
// `paint` is called too, because no frame comes in between.
function followTheme(dress, paint) {
  const tell = () => {                   // by the body: the widget may not be in the page yet
    dress(getComputedStyle(document.body).getPropertyValue("--kinoedu-theme").trim());
  };
  const print = () => { dress("light"); paint(); };
  const body = new MutationObserver(tell);
  const media = ["(prefers-color-scheme: dark)", "print"].map((query) => matchMedia(query));
  body.observe(document.body, { attributeFilter: THEMED });
  media.forEach((query) => query.addEventListener("change", tell));
  addEventListener("beforeprint", print);
  addEventListener("afterprint", tell);
  tell();
  return () => {
    body.disconnect();
    media.forEach((query) => query.removeEventListener("change", tell));
    removeEventListener("beforeprint", print);
    removeEventListener("afterprint", tell);
  };
}

// Call `paint` whenever the page gets more or fewer pixels, as by the browser's zoom, until the
// returned function is called.
function followPixels(paint) {
  let pixels = null;
  const wait = () => {                   // for the next change: a query is of one ratio only
    pixels = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    pixels.addEventListener("change", tell, { once: true });
  };
  const tell = () => { paint(); wait(); };
  wait();
  return () => pixels.removeEventListener("change", tell);
}

// JupyterLab shows twice for each question that the kernel works: it fetches another icon for its
// tab (a quarter of what a drag cost), and looks through its tool bar when the sign there changes
// (a sixth). While questions are asked it finds no icons, and looks through the tool bar later.
function keepStill() {
  const rename = (from, to) => {
    document.querySelectorAll(`link.${from}`).forEach((icon) => icon.classList.replace(from, to));
  };
  const bars = () => document.querySelectorAll(TOOL_BAR);
  rename(ICON, SET_ASIDE);
  bars().forEach((bar) => { bar[LOOKS] = () => {}; });
  clearTimeout(keepStill.ending);
  keepStill.ending = setTimeout(() => {
    rename(SET_ASIDE, ICON);
    bars().forEach((bar) => {
      delete bar[LOOKS];                 // its own is there again
      bar[LOOKS]?.();
    });
  }, REST);
}
