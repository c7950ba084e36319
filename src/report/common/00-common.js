// What pages have in common: elements by name, numbers for people, light on the screen, colour maps.
"use strict";

const byId = (id) => document.getElementById(id);

/** Of linear sRGB. */
const luminanceOf = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** A number for people: four digits. */
function shortNumber(value) {
  if (value === null || value === undefined) return "–";
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(2) : String(Number(value.toPrecision(4)));
}

/** Linear light as a byte of sRGB (IEC 61966-2-1). */
function screenByte(light) {
  const cut = Math.min(Math.max(light, 0), 1) || 0;
  return Math.round(255 * (cut <= 0.0031308 ? 12.92 * cut : 1.055 * cut ** (1 / 2.4) - 0.055));
}

// Points of colour maps, evenly spaced. Viridis and magma: S. van der Walt and N. Smith (CC0);
// red-blue: C. Brewer, colorbrewer2 (Apache 2.0).
const VIRIDIS = mapOf("440154 482878 3e4989 31688e 26828e 1f9e89 35b779 6ece58 b5de2b fde725");
const MAGMA = mapOf("000004 180f3d 440f76 721f81 9e2f7f cd4071 f1605d fd9668 feca8d fcfdbf");
const BLUE_RED = mapOf("053061 2166ac 4393c3 92c5de d1e5f0 f7f7f7 fddbc7 f4a582 d6604d b2182b 67001f");

/** 256 colours as one array of r, g, b. */
function mapOf(hexes) {
  const points = hexes.split(" ").map((h) => [0, 2, 4].map((i) => parseInt(h.slice(i, i + 2), 16)));
  const table = new Uint8Array(768);
  for (let i = 0; i < 256; ++i) {
    const place = (i / 255) * (points.length - 1);
    const before = Math.min(Math.floor(place), points.length - 2);
    for (let c = 0; c < 3; ++c)
      table[3 * i + c] = points[before][c] + (place - before) * (points[before + 1][c] - points[before][c]);
  }
  return table;
}

// Luminance in false colour: the decades that the map spans at exposure 0.
const DECADES = [-3, 1];
const placeOfLuminance = (luminance, exposure) =>
  (Math.log10(Math.max(luminance, 1e-30)) + exposure * Math.log10(2) - DECADES[0]) / (DECADES[1] - DECADES[0]);
const endsOfLuminance = (exposure) => DECADES.map((d) => shortNumber(10 ** d / 2 ** exposure));

/** Shows what the colours of a map mean, or nothing. @param ends  texts of both. */
function showLegend(mapped, ends) {
  byId("legend").hidden = !mapped;
  if (!mapped) return;
  const { name, map } = mapped;
  [byId("legend-low").textContent, byId("legend-high").textContent] = ends;
  byId("legend-name").textContent = name;
  const context = byId("legend-bar").getContext("2d");
  const image = context.createImageData(256, 1);
  for (let i = 0; i < 256; ++i) image.data.set([map[3 * i], map[3 * i + 1], map[3 * i + 2], 255], 4 * i);
  context.putImageData(image, 0, 0);
}
