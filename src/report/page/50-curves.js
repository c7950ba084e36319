// Error against time: lines of medians, bands between quartiles, drawn by Chart.js.
"use strict";

const seriesPictures = pictures.filter((p) => p.series);
let chart = null;

const [LOW, MIDDLE, HIGH] = [0, 1, 2];

/** Points that logarithmic axes can show. */
function curve(picture, part, metric, axis) {
  return picture.series.points
    .filter((p) => p[axis] > 0 && p[metric] && p[metric].every((v) => v > 0))
    .map((p) => ({ x: p[axis], y: p[metric][part] }));
}

/** The band's two borders, invisible, filled between; then the line. */
function datasetsOf(picture, metric, axis) {
  const colour = colourOf(picture);
  const border = { borderWidth: 0, pointRadius: 0, pointHitRadius: 0, label: "" };
  const line = {
    label: picture.label, data: curve(picture, MIDDLE, metric, axis), borderColor: colour, backgroundColor: colour,
    borderWidth: 2, borderDash: dashOf(picture), pointRadius: 3, fill: false,
  };
  if (picture.series.seeds < 2) return [line];
  return [
    { ...border, data: curve(picture, LOW, metric, axis), fill: false },
    { ...border, data: curve(picture, HIGH, metric, axis), fill: "-1", backgroundColor: `${colour}38` },
    line,
  ];
}

function axisOptions(title, style) {
  return {
    type: "logarithmic",
    title: { display: true, text: title, color: style.getPropertyValue("--ink") },
    grid: { color: style.getPropertyValue("--line") },
    ticks: {
      color: style.getPropertyValue("--quiet"), maxRotation: 0, autoSkipPadding: 12,
      callback: (value) => (/^[125]/.test(Number(value).toExponential()) ? shortNumber(value) : ""),
    },
  };
}

function chartOptions(metric, axis) {
  const style = getComputedStyle(document.documentElement);
  return {
    animation: false, responsive: true, maintainAspectRatio: false,
    interaction: { mode: "nearest", intersect: false },
    scales: {
      x: axisOptions(axis.selectedOptions[0].text, style),
      y: axisOptions(metric.selectedOptions[0].text, style),
    },
    plugins: {
      legend: { labels: { color: style.getPropertyValue("--ink"), usePointStyle: false, boxWidth: 24, boxHeight: 2, filter: (item) => item.text !== "" } },
      tooltip: { callbacks: {
        title: () => "",
        label: (item) => `${item.dataset.label}: ${shortNumber(item.parsed.y)} at ${shortNumber(item.parsed.x)} ${axis.selectedOptions[0].text}`,
      } },
    },
  };
}

function drawCurves() {
  const metric = byId("series-metric");
  const axis = byId("series-axis");
  const datasets = seriesPictures.flatMap((p) => datasetsOf(p, metric.value, axis.value));
  chart?.destroy();
  chart = new Chart(byId("chart"), { type: "line", data: { datasets }, options: chartOptions(metric, axis) });
  const what = `${metric.selectedOptions[0].text} against ${axis.selectedOptions[0].text}`;
  byId("chart").setAttribute("aria-label", `${what} of ${seriesPictures.map((p) => p.label).join(", ")}; in numbers below`);
  fillSeriesTable(metric, axis);
}

function fillSeriesTable(metric, axis) {
  const table = byId("series-table");
  table.replaceChildren();
  const head = make("tr", "", make("thead", "", table));
  for (const title of ["Series", axis.selectedOptions[0].text, "lower quartile", metric.selectedOptions[0].text, "upper quartile"])
    cell(head, "th", title).scope = "col";
  const body = make("tbody", "", table);
  for (const picture of seriesPictures)
    for (const point of picture.series.points) {
      const row = make("tr", "", body);
      cell(row, "th", picture.label).scope = "row";
      const band = point[metric.value] ?? [null, null, null];
      for (const value of [point[axis.value], ...band]) cell(row, "td", shortNumber(value));
    }
}

function buildCurves() {
  if (seriesPictures.length === 0) return;
  byId("series").hidden = false;
  for (const metric of METRICS) {
    if (!seriesPictures.some((p) => p.series.points.some((point) => point[metric.name]))) continue;
    byId("series-metric").add(new Option(metric.title, metric.name));
  }
  for (const id of ["series-metric", "series-axis"]) byId(id).addEventListener("change", drawCurves);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawCurves);
  drawCurves();
}
