// Shows one slide at a time, as large as the window allows. `SLIDE_WORDS` stands before this.
(() => {
  const slides = [...document.querySelectorAll("section")];
  const byId = (id) => document.getElementById(id);
  let at = 0, hasNotes = false, speaker = null;

  // The size of the window. On a telephone `innerWidth` is that of a slide that is still too wide.
  function sizeOfWindow() {
    const { clientWidth, clientHeight } = document.documentElement;
    return Math.min(clientWidth / 1280, clientHeight / 720);
  }

  // A slide gets the size of the window. One whose content is too high is made smaller, until it
  // fits.
  function fit(slide = slides[at], size = sizeOfWindow()) {
    const box = slide.querySelector(".slide"), row = box.querySelector(".row");
    box.style.zoom = size;
    let small = 1;
    row.style.zoom = small;
    const isTooLarge = () => row.scrollHeight > row.clientHeight + 1
      || [...row.children].some((part) => part.scrollWidth > part.clientWidth + 1);
    while (small > 0.5 && isTooLarge()) {
      small -= 0.05;
      row.style.zoom = small;
    }
  }

  function show(number) {
    at = Math.max(0, Math.min(slides.length - 1, number));
    slides.forEach((slide, k) => { slide.hidden = k !== at; });
    slides[at].querySelector("aside").hidden = !hasNotes;
    byId("place").textContent = SLIDE_WORDS.place
      .replace("{number}", at + 1).replace("{count}", slides.length);
    history.replaceState(null, "", `#${at + 1}`);
    fit();
    tell();
  }

  // On paper each slide has the size of its sheet, also those that have not been shown yet.
  function fitPaper() {
    for (const slide of slides) {
      const { hidden } = slide;
      slide.hidden = false;              // else it has no size
      fit(slide, 1);
      slide.hidden = hidden;
    }
  }

  const notesOf = (slide) => slide.querySelector("aside").innerHTML || SLIDE_WORDS.no_notes;

  // The speaker's own window repeats title and notes.
  function tell() {
    if (!speaker || speaker.closed) return;
    const title = slides[at].querySelector("h1, h2").innerHTML;
    speaker.document.body.innerHTML =
      `<p>${byId("place").textContent}</p><h2>${title}</h2>${notesOf(slides[at])}`;
  }

  function openWindow() {
    speaker = window.open("", "kinoedu-notes", "width=700,height=800");
    if (!speaker) return;
    speaker.document.title = SLIDE_WORDS.notes;
    speaker.document.body.style.font = "22px/1.4 system-ui, sans-serif";
    speaker.document.onkeydown = onKey;
    tell();
  }

  function toggleNotes() {
    hasNotes = !hasNotes;
    const aside = slides[at].querySelector("aside");
    if (!aside.innerHTML) aside.textContent = SLIDE_WORDS.no_notes;
    aside.hidden = !hasNotes;
  }

  const keys = {
    ArrowRight: () => show(at + 1), PageDown: () => show(at + 1), " ": () => show(at + 1),
    ArrowLeft: () => show(at - 1), PageUp: () => show(at - 1),
    Home: () => show(0), End: () => show(slides.length - 1),
    n: toggleNotes, N: toggleNotes, w: openWindow, W: openWindow,
  };

  // Keys belong to a control that has the focus; those of the slides' own buttons do not need any.
  function onKey(event) {
    const busy = event.target.closest?.(".kinoedu-board, summary, input, select, nav button");
    const mine = keys[event.key];
    const typed = busy && !["PageDown", "PageUp"].includes(event.key);
    if (!mine || typed || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    mine();
  }

  let touched = null;
  addEventListener("touchstart", (event) => {
    const zooms = event.touches.length > 1 || visualViewport.scale > 1;
    touched = zooms || event.target.closest(".kinoedu-board") ? null : event.touches[0].clientX;
  });
  addEventListener("touchend", (event) => {
    const way = touched === null ? 0 : event.changedTouches[0].clientX - touched;
    if (Math.abs(way) > 60) show(at - Math.sign(way));
  });
  document.body.classList.add("deck");
  document.addEventListener("keydown", onKey);
  byId("previous").onclick = () => show(at - 1);
  byId("next").onclick = () => show(at + 1);
  byId("notes").onclick = toggleNotes;
  byId("window").onclick = openWindow;
  addEventListener("resize", () => fit());
  document.addEventListener("toggle", () => fit(), true);   // code or an answer was opened
  addEventListener("beforeprint", fitPaper);
  addEventListener("afterprint", () => fit());
  addEventListener("hashchange", () => show(Number(location.hash.slice(1)) - 1 || 0));
  new MutationObserver(() => setTimeout(fit, 50)).observe(
    document.querySelector("main"), { childList: true, subtree: true });
  show(Number(location.hash.slice(1)) - 1 || 0);
})();
