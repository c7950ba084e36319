// The pictures: layers as the render sends them, numbers of 16 bits (the upper halves of floats).
"use strict";

const token = new URLSearchParams(location.search).get("token") ?? "";
const address = (path, more = {}) => `${path}?${new URLSearchParams([...Object.entries(more), ["token", token]].flatMap(
  ([name, value]) => (Array.isArray(value) ? value.map((one) => [name, one]) : [[name, value]])))}`;

/** A picture of its own: `planes` has an array of numbers for each channel of the layer, `shown` the
 *  same under the lamps as they are set, `error` those of the standard error, if it is known, `parts` the light of each group and the rest,
 *  `albedo` the reflectance, where they are wanted; `region`: the pixels x0 x1 y0 y1 of the whole
 *  picture that it shows, null for all. */
const newSheet = (of) => ({
  of, number: 0, layer: "", width: 0, height: 0, planes: [], shown: [], error: null, parts: null, albedo: null, region: null,
  canvas: byId(`canvas-${of}`),
});
const sheets = { render: newSheet("render"), look: newSheet("look"), earlier: newSheet("earlier") };

const emptySheet = (sheet) =>
  Object.assign(sheet, { number: 0, layer: "", planes: [], shown: [], error: null, parts: null, albedo: null, region: null });

function numbersOf(halves) {
  const bits = new Uint32Array(halves.length);
  for (let i = 0; i < halves.length; ++i) bits[i] = halves[i] << 16;
  return new Float32Array(bits.buffer);
}

/** The numbers of a layer, or null where there is no picture. */
async function fetchLayer(of, layer) {
  const answer = await fetch(address("picture", { of, layer }));
  if (answer.status !== 200) return null;
  const [width, height, number] = ["X-Width", "X-Height", "X-Number"].map((name) => Number(answer.headers.get(name)));
  const halves = new Uint16Array(await answer.arrayBuffer());
  const pixels = width * height;
  const planes = [];
  for (let begin = 0; begin < halves.length; begin += pixels) planes.push(numbersOf(halves.subarray(begin, begin + pixels)));
  return { number, width, height, planes, layer: answer.headers.get("X-Layer") };
}

/** The planes of a layer beside another one, or null where there is none of that size. */
async function fetchBeside(of, layer, layers, picture) {
  if (!layers.includes(layer)) return null;
  const other = await fetchLayer(of, layer);
  return other && other.width === picture.width && other.height === picture.height ? other.planes : null;
}

/** Takes the latest picture into a sheet. @param wants  layer; parts, albedo: whether these, too.
 *  @param has  layers and groups that there are. @return whether it came. */
async function takePicture(sheet, wants, has) {
  const picture = await fetchLayer(sheet.of, wants.layer);
  if (!picture) return false;
  const beside = (layer) => fetchBeside(sheet.of, layer, [...has.layers, REST_OF_LIGHT], picture);
  const error = await beside("error");
  const albedo = wants.albedo ? await beside("albedo") : null;
  let parts = null;
  if (wants.parts && has.groups.length > 0) {
    parts = { rest: await beside(REST_OF_LIGHT), groups: {} };
    for (const group of has.groups) parts.groups[group] = await beside(group);
    if (!parts.rest || Object.values(parts.groups).includes(null)) parts = null; // a new picture has come between
  }
  Object.assign(sheet, picture, { error: error?.[0] ?? null, albedo, parts });
  return true;
}

/** The luminance of a pixel; of a layer of one channel, its number. */
function lightAt(planes, pixel) {
  return planes.length === 3 ? luminanceOf([planes[0][pixel], planes[1][pixel], planes[2][pixel]]) : planes[0][pixel];
}
