// From numbers to what is on the screen.
"use strict";

const LARGEST_ERROR = 0.5; // relative, at exposure 0
const FEATURES = ["albedo", "normal", "depth", "error", "bias", "samples", "transmittance"]; // layers that are no light

/** Tone curves by name, as they have come. */
const tones = new Map();
const toneNow = () => tones.get(settings.tone);

/** Takes the tone curve that is chosen. @return whether it has come. */
async function takeTone() {
  const { tone } = settings;
  if (tone === "none" || tones.has(tone)) return false;
  const curve = await (await fetch(address("tone", { name: tone }))).json();
  tones.set(tone, { ...curve, values: Float32Array.from(curve.values) });
  return true;
}

const times = (rows, r, g, b) => rows.map(([x, y, z]) => x * r + y * g + z * b);

/** The screen's byte of light, by the upper half of its bits: exact, and no power a pixel. */
let bytes = { exposure: NaN, table: new Uint8Array(65536) };

function bytesAt(exposure) {
  if (bytes.exposure === exposure) return bytes.table;
  const halves = Uint16Array.from({ length: 65536 }, (_, i) => i);
  const factor = 2 ** exposure;
  bytes = { exposure, table: Uint8Array.from(numbersOf(halves), (value) => screenByte(value * factor)) };
  return bytes.table;
}

function paintPlain(planes, exposure, out) {
  const table = bytesAt(exposure);
  const bits = planes.map((plane) => new Uint32Array(plane.buffer));
  const last = bits.length - 1;
  for (let i = 0, o = 0; i < bits[0].length; ++i, o += 4) {
    for (let c = 0; c < 3; ++c) out[o + c] = table[bits[Math.min(c, last)][i] >>> 16];
    out[o + 3] = 255;
  }
}

/** The screen's byte of a value of a tone curve, by its thousandths. */
const bytesOfCurve = (decoding) => Uint8Array.from({ length: 1001 }, (_, i) => screenByte((i / 1000) ** decoding));

/** By white balance and tone curve: matrix, curve, matrix, as files have it. */
function paintToned(planes, exposure, tone, out) {
  const factor = 2 ** exposure;
  const before = (status.balance ?? IDENTITY).map((row) => row.map((value) => value * factor));
  const into = [0, 1, 2].map((i) => [0, 1, 2].map((j) => tone.in[i].reduce((sum, value, k) => sum + value * before[k][j], 0)));
  const screen = bytesOfCurve(tone.decoding);
  const light = new Float32Array(3);
  const bits = new Uint32Array(light.buffer);
  const last = planes.length - 1;
  for (let i = 0, o = 0; i < planes[0].length; ++i, o += 4) {
    light.set(times(into, planes[0][i], planes[Math.min(1, last)][i], planes[last][i]));
    const value = (c) => (light[c] > 0 ? tone.values[bits[c] >>> 16] : 0);
    times(tone.out, value(0), value(1), value(2)).forEach((shown, c) => {
      out[o + c] = screen[Math.round(1000 * Math.min(Math.max(shown, 0), 1))];
    });
    out[o + 3] = 255;
  }
}

const IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/** Light that is cut at white, with enough steps in the dark: no table. */
function paintBalanced(planes, exposure, out) {
  const rows = status.balance.map((row) => row.map((value) => value * 2 ** exposure));
  for (let i = 0, o = 0; i < planes[0].length; ++i, o += 4) {
    times(rows, planes[0][i], planes[1][i], planes[2][i]).forEach((light, c) => {
      out[o + c] = screenByte(light);
    });
    out[o + 3] = 255;
  }
}

/** @param isLight  of a picture, and no AOV of features: it is balanced and toned. */
function paintLight(planes, isLight, exposure, out) {
  if (isLight && toneNow()) paintToned(planes, exposure, toneNow(), out);
  else if (isLight && status?.balance && planes.length === 3) paintBalanced(planes, exposure, out);
  else paintPlain(planes, exposure, out);
}

/** cd/m² of a pixel of 1, and the name of the unit; 1 and none where it is not known. */
const nits = () => status?.nits ?? 1;
const unit = () => (status?.nits ? " cd/m²" : "");

/** Illuminance of a matt surface: what it sends on is its reflectance over pi of what comes. */
function luxAt({ shown, albedo }, pixel) {
  const reflected = lightAt(albedo, pixel);
  return reflected > 0 ? (Math.PI * nits() * lightAt(shown, pixel)) / reflected : 0;
}

const scaledEnds = (exposure, factor, name) => DECADES.map((d) => `${shortNumber((factor * 10 ** d) / 2 ** exposure)}${name}`);

/** What each false colour needs: its map, where in [0,1] a pixel lies in it, and its ends. */
const MAPPED = {
  luminance: {
    name: "luminance",
    map: VIRIDIS,
    place: ({ shown }, i, exposure) => placeOfLuminance(lightAt(shown, i), exposure),
    ends: (exposure) => scaledEnds(exposure, nits(), unit()),
  },
  lux: {
    name: "illuminance, of matt surfaces",
    map: VIRIDIS,
    needs: ({ albedo, layer }) => albedo && layer === "picture",
    place: (sheet, i, exposure) => placeOfLuminance(luxAt(sheet, i) / (Math.PI * nits()), exposure),
    ends: (exposure) => scaledEnds(exposure, Math.PI * nits(), " lx"),
  },
  error: {
    name: "standard error over luminance",
    map: MAGMA,
    needs: (sheet) => sheet.error && !isMixed(sheet), // it is that of the light as it was rendered
    place: ({ shown, error }, i, exposure) =>
      ((error[i] / Math.max(Math.abs(lightAt(shown, i)), 1e-30)) * 2 ** exposure) / LARGEST_ERROR,
    ends: (exposure) => ["0", `${shortNumber((100 * LARGEST_ERROR) / 2 ** exposure)}%`],
  },
};

function paintMapped({ map, place }, sheet, exposure, out) {
  for (let i = 0, o = 0; i < sheet.shown[0].length; ++i, o += 4) {
    const at = 3 * Math.min(Math.max(Math.round(255 * place(sheet, i, exposure)), 0), 255);
    [out[o], out[o + 1], out[o + 2], out[o + 3]] = [map[at], map[at + 1], map[at + 2], 255];
  }
}

/** Paints a sheet on its canvas. @param show  light, or one of MAPPED: without what that needs it is
 *  light. @return what it was mapped by, if it was. */
function paint(sheet, show, exposure) {
  const { canvas, width, height } = sheet;
  canvas.hidden = sheet.number === 0;
  if (sheet.number === 0) return undefined;
  sheet.shown = mixedPlanes(sheet);
  const way = MAPPED[show];
  const mapped = way && (!way.needs || way.needs(sheet)) ? way : undefined;
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  if (mapped) paintMapped(mapped, sheet, exposure, image.data);
  else paintLight(sheet.shown, !FEATURES.includes(sheet.layer), exposure, image.data);
  context.putImageData(image, 0, 0);
  return mapped;
}
