// Where the picture stands: one place and zoom. Before the first pass it has fewer pixels, and
// fills the same room.
"use strict";

const stage = byId("stage");

/** `zoom` is screen pixels a pixel of the whole picture, 0 to fit; x, y: the place in the middle;
 *  `pointer`: where the mouse is. */
const view = { width: 1, height: 1, zoom: 0, x: 0.5, y: 0.5, pointer: null };

function setSize(width, height) {
  if (!width || (view.width === width && view.height === height)) return;
  Object.assign(view, { width, height, zoom: 0, x: width / 2, y: height / 2 });
  place();
}

const zoomNow = () =>
  view.zoom > 0 ? view.zoom : Math.min(stage.clientWidth / view.width, stage.clientHeight / view.height);

/** Puts the canvas into its place: cheap, for every move. */
function place() {
  const zoom = zoomNow();
  const left = stage.clientWidth / 2 - view.x * zoom;
  const top = stage.clientHeight / 2 - view.y * zoom;
  const larger = view.width / canvas.width; // than a pixel of the canvas
  const taller = view.height / canvas.height;
  canvas.style.transform = `translate(${left}px, ${top}px) scale(${zoom * larger}, ${zoom * taller})`;
  canvas.classList.toggle("sharp", larger === 1 && zoom * devicePixelRatio >= 1.5);
  byId("zoom-value").textContent = `${shortNumber(Number((100 * zoom).toPrecision(3)))}%`;
  readOut();
}

const within = (value, low, high) => Math.min(Math.max(value, low), high);

/** Screen pixels from the middle of the stage. */
function fromMiddle(clientX, clientY) {
  const box = stage.getBoundingClientRect();
  return [clientX - box.left - box.width / 2, clientY - box.top - box.height / 2];
}

/** Zooms about a place of the screen, or the middle. */
function zoomTo(zoom, clientX, clientY) {
  const before = zoomNow();
  const after = within(zoom, 0.02, 64);
  const [dx, dy] = clientX === undefined ? [0, 0] : fromMiddle(clientX, clientY);
  view.zoom = after;
  view.x = within(view.x + dx / before - dx / after, 0, view.width);
  view.y = within(view.y + dy / before - dy / after, 0, view.height);
  place();
}

function fit() {
  Object.assign(view, { zoom: 0, x: view.width / 2, y: view.height / 2 });
  place();
}

/** @param dx, dy  screen pixels that the picture goes to the right and down. */
function panBy(dx, dy) {
  const zoom = zoomNow();
  view.zoom = zoom;
  view.x = within(view.x - dx / zoom, 0, view.width);
  view.y = within(view.y - dy / zoom, 0, view.height);
  place();
}

/** The numbers of the pixel under the mouse, or in the middle. */
function readOut() {
  const readout = byId("readout");
  if (shown.number === 0) return;
  const zoom = zoomNow();
  const [dx, dy] = view.pointer ? fromMiddle(...view.pointer) : [0, 0];
  const x = Math.floor(view.x + dx / zoom);
  const y = Math.floor(view.y + dy / zoom);
  if (x < 0 || y < 0 || x >= view.width || y >= view.height) {
    readout.textContent = "outside";
    return;
  }
  const column = Math.min(Math.floor((x * shown.width) / view.width), shown.width - 1);
  const row = Math.min(Math.floor((y * shown.height) / view.height), shown.height - 1);
  const pixel = row * shown.width + column;
  const light = lightAt(pixel);
  let text = `x ${x}  y ${y}   ${shown.layer} ${valueAt(pixel).map(shortNumber).join(" ")}`;
  if (shown.planes.length === 3 && shown.layer !== "normal") text += `   Y ${shortNumber(light)}`;
  if (shown.layer === "picture" && shown.error) {
    text += ` ± ${shortNumber(shown.error[pixel])}`;
    if (light > 0) text += ` (${shortNumber(Number(((100 * shown.error[pixel]) / light).toPrecision(2)))}%)`;
  }
  readout.textContent = text;
}

onGestures(stage, {
  pan: panBy,
  zoom: (factor, x, y) => zoomTo(zoomNow() * factor, x, y),
  hover(place) {
    view.pointer = place;
    readOut();
  },
});
new ResizeObserver(place).observe(stage);
