// What the scripts of all widgets use. It stands at the head of each, because each is one file.

const REST = 300;             // ms: what has not moved for this time is at rest
const ICON = "favicon", SET_ASIDE = "kinoedu-icon";   // classes of JupyterLab's icons of its tab

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

// JupyterLab fetches another icon for its tab whenever the kernel begins or ends some work: twice
// for each question, a quarter of what a drag costs. While questions are asked it finds no icons.
function keepIcon() {
  const rename = (from, to) => {
    document.querySelectorAll(`link.${from}`).forEach((icon) => icon.classList.replace(from, to));
  };
  rename(ICON, SET_ASIDE);
  clearTimeout(keepIcon.ending);
  keepIcon.ending = setTimeout(() => rename(SET_ASIDE, ICON), REST);
}
