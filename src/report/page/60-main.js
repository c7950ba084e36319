// Controls and keys, and the first picture.
"use strict";

const FLICKER_MS = 600;
let timer = 0;

/** Brings the controls and the stage to what `state` says. */
function show() {
  for (const button of document.querySelectorAll("[data-layout]"))
    button.setAttribute("aria-pressed", String(button.dataset.layout === state.layout));
  byId("left").value = String(state.left);
  byId("right").value = String(state.right);
  byId("show").value = state.show;
  byId("exposure").value = String(state.exposure);
  byId("exposure-value").textContent = `${state.exposure > 0 ? "+" : ""}${shortNumber(state.exposure)} EV`;
  byId("timer").setAttribute("aria-pressed", String(state.timed));
  paintLegend(state.show, state.exposure);
  arrange();
}

function change(values) {
  Object.assign(state, values);
  show();
}

/** The two sides are never the same picture: the other one moves out of the way. */
function setSide(side, number) {
  const other = side === "left" ? "right" : "left";
  change({ [other]: state[other] === number ? state[side] : state[other], [side]: number });
}

const setExposure = (stops) => change({ exposure: Math.min(Math.max(stops, -12), 12) });
const swapSides = () => change({ left: state.right, right: state.left });

function flick() {
  if (state.layout !== "flicker") state.layout = "flicker";
  state.flickerRight = !state.flickerRight;
  show();
}

function setTimed(timed) {
  clearInterval(timer);
  if (timed) timer = setInterval(flick, FLICKER_MS);
  change({ timed, layout: timed ? "flicker" : state.layout });
}

function setLayout(layout) {
  state.layout = layout;
  setTimed(state.timed && layout === "flicker");
}

function reset() {
  setTimed(false);
  Object.assign(state, { split: 0.5, zoom: 0, x: size.width / 2, y: size.height / 2 });
  change({ layout: "split", show: "picture", exposure: 0, left: 0, right: 1 });
}

function step(by) {
  const count = pictures.length;
  let next = (state.right + by + count) % count;
  if (next === state.left) next = (next + by + count) % count;
  setSide("right", next);
}

/** Keys, what they do, and what the help says of them. */
const KEYS = [
  ["s", "split view", () => setLayout("split")],
  ["f", "flicker view", () => setLayout("flicker")],
  ["a", "all pictures", () => setLayout("all")],
  [" ", "flicker once", flick],
  ["t", "flicker by itself, or stop", () => setTimed(!state.timed)],
  ["x", "swap left and right", swapSides],
  ["]", "next picture on the right", () => step(1)],
  ["[", "previous picture on the right", () => step(-1)],
  [",", "split further left", () => setSplit(state.split - 0.02)],
  [".", "split further right", () => setSplit(state.split + 0.02)],
  ["e", "exposure half a stop up", () => setExposure(state.exposure + 0.5)],
  ["w", "exposure half a stop down", () => setExposure(state.exposure - 0.5)],
  ["+", "zoom in", () => zoomBy(Math.SQRT2)],
  ["-", "zoom out", () => zoomBy(Math.SQRT1_2)],
  ["z", "whole picture, or pixel for pixel", toggleFit],
  ["ArrowLeft", "move", () => panBy(40, 0)],
  ["ArrowRight", "move", () => panBy(-40, 0)],
  ["ArrowUp", "move", () => panBy(0, 40)],
  ["ArrowDown", "move", () => panBy(0, -40)],
  ["p", "show the picture", () => change({ show: "picture" })],
  ["l", "show luminance", () => change({ show: "luminance" })],
  ["d", "show the relative error", () => change({ show: "relative" })],
  ["g", "show the signed error", () => change({ show: "signed" })],
  ["v", "show FLIP", () => change({ show: "flip" })],
  ["c", "copy the table", copyTable],
  ["r", "all as at first", reset],
  ["?", "this help", () => byId("help").showModal()],
];

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || byId("help").open) return;
  const { target } = event;
  const arrow = event.key.startsWith("Arrow");
  if (target.matches("select") || (arrow && target.matches("input, .scroll"))) return;
  if (event.key === " " && target.matches("button, summary")) return;
  if (target.id === "divider" && (event.key === "ArrowLeft" || event.key === "ArrowRight")) {
    setSplit(state.split + (event.key === "ArrowLeft" ? -0.02 : 0.02));
  } else if (/^[0-9]$/.test(event.key)) {
    if (Number(event.key) < pictures.length) setSide("right", Number(event.key));
  } else {
    // Arrows scroll the page unless the pictures have the focus.
    if (arrow && target !== stage) return;
    const row = KEYS.find(([key]) => key === event.key);
    if (!row) return;
    row[2]();
  }
  event.preventDefault();
}

function listKeys() {
  const rows = KEYS.filter(([key]) => !key.startsWith("Arrow")).map(([key, what]) => [key === " " ? "Space" : key, what]);
  rows.push(["0 … 9", "that picture on the right, 0 the reference"]);
  rows.push(["arrows", "move (pictures focused), move the border (border focused)"]);
  for (const [key, what] of rows) {
    make("dt", "", byId("keys")).textContent = key;
    make("dd", "", byId("keys")).textContent = what;
  }
}

function connect() {
  for (const picture of pictures)
    for (const side of ["left", "right"])
      byId(side).add(new Option(picture.label, String(picture.number)));
  for (const side of ["left", "right"])
    byId(side).addEventListener("change", (event) => setSide(side, Number(event.target.value)));
  for (const button of document.querySelectorAll("[data-layout]"))
    button.addEventListener("click", () => setLayout(button.dataset.layout));
  byId("swap").addEventListener("click", swapSides);
  byId("show").addEventListener("change", (event) => change({ show: event.target.value }));
  byId("exposure").addEventListener("input", (event) => setExposure(Number(event.target.value)));
  byId("zoom-in").addEventListener("click", () => zoomBy(Math.SQRT2));
  byId("zoom-out").addEventListener("click", () => zoomBy(Math.SQRT1_2));
  byId("zoom-fit").addEventListener("click", toggleFit);
  byId("timer").addEventListener("click", () => setTimed(!state.timed));
  byId("copy").addEventListener("click", copyTable);
  byId("help-open").addEventListener("click", () => byId("help").showModal());
  document.addEventListener("keydown", onKey);
  new ResizeObserver(arrange).observe(stage);
}

byId("subtitle").textContent =
  `${numbers.pictures.map((p) => p.label).join(", ")} against ${numbers.reference.label}, ${size.width} × ${size.height}`;
document.title = `${byId("subtitle").textContent} – Sunfleck`;
listKeys();
connect();
buildTable();
buildCurves();
show();
