// What is shown, and the stream of what the render says.
"use strict";

const LARGEST_EXPOSURE = Number(byId("exposure").max);
const settings = { layer: "picture", show: "light", exposure: 0, tone: "none", follows: true };
let isTaking = false;

/** The sheet that is judged: the look aside where there is one. */
const mainSheet = () => (sheets.look.number !== 0 ? sheets.look : sheets.render);

function repaint() {
  let mapped;
  for (const sheet of Object.values(sheets)) {
    const by = paint(sheet, settings.show, settings.exposure);
    if (sheet === mainSheet()) mapped = by;
  }
  showLegend(mapped, mapped?.ends(settings.exposure));
  showHistogram(mainSheet(), settings.exposure);
  tellLamps();
  place();
}

/** What the render has for each sheet. */
const offered = () => ({ render: status.picture, look: status.look?.picture, earlier: status.earlier_picture });

/** What is wanted of a sheet beside its layer. */
const wanted = () => ({ layer: settings.layer, parts: changedGroups().length > 0, albedo: settings.show === "lux" });

function isStale(sheet, has) {
  if (sheet.isHeld) return false;
  if (!has || has.number === 0) return sheet.number !== 0;
  const wants = wanted();
  const layer = has.layers.includes(wants.layer) ? wants.layer : has.layers[0];
  const lacksParts = wants.parts && layer === "picture" && has.groups.length > 0 && !sheet.parts;
  const lacksAlbedo = wants.albedo && has.layers.includes("albedo") && !sheet.albedo;
  return has.number !== sheet.number || layer !== sheet.layer || lacksParts || lacksAlbedo;
}

async function takeSheet(sheet, has) {
  if (!has || has.number === 0) {
    emptySheet(sheet);
    return;
  }
  const region = sheet.of === "look" ? status.look?.region ?? null : null;
  if (await takePicture(sheet, wanted(), has)) sheet.region = region;
}

/** Takes pictures one after the other, as fast as they come and no faster; none while hidden. */
async function keepUp() {
  if (isTaking || document.hidden || !status) return;
  isTaking = true;
  let isAgain = false;
  try {
    for (const sheet of Object.values(sheets)) {
      if (!isStale(sheet, offered()[sheet.of])) continue;
      await takeSheet(sheet, offered()[sheet.of]);
      isAgain = isAgain || isStale(sheet, offered()[sheet.of]);
      repaint();
    }
  } catch {
    // The connection is lost, or the render has ended: the stream of texts tells.
  }
  isTaking = false;
  tellStage();
  if (isAgain) setTimeout(keepUp, 100);
}

function setExposure(stops, follows) {
  settings.follows = follows;
  settings.exposure = within(Math.round(10 * stops) / 10, -LARGEST_EXPOSURE, LARGEST_EXPOSURE);
  byId("exposure").value = settings.exposure;
  byId("exposure-value").textContent = (settings.exposure > 0 ? "+" : "") + settings.exposure.toFixed(1);
  byId("follow").setAttribute("aria-pressed", follows);
  repaint();
}

async function setTone(name) {
  settings.tone = name;
  byId("tone").value = name;
  repaint();
  if (await takeTone()) repaint();
}

/** Takes exposure and tone of the .png, now and as they change. */
function followPng() {
  setExposure(status?.exposure ?? 0, true);
  setTone(status?.tone ?? "none");
}

function setOptions(select, names, chosen) {
  const before = [...select.options].map((option) => option.value).join();
  if (before === names.join()) return;
  select.replaceChildren(...names.map((name) => new Option(name, name)));
  select.value = names.includes(chosen) ? chosen : names[0];
}

/** The words of `relight` for the lamps as they are set, and where their picture is. */
function tellLamps() {
  const words = factorWords();
  const source = mainSheet().of;
  byId("relight-words").textContent = words.length > 0 ? `sunfleck relight PICTURE.exr ${words.join(" ")} -o OUT.exr` : "";
  byId("save-exr").href = address("file", { of: source, factor: words });
  byId("save-exr").hidden = mainSheet().number === 0;
}

function take(text) {
  const { age, status: latest } = JSON.parse(text);
  status = latest;
  since = performance.now() - 1000 * age;
  setSize(status.width, status.height);
  const { layers, groups } = status.picture;
  setOptions(byId("layer"), layers.length > 0 ? layers : ["picture"], settings.layer);
  settings.layer = byId("layer").value;
  showGroups(groups, lampsSet);
  byId("lux").hidden = !layers.includes("albedo") || !status.nits;
  byId("error-way").disabled = !layers.includes("error"); // it is known after two batches of passes
  byId("wipe-panel").hidden = sheets.earlier.number === 0 && status.earlier_picture.number === 0;
  if (!sheets.earlier.isHeld) byId("wipe-name").textContent = status.earlier;
  if (settings.follows && (settings.exposure !== status.exposure || settings.tone !== status.tone)) followPng();
  tellNumbers();
  tellLook();
  tellStage();
  placeMarquee();
  keepUp();
}

function lampsSet() {
  repaint();
  keepUp(); // the parts, where they are not there yet
}

/** Keeps the picture as it stands, to compare later ones with. */
function hold() {
  const { render, earlier } = sheets;
  if (render.number === 0) return;
  Object.assign(earlier, { ...render, of: "earlier", canvas: earlier.canvas, isHeld: true });
  byId("wipe-panel").hidden = false;
  byId("wipe-name").textContent = `held at ${status.passes} passes`;
  setWipe(0.5);
  repaint();
}

function setWipe(share) {
  view.wipe = within(share, 0, 1);
  byId("wipe-at").value = view.wipe;
  place();
}

/** What is seen, as a .png in the browser's downloads. */
function savePng() {
  const { canvas } = mainSheet();
  canvas.toBlob((blob) => {
    const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: "sunfleck.png" });
    link.click();
    URL.revokeObjectURL(link.href);
  });
}

const texts = new EventSource(address("texts"));
texts.onmessage = (event) => take(event.data);
texts.onerror = () => {
  // A render that has ended and gone is no fault.
  if (status?.stage === "ended") return texts.close();
  byId("stage-text").textContent = "connection lost: the render has gone, or is out of reach; trying again";
};
document.addEventListener("visibilitychange", keepUp);
setInterval(tellTime, 1000);
