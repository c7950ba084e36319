// Looking aside: a region, or by another camera, while the render waits.
"use strict";

/** What dragging does: one of DRAGS. */
let dragging = "move";

/** What is asked for: `region` in shares x0 x1 y0 y1, `focus` in shares x y, and the camera's way
 *  from where the scene has it. */
const noLook = () => ({ region: null, focus: null, tilt: 0, turn: 0, nearer: 0, right: 0, up: 0, pitch: 0, yaw: 0 });
let look = noLook();
let marquee = null; // x0 y0 x1 y1 of the picture, while it is drawn

const isAside = () => Boolean(status?.look);

/** Sends a wish to the render. @return whether it was taken; if not, the page says why. */
async function wish(path, parameters = {}) {
  try {
    const answer = await fetch(address(path, parameters), { method: "POST" });
    byId("fault").textContent = answer.ok ? "" : await answer.text();
    return answer.ok;
  } catch {
    return false; // the stream of texts tells that the connection is lost
  }
}

const rounded = (number) => Number(number.toPrecision(9));

/** The look as a request has it. */
function lookWords(isMoving) {
  const words = {};
  for (const name of ["tilt", "turn", "nearer", "right", "up", "pitch", "yaw"]) if (look[name] !== 0) words[name] = rounded(look[name]);
  if (look.region) words.region = look.region.map(rounded).join();
  if (look.focus) [words.focus_x, words.focus_y] = look.focus.map(rounded);
  if (isMoving) words.moving = 1;
  return words;
}

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Waits for the next picture of a look, but not for long. */
async function lookShown(before) {
  const MOST = 1500; // milliseconds
  const TICK = 15;
  for (let waited = 0; waited < MOST && sheets.look.number === before; waited += TICK) await pause(TICK);
}

// One look at a time: what comes meanwhile is asked for after it, the latest alone; while the camera
// moves, when a picture has come.
let isAsking = false;
let next = null;
let settling = 0;

async function askLook(isMoving) {
  next = { isMoving };
  if (isAsking) return;
  isAsking = true;
  while (next) {
    const { isMoving: moves } = next;
    const { number } = sheets.look;
    next = null;
    if ((await wish("look", lookWords(moves))) && moves) await lookShown(number);
  }
  isAsking = false;
}

/** The camera has been moved: few pixels now, and all of them when it stands still. */
function cameraMoved() {
  askLook(true);
  clearTimeout(settling);
  settling = setTimeout(() => askLook(false), 400);
}

const RADIANS = 0.006; // of a turn, a screen pixel

/** @param dx, dy  screen pixels of a drag: what is seen turns with the mouse about the pivot. */
function orbit(dx, dy) {
  look.turn += dx * RADIANS;
  look.tilt = within(look.tilt + dy * RADIANS, -3.1, 3.1);
  cameraMoved();
}

/** Turns the camera in its place, so that what is seen follows the mouse. */
function lookAround(dx, dy) {
  look.yaw -= dx * RADIANS / 2;
  look.pitch = within(look.pitch - dy * RADIANS / 2, -3.1, 3.1);
  cameraMoved();
}

/** Moves the camera aside, so that what is seen follows the mouse. */
function slide(dx, dy) {
  const share = 1 / stage.clientHeight;
  look.right -= dx * share;
  look.up += dy * share;
  cameraMoved();
}

function dolly(factor) {
  look.nearer = within(look.nearer + Math.log2(factor), -20, 20);
  cameraMoved();
}

async function back() {
  clearTimeout(settling);
  next = null;
  look = noLook();
  await wish("back");
}

/** Renders a region of the picture. */
function lookAtRegion(x0, y0, x1, y1) {
  const share = (value, most) => within(value / most, 0, 1);
  const [left, right] = [Math.min(x0, x1), Math.max(x0, x1)].map((x) => share(x, view.width));
  const [top, bottom] = [Math.min(y0, y1), Math.max(y0, y1)].map((y) => share(y, view.height));
  if (right - left < 2 / view.width || bottom - top < 2 / view.height) return;
  look.region = [left, right, top, bottom];
  askLook(false);
}

