// Controls, keys, and what the render says as it goes on.
"use strict";

const LARGEST_EXPOSURE = Number(byId("exposure").max);
const settings = { layer: "picture", show: "light", exposure: 0, follows: true };
let status = null; // the latest
let since = 0; // when it was told, in milliseconds of this page
let isTaking = false;

const repaint = () => {
  paint(settings.show, settings.exposure);
  place();
};

/** Takes pictures one after the other, as fast as they come and no faster; none while hidden. */
async function keepUp() {
  if (isTaking || document.hidden || !status) return;
  if (status.picture === shown.number && settings.layer === shown.layer) return;
  isTaking = true;
  try {
    if (await takePicture(settings.layer, status.layers)) repaint();
  } catch {
    // The connection is lost, or the render has ended: the stream of texts tells.
  }
  isTaking = false;
  tellStage();
  if (status.picture > shown.number) setTimeout(keepUp, 100);
}

function setExposure(stops, follows) {
  settings.follows = follows;
  settings.exposure = within(Math.round(10 * stops) / 10, -LARGEST_EXPOSURE, LARGEST_EXPOSURE);
  byId("exposure").value = settings.exposure;
  byId("exposure-value").textContent = (settings.exposure > 0 ? "+" : "") + settings.exposure.toFixed(1);
  byId("follow").setAttribute("aria-pressed", follows);
  repaint();
}

function setOptions(select, names, chosen) {
  const before = [...select.options].map((option) => option.value).join();
  if (before === names.join()) return;
  select.replaceChildren(...names.map((name) => new Option(name, name)));
  select.value = names.includes(chosen) ? chosen : names[0];
}

/** Seconds as people say them. */
function duration(seconds) {
  if (seconds === null || seconds === undefined) return "–";
  const whole = Math.round(seconds);
  const [h, m, s] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  if (h > 0) return `${h} h ${m} min`;
  return m > 0 ? `${m} min ${s} s` : `${s} s`;
}

const percent = (share) => (share === null || share === undefined ? "–" : `${Number((100 * share).toPrecision(2))}%`);

const STAGES = {
  reading: "reading the scene",
  learning: "learning where photons are needed",
  rendering: "rendering",
  ended: "finished",
};

function tellStage() {
  byId("stage-text").textContent = STAGES[status.stage];
  const veil = byId("veil");
  veil.hidden = shown.number > 0 && !status.is_preview;
  if (shown.number === 0) veil.textContent = "The picture comes when the scene has been read.";
  else if (status.is_preview) veil.textContent = "A first look, with few pixels: light that needs no photons. The first pass is on its way.";
  document.title = `${status.passes > 0 ? `${status.passes} · ` : ""}${status.scene || "Sunfleck"}`;
}

/** The time goes on between texts. */
function tellTime() {
  if (!status) return;
  const isOver = status.stage === "ended";
  const more = isOver || status.stage === "reading" ? 0 : (performance.now() - since) / 1000;
  const { seconds_left: left } = status;
  byId("time").textContent = isOver && status.passes === 0 ? "–" : duration(status.seconds + more);
  byId("left").textContent = isOver || left === null ? "–" : duration(Math.max(0, left - more));
}

function tellNumbers() {
  byId("scene").textContent = status.scene || "Sunfleck";
  tellTime();
  const isPicture = status.stage === "ended" && status.passes === 0; // and no render
  byId("passes").textContent = isPicture ? "–" : status.passes_of ? `${status.passes} of ${status.passes_of}` : status.passes;
  const target = status.target_error === null ? "" : ` (ends at ${percent(status.target_error)})`;
  byId("error").textContent = percent(status.error) + target;
  byId("dark-error").textContent = percent(status.dark_error);
  byId("bringing").textContent = status.passes > 0 ? percent(status.bringing) : "–";
  byId("stop").hidden = status.stage === "ended";
  const { warnings } = status;
  byId("warnings").hidden = warnings.length === 0;
  byId("warnings").querySelector("summary").textContent = warnings.length === 1 ? "1 warning" : `${warnings.length} warnings`;
  const list = byId("warnings").querySelector("ul");
  if (list.children.length === warnings.length) return;
  list.replaceChildren(...warnings.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
}

function take(text) {
  const { age, status: latest } = JSON.parse(text);
  status = latest;
  since = performance.now() - 1000 * age;
  setSize(status.width, status.height);
  setOptions(byId("layer"), status.layers.length > 0 ? status.layers : ["picture"], settings.layer);
  settings.layer = byId("layer").value;
  if (settings.follows && settings.exposure !== status.exposure) setExposure(status.exposure, true);
  tellNumbers();
  tellStage();
  keepUp();
}

const texts = new EventSource(address("texts"));
texts.onmessage = (event) => take(event.data);
texts.onerror = () => {
  // A render that has ended and gone is no fault.
  if (status?.stage === "ended") return texts.close();
  byId("stage-text").textContent = "connection lost: the render has gone, or is out of reach; trying again";
};
document.addEventListener("visibilitychange", keepUp);
setInterval(tellTime, 1000);

byId("stop").addEventListener("click", async (event) => {
  event.target.disabled = true;
  event.target.textContent = "Ends after this pass";
  await fetch(address("stop"), { method: "POST" });
});
byId("layer").addEventListener("change", (event) => {
  settings.layer = event.target.value;
  keepUp();
});
byId("show").addEventListener("change", (event) => {
  settings.show = event.target.value;
  repaint();
});
byId("exposure").addEventListener("input", (event) => setExposure(Number(event.target.value), false));
byId("follow").addEventListener("click", () => setExposure(status?.exposure ?? 0, true));
byId("fit").addEventListener("click", fit);
byId("full").addEventListener("click", () => zoomTo(1 / devicePixelRatio));
byId("larger").addEventListener("click", () => zoomTo(zoomNow() * 2));
byId("smaller").addEventListener("click", () => zoomTo(zoomNow() / 2));

const STEP = 64; // screen pixels of an arrow key
const KEYS = {
  f: fit,
  1: () => zoomTo(1 / devicePixelRatio),
  "+": () => zoomTo(zoomNow() * 2),
  "=": () => zoomTo(zoomNow() * 2),
  "-": () => zoomTo(zoomNow() / 2),
  a: () => setExposure(status?.exposure ?? 0, true),
  e: () => setExposure(settings.exposure + 0.5, false),
  E: () => setExposure(settings.exposure - 0.5, false),
  ArrowLeft: () => panBy(STEP, 0),
  ArrowRight: () => panBy(-STEP, 0),
  ArrowUp: () => panBy(0, STEP),
  ArrowDown: () => panBy(0, -STEP),
};
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const isTyping = ["SELECT", "INPUT"].includes(event.target.tagName);
  const key = KEYS[event.key];
  if (!key || isTyping) return;
  event.preventDefault();
  key();
});
