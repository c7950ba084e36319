// What controls and keys do.
"use strict";

const onClick = (id, does) => byId(id).addEventListener("click", does);
onClick("stop", async (event) => {
  event.target.disabled = true;
  event.target.textContent = "Ends after this pass";
  await wish("stop");
});
onClick("pause", () => wish("pause", { on: status?.is_paused ? 0 : 1 }));
onClick("back", back);
onClick("hold", hold);
onClick("save-png", savePng);
onClick("follow", followPng);
onClick("fit", fit);
onClick("full", () => zoomTo(1 / devicePixelRatio));
onClick("larger", () => zoomTo(zoomNow() * 2));
onClick("smaller", () => zoomTo(zoomNow() / 2));
onClick("copy-camera", () => navigator.clipboard?.writeText(byId("camera-words").textContent));
for (const button of document.querySelectorAll("[data-drag]"))
  button.addEventListener("click", () => setDragging(button.dataset.drag));
byId("layer").addEventListener("change", (event) => {
  settings.layer = event.target.value;
  keepUp();
});
byId("show").addEventListener("change", (event) => {
  settings.show = event.target.value;
  repaint();
  keepUp();
});
byId("tone").addEventListener("change", (event) => {
  setExposure(settings.exposure, false);
  setTone(event.target.value);
});
byId("exposure").addEventListener("input", (event) => setExposure(Number(event.target.value), false));
byId("wipe-at").addEventListener("input", (event) => setWipe(Number(event.target.value)));
byId("ends").addEventListener("submit", (event) => {
  event.preventDefault();
  const [error, minutes] = ["end-error", "end-minutes"].map((id) => byId(id).value.trim());
  wish("ends", { error: error && `${error}%`, seconds: minutes && `${minutes}m` });
});

const STEP = 64; // screen pixels of an arrow key
/** Arrows do what dragging does, of the picture or of the camera. */
const movesCamera = () => ["orbit", "around"].includes(dragging);
const arrow = (dx, dy) => (event) => (movesCamera() ? DRAGS[dragging].drag(-dx, -dy, event.shiftKey) : panBy(dx, dy));
const zoomKey = (factor) => () => (movesCamera() ? dolly(factor) : zoomTo(zoomNow() * factor));
const KEYS = {
  f: fit,
  1: () => zoomTo(1 / devicePixelRatio),
  "+": zoomKey(2),
  "=": zoomKey(2),
  "-": zoomKey(0.5),
  a: followPng,
  e: () => setExposure(settings.exposure + 0.5, false),
  E: () => setExposure(settings.exposure - 0.5, false),
  " ": () => byId("pause").click(),
  r: lookAtVisible,
  m: () => setDragging("move"),
  c: () => setDragging("orbit"),
  l: () => setDragging("around"),
  o: () => focusOn(view.x, view.y),
  h: hold,
  Escape: () => isAside() && back(),
  ArrowLeft: arrow(STEP, 0),
  ArrowRight: arrow(-STEP, 0),
  ArrowUp: arrow(0, STEP),
  ArrowDown: arrow(0, -STEP),
};
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const isTyping = ["SELECT", "INPUT"].includes(event.target.tagName);
  const isPressing = event.key === " " && ["BUTTON", "SUMMARY", "A"].includes(event.target.tagName);
  const key = KEYS[event.key];
  if (!key || isTyping || isPressing) return;
  event.preventDefault();
  key(event);
});
