// The stage: which pictures stand where, and one place and zoom for all of them.
"use strict";

const stage = byId("stage");

/** All that the controls change. `zoom` is screen pixels a picture's pixel, 0 to fit; `x`, `y` are
 *  the picture's place in the middle of each cell. */
const state = {
  layout: "split", left: 0, right: 1, show: "picture", exposure: 0,
  split: 0.5, flickerRight: false, timed: false,
  zoom: 0, x: size.width / 2, y: size.height / 2, pointer: null,
};

function make(tag, className, parent) {
  const element = document.createElement(tag);
  element.className = className;
  parent.append(element);
  return element;
}

function addLayer(cell, picture, side) {
  const layer = make("div", "layer", cell);
  layer.append(paint(picture, state.show, state.exposure));
  make("span", `tag at-${side}`, layer).textContent = picture.label;
  return layer;
}

/** Rows and columns that leave each picture the largest. */
function gridOf(count) {
  const { clientWidth: width, clientHeight: height } = stage;
  let best = { zoom: 0, columns: 1 };
  for (let columns = 1; columns <= count; ++columns) {
    const rows = Math.ceil(count / columns);
    const zoom = Math.min(width / columns / size.width, height / rows / size.height);
    if (zoom > best.zoom) best = { zoom, columns };
  }
  return best.columns;
}

/** Builds the cells of the layout anew. */
function arrange() {
  const focused = document.activeElement.id;
  stage.replaceChildren();
  const columns = state.layout === "all" ? gridOf(pictures.length) : 1;
  stage.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
  stage.style.gridAutoRows = "minmax(0, 1fr)";
  if (state.layout === "all") {
    for (const picture of pictures) addLayer(make("div", "cell", stage), picture, "left");
  } else {
    const cell = make("div", "cell", stage);
    addLayer(cell, pictures[state.left], "left");
    addLayer(cell, pictures[state.right], "right").id = "upper";
    if (state.layout === "split") addDivider(cell);
    if (focused === "divider") byId("divider")?.focus();
  }
  place();
}

function addDivider(cell) {
  const divider = make("div", "", cell);
  divider.id = "divider";
  divider.tabIndex = 0;
  const about = { role: "slider", "aria-label": "Border between left and right", "aria-valuemin": 0, "aria-valuemax": 100 };
  for (const [name, value] of Object.entries(about)) divider.setAttribute(name, value);
  divider.addEventListener("pointerdown", (event) => {
    divider.setPointerCapture(event.pointerId);
    event.stopPropagation();
  });
  divider.addEventListener("pointermove", (event) => {
    if (!divider.hasPointerCapture(event.pointerId)) return;
    const box = stage.getBoundingClientRect();
    setSplit((event.clientX - box.left) / box.width);
  });
}

function setSplit(share) {
  state.split = Math.min(Math.max(share, 0), 1);
  place();
}

const cellSize = () => {
  const cell = stage.querySelector(".cell");
  return { width: cell.clientWidth, height: cell.clientHeight };
};

function zoomNow() {
  if (state.zoom > 0) return state.zoom;
  const cell = cellSize();
  return Math.min(cell.width / size.width, cell.height / size.height);
}

/** Puts what is there into its place: cheap, for every move. */
function place() {
  const zoom = zoomNow();
  const cell = cellSize();
  const left = cell.width / 2 - state.x * zoom;
  const top = cell.height / 2 - state.y * zoom;
  for (const canvas of stage.querySelectorAll("canvas")) {
    canvas.style.transform = `translate(${left}px, ${top}px) scale(${zoom})`;
    canvas.classList.toggle("sharp", zoom * devicePixelRatio >= 1.5);
  }
  const upper = byId("upper");
  if (state.layout === "split") {
    const percent = 100 * state.split;
    upper.style.clipPath = `inset(0 0 0 ${percent}%)`;
    byId("divider").style.left = `${percent}%`;
    byId("divider").setAttribute("aria-valuenow", Math.round(percent));
  } else if (state.layout === "flicker") {
    upper.style.visibility = state.flickerRight ? "visible" : "hidden";
    upper.previousElementSibling.style.visibility = state.flickerRight ? "hidden" : "visible";
  }
  byId("zoom-value").textContent = `${shortNumber(Number((100 * zoom).toPrecision(3)))}%`;
  readOut();
}

/** Zooms about a place of the screen, or the middle. @param factor 0 goes back to fit. */
function zoomBy(factor, clientX, clientY) {
  const before = zoomNow();
  if (factor === 0) {
    Object.assign(state, { zoom: 0, x: size.width / 2, y: size.height / 2 });
    return place();
  }
  const after = Math.min(Math.max(before * factor, 0.02), 64);
  if (clientX !== undefined) {
    const [dx, dy] = fromMiddle(clientX, clientY);
    state.x += dx / before - dx / after;
    state.y += dy / before - dy / after;
  }
  state.zoom = after;
  clampPlace();
  place();
}

/** The whole picture, or pixel for pixel. */
const toggleFit = () => (state.zoom === 0 ? zoomBy(1 / zoomNow()) : zoomBy(0));

/** Screen pixels from the middle of the cell that is there. */
function fromMiddle(clientX, clientY) {
  const cell = document.elementsFromPoint(clientX, clientY).find((e) => e.className === "cell") ?? stage.firstElementChild;
  const box = cell.getBoundingClientRect();
  return [clientX - box.left - box.width / 2, clientY - box.top - box.height / 2];
}

function clampPlace() {
  state.x = Math.min(Math.max(state.x, 0), size.width);
  state.y = Math.min(Math.max(state.y, 0), size.height);
}

/** @param dx, dy  screen pixels that the picture goes to the right and down. */
function panBy(dx, dy) {
  const zoom = zoomNow();
  state.zoom = zoom;
  state.x -= dx / zoom;
  state.y -= dy / zoom;
  clampPlace();
  place();
}

/** Values of the pixel under the cursor, or in the middle. */
function readOut() {
  const zoom = zoomNow();
  const [dx, dy] = state.pointer ? fromMiddle(...state.pointer) : [0, 0];
  const x = Math.floor(state.x + dx / zoom);
  const y = Math.floor(state.y + dy / zoom);
  const inside = x >= 0 && y >= 0 && x < size.width && y < size.height;
  const readout = byId("readout");
  readout.replaceChildren();
  make("span", "", readout).textContent = inside ? `x ${x}  y ${y}` : "outside";
  if (!inside) return;
  const shown = state.layout === "all" ? pictures : [pictures[state.left], pictures[state.right]];
  for (const picture of shown) {
    const rgb = valueAt(picture, y * size.width + x);
    const entry = make("span", "", readout);
    make("b", "", entry).textContent = picture.label;
    entry.append(` ${rgb.map(shortNumber).join(" ")}  Y ${shortNumber(luminanceOf(rgb))}`);
  }
}

onGestures(stage, {
  pan: panBy,
  zoom: zoomBy,
  hover(place) {
    state.pointer = place;
    readOut();
  },
  ignores: (target) => target.id === "divider",
});
