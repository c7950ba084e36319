// Works a page of `sunfleck compare` as a user does, in a real browser. See run.sh.
//   node page_test.mjs known                    writes known/bright.pfm
//   node page_test.mjs page CHROMIUM PAGE.html  exit code 1 at the first thing that is not right
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { everyControlHasAName, testPage, withBrowser } from "./harness.mjs";

const WIDTH = 64;
const HEIGHT = 48;
// Of bright.pfm: (10, 8) is bright beyond 1, (20, 8) is NaN, all else is grey.
const BRIGHT = [3, 1.5, 0.25];
const GREY = 0.5;

function writeKnown() {
  const pixels = new Float32Array(3 * WIDTH * HEIGHT).fill(GREY);
  const at = (x, y) => 3 * ((HEIGHT - 1 - y) * WIDTH + x); // rows from the bottom
  pixels.set(BRIGHT, at(10, 8));
  pixels[at(20, 8)] = NaN;
  const head = Buffer.from(`PF\n${WIDTH} ${HEIGHT}\n-1.0\n`);
  writeFileSync("known/bright.pfm", Buffer.concat([head, Buffer.from(pixels.buffer)]));
}

const screenByte = (light) => {
  const cut = Math.min(Math.max(light, 0), 1);
  return Math.round(255 * (cut <= 0.0031308 ? 12.92 * cut : 1.055 * cut ** (1 / 2.4) - 0.055));
};

/** The colour of a picture's pixel as the page has painted it. */
const painted = (page, label, x, y) =>
  page.evaluate(([l, px, py]) => {
    const canvas = document.querySelector(`#stage canvas[aria-label="${l}"]`);
    const copy = new OffscreenCanvas(1, 1).getContext("2d"); // so that the page's own stays as it is
    copy.drawImage(canvas, -px, -py);
    return [...copy.getImageData(0, 0, 1, 1).data.slice(0, 3)];
  }, [label, x, y]);

const transforms = (page) =>
  page.$$eval("#stage canvas", (all) => all.map((canvas) => canvas.style.transform));
const scaleOf = (transform) => Number(/scale\(([^)]+)\)/.exec(transform)[1]);

/** Where a picture's pixel is on the screen. */
const placeOf = (page, label, x, y) =>
  page.evaluate(([l, px, py]) => {
    const box = document.querySelector(`#stage canvas[aria-label="${l}"]`).getBoundingClientRect();
    return [box.left + ((px + 0.5) * box.width) / 64, box.top + ((py + 0.5) * box.height) / 48];
  }, [label, x, y]);

const near = (a, b, what) => a.forEach((value, i) => assert.ok(Math.abs(value - b[i]) <= 1, `${what}: ${a} is not ${b}`));

