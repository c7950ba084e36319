// From numbers to what is on the screen.
"use strict";

const canvas = byId("canvas");
const LARGEST_ERROR = 0.5; // relative, at exposure 0

/** The screen's byte of light, by the upper half of its bits: exact, and no power a pixel. */
let bytes = { exposure: NaN, table: new Uint8Array(65536) };

function bytesAt(exposure) {
  if (bytes.exposure === exposure) return bytes.table;
  const halves = Uint16Array.from({ length: 65536 }, (_, i) => i);
  const factor = 2 ** exposure;
  bytes = { exposure, table: Uint8Array.from(numbersOf(halves), (value) => screenByte(value * factor)) };
  return bytes.table;
}

function paintLight(exposure, out) {
  const table = bytesAt(exposure);
  const { planes } = shown;
  const bits = planes.map((plane) => new Uint32Array(plane.buffer));
  const last = bits.length - 1;
  for (let i = 0, o = 0; i < bits[0].length; ++i, o += 4) {
    for (let c = 0; c < 3; ++c) out[o + c] = table[bits[Math.min(c, last)][i] >>> 16];
    out[o + 3] = 255;
  }
}

/** What each false colour needs: its map, where in [0,1] a pixel lies in it, and its ends. */
const MAPPED = {
  luminance: {
    name: "luminance",
    map: VIRIDIS,
    place: (i, exposure) => placeOfLuminance(lightAt(i), exposure),
    ends: endsOfLuminance,
  },
  error: {
    name: "standard error over luminance",
    map: MAGMA,
    place: (i, exposure) => ((shown.error[i] / Math.max(Math.abs(lightAt(i)), 1e-30)) * 2 ** exposure) / LARGEST_ERROR,
    ends: (exposure) => ["0", `${shortNumber((100 * LARGEST_ERROR) / 2 ** exposure)}%`],
  },
};

function paintMapped({ map, place }, exposure, out) {
  for (let i = 0, o = 0; i < shown.planes[0].length; ++i, o += 4) {
    const at = 3 * Math.min(Math.max(Math.round(255 * place(i, exposure)), 0), 255);
    [out[o], out[o + 1], out[o + 2], out[o + 3]] = [map[at], map[at + 1], map[at + 2], 255];
  }
}

/** @param show  light, luminance or error; without known errors the last is light. */
function paint(show, exposure) {
  if (shown.number === 0) return;
  const mapped = show === "error" && !shown.error ? undefined : MAPPED[show];
  if (canvas.width !== shown.width || canvas.height !== shown.height)
    Object.assign(canvas, { width: shown.width, height: shown.height });
  const context = canvas.getContext("2d");
  const image = context.createImageData(shown.width, shown.height);
  if (mapped) paintMapped(mapped, exposure, image.data);
  else paintLight(exposure, image.data);
  context.putImageData(image, 0, 0);
  showLegend(mapped, mapped?.ends(exposure));
}