/** Renders what the stage shows of the picture. */
function lookAtVisible() {
  const zoom = zoomNow();
  const [w, h] = [stage.clientWidth / zoom / 2, stage.clientHeight / zoom / 2];
  lookAtRegion(view.x - w, view.y - h, view.x + w, view.y + h);
}

/** Puts what is at a place of the picture in focus. */
function focusOn(x, y) {
  if (x < 0 || y < 0 || x >= view.width || y >= view.height) return;
  look.focus = [x / view.width, y / view.height];
  askLook(false);
}

/** The frame that is drawn, or that of the region which is rendered. */
function placeMarquee() {
  const frame = byId("marquee");
  const region = status?.look?.region;
  const isPart = region && (region[1] - region[0] < view.width || region[3] - region[2] < view.height);
  const box = marquee ?? (isPart ? [region[0], region[2], region[1], region[3]] : null);
  frame.hidden = !box;
  if (!box) return;
  const [x0, y0] = onStage(Math.min(box[0], box[2]), Math.min(box[1], box[3]));
  const [x1, y1] = onStage(Math.max(box[0], box[2]), Math.max(box[1], box[3]));
  Object.assign(frame.style, { left: `${x0}px`, top: `${y0}px`, width: `${x1 - x0}px`, height: `${y1 - y0}px` });
}

/** What each way of dragging does: start(x, y) on the screen, drag(dx, dy), end(), zoom(...). */
const DRAGS = {
  move: { drag: panBy, zoom: (factor, x, y) => zoomTo(zoomNow() * factor, x, y) },
  region: {
    start(x, y) {
      const at = pictureAt(x, y);
      marquee = [...at, ...at];
    },
    drag(dx, dy) {
      if (!marquee) return;
      marquee[2] += dx / zoomNow();
      marquee[3] += dy / zoomNow();
      placeMarquee();
    },
    end() {
      const box = marquee;
      marquee = null;
      if (box) lookAtRegion(...box);
      placeMarquee();
    },
    zoom: (factor, x, y) => zoomTo(zoomNow() * factor, x, y),
  },
  orbit: { drag: (dx, dy, shifts) => (shifts ? slide : orbit)(dx, dy), zoom: dolly },
  around: { drag: (dx, dy, shifts) => (shifts ? slide : lookAround)(dx, dy), zoom: dolly },
  focus: {
    start: (x, y) => focusOn(...pictureAt(x, y)),
    drag() {},
    zoom: (factor, x, y) => zoomTo(zoomNow() * factor, x, y),
  },
};

function setDragging(way) {
  if (way !== "move" && !status?.can_be_steered) return;
  if (way === "focus" && !status?.has_lens) return;
  dragging = way;
  for (const button of document.querySelectorAll("[data-drag]"))
    button.setAttribute("aria-pressed", button.dataset.drag === way);
  stage.dataset.drag = way;
}

onGestures(stage, {
  start: (x, y) => DRAGS[dragging].start?.(x, y),
  pan: (dx, dy, shifts) => DRAGS[dragging].drag(dx, dy, shifts),
  end: () => DRAGS[dragging].end?.(),
  zoom: (factor, x, y) => DRAGS[dragging].zoom(factor, x, y),
  hover(at) {
    view.pointer = at;
    readOut();
  },
});
new ResizeObserver(place).observe(stage);

/** Says what is looked at. */
function tellLook() {
  const { look: aside } = status;
  byId("aside").hidden = !aside;
  if (!aside) return;
  const [x0, x1, y0, y1] = aside.region;
  const what = [aside.is_moved ? "by another camera" : "", `${x1 - x0} x ${y1 - y0} pixels`].filter(Boolean).join(", ");
  const stands = aside.is_learning ? "learning" : `${aside.passes} ${aside.passes === 1 ? "pass" : "passes"}`;
  byId("aside-text").textContent = aside.fault || `A look aside, ${what}: ${stands}. The render waits.`;
  byId("camera-panel").hidden = !aside.is_moved;
  byId("camera-words").textContent = aside.camera;
}
