// Light groups: the light of each, times a factor, is mixed here, as `sunfleck relight` does it.
"use strict";

const REST_OF_LIGHT = "rest of light";

/** By group: level and colour, `#rrggbb`, as the user has set them. */
const lamps = new Map();
const lampOf = (group) => lamps.get(group) ?? { level: 1, colour: "#ffffff" };

/** Light of a byte of sRGB. */
function lightOfByte(byte) {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

/** The factors of a group: level times the light of the colour, in six digits. */
function factorsOf(group) {
  const { level, colour } = lampOf(group);
  return [1, 3, 5].map((i) => Number((level * lightOfByte(parseInt(colour.slice(i, i + 2), 16))).toPrecision(6)));
}

const isChanged = (group) => factorsOf(group).some((factor) => factor !== 1);
const changedGroups = () => [...lamps.keys()].filter(isChanged).sort();

/** NAME=R,G,B of each group that is changed, as `relight` reads them. */
const factorWords = () => changedGroups().map((group) => `${group}=${factorsOf(group).join(",")}`);

/** Whether a sheet shows other light than was rendered. */
const isMixed = ({ layer, parts }) => layer === "picture" && parts !== null && changedGroups().length > 0;

/** The planes of a sheet under the lamps as they are set. */
function mixedPlanes(sheet) {
  if (!isMixed(sheet)) return sheet.planes;
  const all = Object.entries(sheet.parts.groups).map(([group, planes]) => ({ planes, factors: factorsOf(group) }));
  return sheet.parts.rest.map((rest, c) => {
    const sum = Float32Array.from(rest);
    for (const { planes, factors } of all) {
      const plane = planes[c];
      const factor = factors[c];
      for (let i = 0; i < sum.length; ++i) sum[i] += factor * plane[i];
    }
    return sum;
  });
}

/** Makes a row for each group. @param changed  called when a lamp is set. */
function showGroups(groups, changed) {
  const panel = byId("groups");
  byId("groups-panel").hidden = groups.length === 0;
  if ([...panel.children].map((row) => row.dataset.group).join() === groups.join()) return;
  panel.replaceChildren(...groups.map((group) => lampRow(group, changed)));
}

function lampRow(group, changed) {
  const row = Object.assign(document.createElement("div"), { className: "lamp" });
  row.dataset.group = group;
  const { level, colour } = lampOf(group);
  const name = Object.assign(document.createElement("span"), { textContent: group, className: "name" });
  const slider = Object.assign(document.createElement("input"), { type: "range", min: 0, max: 4, step: 0.01, value: level });
  const value = document.createElement("output");
  const chooser = Object.assign(document.createElement("input"), { type: "color", value: colour });
  const off = Object.assign(document.createElement("button"), { type: "button", textContent: "×1", title: "As it was rendered" });
  slider.setAttribute("aria-label", `Brightness of ${group}`);
  chooser.setAttribute("aria-label", `Colour of ${group}`);
  off.setAttribute("aria-label", `${group} as it was rendered`);
  const set = () => {
    value.textContent = Number(slider.value).toFixed(2);
    lamps.set(group, { level: Number(slider.value), colour: chooser.value });
    changed();
  };
  slider.addEventListener("input", set);
  chooser.addEventListener("input", set);
  off.addEventListener("click", () => {
    [slider.value, chooser.value] = [1, "#ffffff"];
    set();
  });
  value.textContent = level.toFixed(2);
  row.append(name, slider, value, chooser, off);
  return row;
}
