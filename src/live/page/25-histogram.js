// How many pixels are how bright, by powers of two, under the exposure as it is set.
"use strict";

const STOPS = [-12, 6]; // of luminance at the exposure; white is 0
const BARS = 108; // six a stop
const MOST_COUNTED = 400_000; // pixels: of more, each so-and-so-manieth

/** The share of pixels in each bar, and of those that are brighter than white. */
function countLight(planes, exposure) {
  const bars = new Float64Array(BARS);
  const pixels = planes[0].length;
  const step = Math.max(1, Math.floor(pixels / MOST_COUNTED));
  let white = 0;
  for (let i = 0; i < pixels; i += step) {
    const light = lightAt(planes, i) * 2 ** exposure;
    if (light > 1) ++white;
    if (!(light > 0)) continue;
    const place = ((Math.log2(light) - STOPS[0]) / (STOPS[1] - STOPS[0])) * BARS;
    ++bars[within(Math.floor(place), 0, BARS - 1)];
  }
  const counted = Math.ceil(pixels / step);
  return { bars: bars.map((count) => count / counted), white: white / counted };
}

function showHistogram(sheet, exposure) {
  const canvas = byId("histogram");
  const context = canvas.getContext("2d");
  context.clearRect(0, 0, canvas.width, canvas.height);
  if (sheet.number === 0) return;
  const { bars, white } = countLight(sheet.shown, exposure);
  const style = getComputedStyle(document.documentElement);
  const highest = Math.max(...bars) || 1;
  const width = canvas.width / BARS;
  bars.forEach((share, bar) => {
    const isWhite = STOPS[0] + ((bar + 0.5) / BARS) * (STOPS[1] - STOPS[0]) > 0;
    context.fillStyle = style.getPropertyValue(isWhite ? "--accent" : "--quiet");
    const height = (share / highest) * canvas.height;
    context.fillRect(bar * width, canvas.height - height, width, height);
  });
  const brighter = `${Number((100 * white).toPrecision(2))}% brighter than white`;
  byId("histogram-text").textContent = brighter;
  canvas.setAttribute("aria-label", `Histogram of luminance: ${brighter}`);
}
