// What the page shows: the numbers, and each picture's pixels as 16-bit floats.
"use strict";

const numbers = JSON.parse(byId("numbers").textContent);

/** In the order of the table's columns; `best` is what equal pictures give. */
const METRICS = [
  { name: "mse", title: "MSE", best: 0 },
  { name: "rel_mse", title: "relMSE", best: 0 },
  { name: "smape", title: "SMAPE", best: 0 },
  { name: "flip", title: "FLIP", best: 0 },
  { name: "hdr_flip", title: "HDR-FLIP", best: 0 },
  { name: "luminance_ratio", title: "luminance ratio", best: 1 },
];

/** The value of each of the 65536 half floats (IEEE 754 binary16). */
const HALF_VALUES = Float32Array.from({ length: 65536 }, (_, bits) => {
  const sign = bits & 0x8000 ? -1 : 1;
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  if (exponent === 0) return sign * fraction * 2 ** -24;
  if (exponent === 31) return fraction ? NaN : sign * Infinity;
  return sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
});

function bytesOf(id) {
  const text = atob(byId(id).textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** Number 0 is the reference. `halves` holds R, G, B of each pixel, times `scale`. */
function readPicture(about, number) {
  const block = byId(`pixels-${number}`);
  return {
    ...about,
    number,
    halves: new Uint16Array(bytesOf(block.id).buffer),
    scale: Number(block.dataset.scale),
    flip: number === 0 ? null : bytesOf(`flip-${number}`),
    canvas: null,
  };
}

const pictures = [numbers.reference, ...numbers.pictures].map(readPicture);
const size = { width: numbers.width, height: numbers.height };

/** Linear R, G, B of a pixel. */
function valueAt(picture, pixel) {
  return [0, 1, 2].map((c) => HALF_VALUES[picture.halves[3 * pixel + c]] / picture.scale);
}