const TESTS = {
  async "split: the border follows the mouse and the keys"(page) {
    const clip = () => page.$eval("#upper", (layer) => layer.style.clipPath);
    assert.equal(await clip(), "inset(0px 0px 0px 50%)");
    const box = await page.locator("#divider").boundingBox();
    const stage = await page.locator("#stage").boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + 40);
    await page.mouse.down();
    await page.mouse.move(stage.x + stage.width / 4, box.y + 40, { steps: 4 });
    await page.mouse.up();
    assert.match(await clip(), /^inset\(0px 0px 0px 25(\.\d+)?%\)$/);
    await page.focus("#divider");
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.getAttribute("#divider", "aria-valuenow"), "27");
    await page.keyboard.press(",");
    assert.equal(await page.getAttribute("#divider", "aria-valuenow"), "25");
  },

  async "flicker: by key, by itself, and it stops"(page) {
    const upper = () => page.$eval("#upper", (layer) => layer.style.visibility);
    await page.keyboard.press("f");
    assert.equal(await upper(), "hidden");
    await page.keyboard.press(" ");
    assert.equal(await upper(), "visible");
    await page.keyboard.press(" ");
    assert.equal(await upper(), "hidden");
    await page.click("#timer");
    await page.waitForFunction(() => document.getElementById("upper").style.visibility === "visible");
    await page.waitForFunction(() => document.getElementById("upper").style.visibility === "hidden");
    await page.keyboard.press("t");
    assert.equal(await page.getAttribute("#timer", "aria-pressed"), "false");
    const seen = new Set();
    for (let i = 0; i < 15; ++i, await page.waitForTimeout(100)) seen.add(await upper());
    assert.equal(seen.size, 1, "it goes on");
  },

  async "exposure works on the light itself, beyond 1, too"(page) {
    await page.selectOption("#right", { label: "bright" });
    near(await painted(page, "bright", 10, 8), BRIGHT.map(screenByte), "at 0 EV");
    await page.focus("#exposure");
    await page.$eval("#exposure", (slider) => {
      slider.value = -2;
      slider.dispatchEvent(new Event("input"));
    });
    near(await painted(page, "bright", 10, 8), BRIGHT.map((v) => screenByte(v / 4)), "at -2 EV");
    assert.equal(await page.textContent("#exposure-value"), "-2 EV");
    await page.keyboard.press("e");
    near(await painted(page, "bright", 10, 8), BRIGHT.map((v) => screenByte(v * 2 ** -1.5)), "at -1.5 EV");
    assert.deepEqual(await painted(page, "bright", 20, 8), [255, 0, 255], "NaN is magenta");
  },

  async "values can be read under the cursor"(page) {
    await page.selectOption("#right", { label: "bright" });
    await page.keyboard.press("a");
    await page.mouse.move(...(await placeOf(page, "bright", 10, 8)));
    const text = await page.textContent("#readout");
    assert.match(text, /x 10 {2}y 8/);
    assert.match(text, /bright 3 1\.5 0\.25 {2}Y 1\.729/);
    await page.mouse.move(...(await placeOf(page, "bright", 20, 8)));
    assert.match(await page.textContent("#readout"), /bright NaN/);
  },

  async "zoom and place are one for all pictures"(page) {
    await page.keyboard.press("a");
    assert.equal((await transforms(page)).length, 4);
    const before = scaleOf((await transforms(page))[0]);
    const [x, y] = await placeOf(page, "uniform", 30, 20);
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, -300);
    await page.waitForTimeout(50);
    const zoomed = await transforms(page);
    assert.equal(new Set(zoomed).size, 1);
    assert.ok(Math.abs(scaleOf(zoomed[0]) / before - 2) < 0.01, `${zoomed[0]} after ${before}`);
    near(await placeOf(page, "uniform", 30, 20), [x, y], "what is under the cursor stays there");
    await page.mouse.down();
    await page.mouse.move(x + 50, y + 30, { steps: 3 });
    await page.mouse.up();
    near(await placeOf(page, "uniform", 30, 20), [x + 50, y + 30], "dragged");
    assert.equal(new Set(await transforms(page)).size, 1);
    await page.focus("#stage");
    await page.keyboard.press("ArrowLeft");
    near(await placeOf(page, "uniform", 30, 20), [x + 90, y + 30], "moved by key");
    await page.keyboard.press("z");
    assert.equal(scaleOf((await transforms(page))[0]), before);
  },

  async "error maps have the sign of the error, and a legend"(page) {
    await page.selectOption("#right", { label: "bright" });
    assert.equal(await page.isVisible("#legend"), false);
    await page.keyboard.press("g");
    assert.equal(await page.textContent("#legend-high"), "+1");
    assert.equal(await page.inputValue("#show"), "signed");
    const errors = await page.evaluate(() => {
      const p = pictures.find((one) => one.label === "bright");
      return [8 * 64 + 10, 47 * 64 + 32].map((i) => luminances(p)[i] - luminances(pictures[0])[i]);
    });
    assert.ok(errors[0] > 0);
    const [red, , blue] = await painted(page, "bright", 10, 8);
    assert.ok(red > blue, "brighter is red");
    await page.keyboard.press("v");
    assert.equal(await page.textContent("#legend-name"), "FLIP");
    await page.keyboard.press("l");
    // Luminance 0.5 of 0.001 to 10 lies at 0.675 of viridis: green.
    const [r, g, b] = await painted(page, "bright", 40, 30);
    assert.ok(g > r && g > b, `${[r, g, b]} is no green`);
  },

  async "left and right are never the same picture"(page) {
    await page.selectOption("#left", { label: "uniform" });
    assert.notEqual(await page.inputValue("#left"), await page.inputValue("#right"));
    await page.keyboard.press("x");
    assert.equal(await page.inputValue("#right"), "1");
    await page.locator("#stage").focus();
    await page.keyboard.press("3");
    assert.equal(await page.inputValue("#right"), "3");
    await page.keyboard.press("]");
    assert.notEqual(await page.inputValue("#right"), "3");
  },

  async "the table is copied, and says what it left out"(page) {
    await page.keyboard.press("c");
    await page.waitForFunction(() => document.getElementById("said").textContent !== "");
    const text = await page.evaluate(() => navigator.clipboard.readText());
    const rows = text.trimEnd().split("\n").map((row) => row.split("\t"));
    assert.deepEqual(rows.map((row) => row[0]), ["picture", "uniform", "adaptive", "bright"]);
    assert.ok(Number(rows[1][1]) > 0);
    assert.equal(rows[3].at(-1), "1");
    assert.match(await page.textContent("#notes"), /bright: 1 of 3072 pixels/);
    // And where the browser keeps the clipboard from the page:
    await page.evaluate(async () => {
      await navigator.clipboard.writeText("");
      navigator.clipboard.writeText = () => Promise.reject(new Error("refused"));
    });
    await page.click("#copy");
    await page.waitForTimeout(100);
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), text);
  },

  async "curves are drawn for each series, metric and axis"(page) {
    const drawn = () => page.$eval("#chart", (canvas) => canvas.toDataURL());
    const first = await drawn();
    const colours = await page.$eval("#chart", (canvas) => {
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
      const seen = new Set();
      for (let i = 0; i < data.length; i += 4) if (data[i + 3] === 255) seen.add(data.slice(i, i + 3).join());
      return [...seen];
    });
    for (const colour of ["0,114,178", "213,94,0"]) assert.ok(colours.includes(colour), colour);
    assert.equal(await page.locator("#series-table tbody tr").count(), 8, "2 series, 4 points each");
    await page.selectOption("#series-axis", "passes");
    const passes = await drawn();
    assert.notEqual(passes, first);
    await page.selectOption("#series-metric", "flip");
    assert.notEqual(await drawn(), passes);
  },

  async "help lists the keys, and Escape closes it"(page) {
    await page.keyboard.press("?");
    assert.equal(await page.isVisible("#help"), true);
    assert.ok((await page.locator("#keys dt").count()) > 20);
    await page.keyboard.press("Escape");
    assert.equal(await page.isVisible("#help"), false);
  },

  "every control has a name": everyControlHasAName,
};

async function testCompare(chromiumPath, file) {
  const url = `file://${file}`;
  const layouts = ["split", "flicker", "all"].map((layout) => `[data-layout=${layout}]`);
  const page = { name: "compare", url, tests: TESTS, isOwn: (asked) => asked === url, layouts };
  await withBrowser(chromiumPath, async (browser) => {
    await testPage(browser, page, 1400, "light");
    await testPage(browser, page, 360, "dark");
  });
}

const [, , task, ...rest] = process.argv;
if (task === "known") writeKnown();
else await testCompare(...rest);
