// Where the pictures stand: one place and zoom. Before the first pass one has fewer pixels, and
// fills the same room.
"use strict";

const stage = byId("stage");

/** `zoom` is screen pixels a pixel of the whole picture, 0 to fit; x, y: the place in the middle;
 *  `pointer`: where the mouse is; `wipe`: the share of the stage that shows the earlier picture. */
const view = { width: 1, height: 1, zoom: 0, x: 0.5, y: 0.5, pointer: null, wipe: 0 };

function setSize(width, height) {
  if (!width || (view.width === width && view.height === height)) return;
  Object.assign(view, { width, height, zoom: 0, x: width / 2, y: height / 2 });
  stage.style.setProperty("--aspect", `${width} / ${height}`);
  place();
}

const zoomNow = () =>
  view.zoom > 0 ? view.zoom : Math.min(stage.clientWidth / view.width, stage.clientHeight / view.height);

/** Screen pixels from the stage's corner of a place of the picture. */
const onStage = (x, y) => {
  const zoom = zoomNow();
  return [stage.clientWidth / 2 + (x - view.x) * zoom, stage.clientHeight / 2 + (y - view.y) * zoom];
};

/** x0 x1 y0 y1 of the whole picture that a sheet shows. */
const regionOf = (sheet) => sheet.region ?? [0, view.width, 0, view.height];

function placeSheet(sheet) {
  const { canvas } = sheet;
  const [x0, x1, y0, y1] = regionOf(sheet);
  const [left, top] = onStage(x0, y0);
  const zoom = zoomNow();
  const larger = (x1 - x0) / canvas.width; // than a pixel of the canvas
  const taller = (y1 - y0) / canvas.height;
  canvas.style.transform = `translate(${left}px, ${top}px) scale(${zoom * larger}, ${zoom * taller})`;
  canvas.classList.toggle("sharp", larger === 1 && zoom * devicePixelRatio >= 1.5);
}

/** Puts the canvases into their places: cheap, for every move. */
function place() {
  Object.values(sheets).forEach(placeSheet);
  byId("wipe").style.width = `${100 * view.wipe}%`;
  byId("wipe").hidden = view.wipe === 0 || sheets.earlier.number === 0;
  placeMarquee();
  byId("zoom-value").textContent = `${shortNumber(Number((100 * zoomNow()).toPrecision(3)))}%`;
  readOut();
}

const within = (value, low, high) => Math.min(Math.max(value, low), high);

/** Screen pixels from the middle of the stage. */
function fromMiddle(clientX, clientY) {
  const box = stage.getBoundingClientRect();
  return [clientX - box.left - box.width / 2, clientY - box.top - box.height / 2];
}

/** The place of the picture below a place of the screen. */
function pictureAt(clientX, clientY) {
  const [dx, dy] = fromMiddle(clientX, clientY);
  return [view.x + dx / zoomNow(), view.y + dy / zoomNow()];
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

/** The sheet that is seen at a place of the picture. @param left  of the stage, in screen pixels. */
function sheetAt(x, y, left) {
  if (sheets.earlier.number !== 0 && left < view.wipe * stage.clientWidth) return sheets.earlier;
  const [x0, x1, y0, y1] = regionOf(sheets.look);
  return sheets.look.number !== 0 && x >= x0 && x < x1 && y >= y0 && y < y1 ? sheets.look : sheets.render;
}

/** What is known of a pixel of a sheet, as text. */
function pixelText(sheet, pixel) {
  const planes = sheet.shown.map((plane) => plane[pixel]);
  const light = planes.length === 3 ? luminanceOf(planes) : planes[0];
  let text = `${sheet.of === "render" ? "" : `${sheet.of}: `}${sheet.layer} ${planes.map(shortNumber).join(" ")}`;
  if (planes.length === 3 && sheet.layer !== "normal") {
    text += `   Y ${shortNumber(light)}`;
    if (status?.nits && nits() !== 1) text += ` = ${shortNumber(light * nits())} cd/m²`;
  }
  if (sheet.layer === "picture" && sheet.error && !isMixed(sheet)) {
    text += ` ± ${shortNumber(sheet.error[pixel])}`;
    if (light > 0) text += ` (${shortNumber(Number(((100 * sheet.error[pixel]) / light).toPrecision(2)))}%)`;
  }
  if (sheet.layer === "picture" && sheet.albedo) text += `   ${shortNumber(luxAt(sheet, pixel))} lx if matt`;
  return text;
}

/** The numbers of the pixel under the mouse, or in the middle. */
function readOut() {
  const readout = byId("readout");
  const [dx, dy] = view.pointer ? fromMiddle(...view.pointer) : [0, 0];
  const x = Math.floor(view.x + dx / zoomNow());
  const y = Math.floor(view.y + dy / zoomNow());
  const sheet = sheetAt(x, y, dx + stage.clientWidth / 2);
  if (sheet.number === 0) return;
  if (x < 0 || y < 0 || x >= view.width || y >= view.height) {
    readout.textContent = "outside";
    return;
  }
  const [x0, x1, y0, y1] = regionOf(sheet);
  const column = within(Math.floor(((x - x0) * sheet.width) / (x1 - x0)), 0, sheet.width - 1);
  const row = within(Math.floor(((y - y0) * sheet.height) / (y1 - y0)), 0, sheet.height - 1);
  readout.textContent = `x ${x}  y ${y}   ${pixelText(sheet, row * sheet.width + column)}`;
}
