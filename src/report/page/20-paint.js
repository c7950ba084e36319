// From pixels to what is on the screen: exposure, false colour, error maps.
"use strict";

const EPSILON = 0.01; // of the relative errors, as in the table

/** What each way of showing needs: the colours, and where in [0,1] a pixel lies in them. */
const SHOWS = {
  luminance: {
    name: "luminance",
    map: VIRIDIS,
    place: (p, r, exposure) => placeOfLuminance(p, exposure),
    range: endsOfLuminance,
  },
  relative: {
    name: "relative error of luminance",
    map: MAGMA,
    place: (p, r, exposure) => (Math.abs(p - r) / (r + EPSILON)) * 2 ** exposure,
    range: (exposure) => ["0", shortNumber(2 ** -exposure)],
  },
  signed: {
    name: "signed relative error of luminance",
    map: BLUE_RED,
    place: (p, r, exposure) => 0.5 + (0.5 * (p - r) * 2 ** exposure) / (r + EPSILON),
    range: (exposure) => [-1, 1].map((s) => (s > 0 ? "+" : "−") + shortNumber(2 ** -exposure)),
  },
  flip: { name: "FLIP", map: MAGMA, range: () => ["0", "1"] },
};

/** The byte on the screen of each half float. */
function screenBytes(exposure, scale) {
  const factor = 2 ** exposure / scale;
  return Uint8Array.from(HALF_VALUES, (value) => screenByte(value * factor));
}

function paintPicture(picture, exposure, out) {
  const bytes = screenBytes(exposure, picture.scale);
  const { halves } = picture;
  for (let i = 0, o = 0; i < halves.length; i += 3, o += 4) {
    out[o] = bytes[halves[i]];
    out[o + 1] = bytes[halves[i + 1]];
    out[o + 2] = bytes[halves[i + 2]];
  }
}

function luminances(picture) {
  if (!picture.luminance) {
    picture.luminance = new Float32Array(picture.halves.length / 3);
    for (let i = 0; i < picture.luminance.length; ++i) picture.luminance[i] = luminanceOf(valueAt(picture, i));
  }
  return picture.luminance;
}

function paintMapped(picture, show, exposure, out) {
  const { map, place } = SHOWS[show];
  const here = luminances(picture);
  const reference = luminances(pictures[0]);
  for (let i = 0, o = 0; i < here.length; ++i, o += 4) {
    const byte = show === "flip" ? picture.flip[i] : Math.round(255 * place(here[i], reference[i], exposure));
    const at = 3 * Math.min(Math.max(byte, 0), 255);
    out[o] = map[at];
    out[o + 1] = map[at + 1];
    out[o + 2] = map[at + 2];
  }
}

/** Pixels of which a channel is no number or infinite: bits of the exponent all set. */
function markBroken(picture, out) {
  const { halves } = picture;
  for (let i = 0, o = 0; i < halves.length; i += 3, o += 4) {
    const broken = [0, 1, 2].some((c) => (halves[i + c] & 0x7c00) === 0x7c00);
    if (broken) [out[o], out[o + 1], out[o + 2]] = [255, 0, 255];
    out[o + 3] = 255;
  }
}

/** The picture's canvas, painted. The reference has no error, and stays a picture. */
function paint(picture, show, exposure) {
  if (!picture.canvas) {
    picture.canvas = Object.assign(document.createElement("canvas"), size);
    picture.canvas.setAttribute("role", "img");
    picture.canvas.setAttribute("aria-label", picture.label);
  }
  const key = `${show} ${exposure}`;
  if (picture.painted === key) return picture.canvas;
  picture.painted = key;
  const context = picture.canvas.getContext("2d");
  const image = context.createImageData(size.width, size.height);
  const plain = show === "picture" || (picture.number === 0 && show !== "luminance");
  if (plain) paintPicture(picture, show === "picture" ? exposure : 0, image.data);
  else paintMapped(picture, show, exposure, image.data);
  markBroken(picture, image.data);
  context.putImageData(image, 0, 0);
  return picture.canvas;
}

function paintLegend(show, exposure) {
  const mapped = SHOWS[show]; // none of the picture as it is
  showLegend(mapped, mapped?.range(exposure));
}
