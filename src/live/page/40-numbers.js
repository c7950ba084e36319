// What the render says of itself, in words and numbers.
"use strict";

let status = null; // the latest
let since = 0; // when it was told, in milliseconds of this page

/** Seconds as people say them. */
function duration(seconds) {
  if (seconds === null || seconds === undefined) return "–";
  const whole = Math.round(seconds);
  const [h, m, s] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  if (h > 0) return `${h} h ${m} min`;
  if (m === 0) return `${s} s`;
  return s > 0 ? `${m} min ${s} s` : `${m} min`;
}

const percent = (share) => (share === null || share === undefined ? "–" : `${Number((100 * share).toPrecision(2))}%`);

const STAGES = {
  reading: "reading the scene",
  learning: "learning where photons are needed",
  rendering: "rendering",
  ended: "finished",
};

function tellStage() {
  const waits = isAside() ? "waiting for a look aside" : status.is_paused ? "paused" : "";
  byId("stage-text").textContent = waits || STAGES[status.stage];
  const veil = byId("veil");
  const isFirst = (picture) => picture.number > 0 && picture.is_preview;
  const aside = status.look;
  veil.hidden = false;
  if (aside) {
    if (aside.picture.number === 0) veil.textContent = "The look aside comes when the view is set up.";
    else if (isFirst(aside.picture)) veil.textContent = "A sketch of the surfaces. The light comes when the camera stands still.";
    else veil.hidden = true;
  } else if (sheets.render.number === 0) {
    veil.textContent = "The picture comes when the scene has been read.";
  } else if (isFirst(status.picture)) {
    veil.textContent = "A first look, with few pixels: light that needs no photons. The first pass is on its way.";
  } else {
    veil.hidden = true;
  }
  document.title = `${status.passes > 0 ? `${status.passes} · ` : ""}${status.scene || "Sunfleck"}`;
}

/** The time goes on between texts, unless the render waits. */
function tellTime() {
  if (!status) return;
  const isOver = status.stage === "ended";
  const stands = isOver || status.stage === "reading" || status.is_paused || isAside();
  const more = stands ? 0 : (performance.now() - since) / 1000;
  const { seconds_left: left } = status;
  byId("time").textContent = isOver && status.passes === 0 ? "–" : duration(status.seconds + more);
  byId("left").textContent = isOver || left === null ? "–" : duration(Math.max(0, left - more));
}

function tellEnds() {
  const { end_error: error, end_seconds: seconds } = status;
  const ends = [error === null ? "" : `at ${percent(error)}`, seconds === null ? "" : `after ${duration(seconds)}`].filter(Boolean);
  byId("ends-text").textContent = ends.length > 0 ? `Ends ${ends.join(" or ")}` : "Ends when it is stopped";
}

function tellWarnings() {
  const { warnings } = status;
  byId("warnings").hidden = warnings.length === 0;
  byId("warnings").querySelector("summary").textContent = warnings.length === 1 ? "1 warning" : `${warnings.length} warnings`;
  const list = byId("warnings").querySelector("ul");
  if (list.children.length === warnings.length) return;
  list.replaceChildren(...warnings.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
}

function tellNumbers() {
  byId("scene").textContent = status.scene || "Sunfleck";
  tellTime();
  const isPicture = status.stage === "ended" && status.passes === 0; // and no render
  byId("passes").textContent = isPicture ? "–" : status.passes_of ? `${status.passes} of ${status.passes_of}` : status.passes;
  byId("error").textContent = percent(status.error);
  byId("dark-error").textContent = percent(status.dark_error);
  byId("bringing").textContent = status.passes > 0 ? percent(status.bringing) : "–";
  const isOver = status.stage === "ended";
  byId("stop").hidden = isOver;
  byId("pause").hidden = isOver || !status.can_be_steered;
  byId("pause").textContent = status.is_paused ? "Go on" : "Pause";
  byId("ends-panel").hidden = isOver || !status.can_be_steered;
  byId("looks").hidden = !status.can_be_steered;
  byId("focus-way").disabled = !status.has_lens;
  byId("focus-way").title = status.has_lens ? "What is clicked on is in focus (o)" : "This camera has no lens: all is in focus";
  tellEnds();
  tellWarnings();
}
