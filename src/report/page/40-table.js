// The table of errors, and how it gets to the clipboard.
"use strict";

// Okabe and Ito's colours, which also the colour-blind tell apart; black and yellow left out.
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"];
const DASHES = [[], [7, 4], [2, 3]];
const colourOf = (picture) => COLOURS[(picture.number - 1) % COLOURS.length];
const dashOf = (picture) => DASHES[Math.floor((picture.number - 1) / COLOURS.length) % DASHES.length];

function cell(row, tag, text, className = "") {
  const element = make(tag, className, row);
  element.textContent = text;
  return element;
}

function bestOf(metric) {
  const distances = pictures.slice(1).map((p) => p.metrics[metric.name]).filter((v) => v !== null);
  return Math.min(...distances.map((value) => Math.abs(value - metric.best)));
}

function buildTable() {
  const table = byId("table");
  const head = make("tr", "", make("thead", "", table));
  const withLeftOut = pictures.slice(1).some((p) => p.left_out > 0);
  const titles = ["Picture", ...METRICS.map((m) => m.title), ...(withLeftOut ? ["pixels left out"] : [])];
  for (const title of titles) cell(head, "th", title).scope = "col";
  const body = make("tbody", "", table);
  for (const picture of pictures.slice(1)) {
    const row = make("tr", "", body);
    const name = cell(row, "th", "");
    name.scope = "row";
    make("span", "swatch", name).style.background = colourOf(picture);
    name.append(picture.label);
    for (const metric of METRICS) {
      const value = picture.metrics[metric.name];
      const best = value !== null && pictures.length > 2 && Math.abs(value - metric.best) === bestOf(metric);
      cell(row, "td", shortNumber(value), best ? "best" : "");
    }
    if (withLeftOut) cell(row, "td", String(picture.left_out));
  }
  const pixels = size.width * size.height;
  const broken = pictures.filter((p) => p.broken_pixels > 0);
  byId("notes").textContent = broken
    .map((p) => `${p.label}: ${p.broken_pixels} of ${pixels} pixels are NaN or infinite, and left out.`)
    .join(" ");
}

/** Tab-separated, all digits, for a spreadsheet. */
function tableText() {
  const rows = [["picture", ...METRICS.map((m) => m.title), "pixels left out"]];
  for (const p of pictures.slice(1))
    rows.push([p.label, ...METRICS.map((m) => p.metrics[m.name] ?? ""), p.left_out]);
  return rows.map((row) => row.join("\t")).join("\n") + "\n";
}

/** For browsers that keep the clipboard from pages on the disk. */
function copyByHand(text) {
  const area = make("textarea", "", document.body);
  area.value = text;
  area.select();
  const done = document.execCommand("copy");
  area.remove();
  return done;
}

async function copyTable() {
  const text = tableText();
  let done = false;
  try {
    await navigator.clipboard.writeText(text);
    done = true;
  } catch {
    done = copyByHand(text);
  }
  byId("copy").focus();
  byId("said").textContent = done ? "Copied, separated by tabs." : "This browser does not let the page copy.";
  setTimeout(() => (byId("said").textContent = ""), 4000);
}
