// The picture: its layers as the render sends them, numbers of 16 bits (the upper halves of floats).
"use strict";

const token = new URLSearchParams(location.search).get("token") ?? "";
const address = (path, more = {}) => `${path}?${new URLSearchParams({ ...more, token })}`;

/** What is shown: `planes` has an array of numbers for each channel of the layer, `error` those of
 *  the standard error, if it is known. */
const shown = { number: 0, layer: "", width: 0, height: 0, planes: [], error: null };

/** The numbers of a layer, or null where there is no picture. */
async function fetchLayer(layer) {
  const answer = await fetch(address("picture", { layer }));
  if (answer.status !== 200) return null;
  const [width, height, number] = ["X-Width", "X-Height", "X-Number"].map((name) => Number(answer.headers.get(name)));
  const halves = new Uint16Array(await answer.arrayBuffer());
  const pixels = width * height;
  const planes = [];
  for (let begin = 0; begin < halves.length; begin += pixels) planes.push(numbersOf(halves.subarray(begin, begin + pixels)));
  return { number, width, height, planes, layer: answer.headers.get("X-Layer") };
}

function numbersOf(halves) {
  const bits = new Uint32Array(halves.length);
  for (let i = 0; i < halves.length; ++i) bits[i] = halves[i] << 16;
  return new Float32Array(bits.buffer);
}

/** Takes the latest picture. @param layers  that there are. @return whether it came. */
async function takePicture(layer, layers) {
  const picture = await fetchLayer(layer);
  if (!picture) return false;
  const error = layers.includes("error") ? await fetchLayer("error") : null;
  const fits = error && error.width === picture.width && error.height === picture.height;
  Object.assign(shown, picture, { error: fits ? error.planes[0] : null });
  return true;
}

/** The numbers of a pixel, by channel. */
const valueAt = (pixel) => shown.planes.map((plane) => plane[pixel]);

/** The luminance of a pixel; of a layer of one channel, its number. */
function lightAt(pixel) {
  const { planes } = shown;
  return planes.length === 3 ? luminanceOf([planes[0][pixel], planes[1][pixel], planes[2][pixel]]) : planes[0][pixel];
}
