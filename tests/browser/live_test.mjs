// Works the page of a render under way as a user does, in a real browser. See run.sh.
//   node live_test.mjs CHROMIUM SUNFLECK SCENE  exit code 1 at the first thing that is not right
import assert from "node:assert/strict";
import { existsSync, rmSync } from "node:fs";
import { everyControlHasAName, testPage, withBrowser } from "./harness.mjs";
import { brightness, passesOf, scale, SIZE, startRender, waitForPass, waitForPicture, wayTo } from "./live_support.mjs";

const [, , chromiumPath, ...rendered] = process.argv; // program and scene
/* global byId, sheets, status, tones: of the page */

const TESTS = {
  async "the picture grows, and the numbers with it"(page) {
    await waitForPicture(page);
    const before = await passesOf(page);
    await waitForPass(page, before + 2);
    assert.ok((await brightness(page)) > 5);
    assert.notEqual(await page.textContent("#time"), "–");
    assert.match(await page.textContent("#readout"), /^x \d+ +y \d+ +picture /);
    assert.equal(await page.isVisible("#veil"), false);
  },

  async "exposure acts at once, and follows the .png again"(page) {
    await waitForPicture(page);
    const before = await brightness(page);
    await page.$eval("#exposure", (slider) => {
      slider.value = 2;
      slider.dispatchEvent(new Event("input"));
    });
    assert.ok((await brightness(page)) > 1.2 * before);
    assert.equal(await page.textContent("#exposure-value"), "+2.0");
    await page.click("#follow");
    assert.equal(await page.textContent("#exposure-value"), "0.0");
    await page.focus("#stage");
    await page.keyboard.press("E");
    assert.equal(await page.textContent("#exposure-value"), "-0.5");
  },

  async "tone curves act at once, and follow the .png again"(page) {
    await waitForPicture(page);
    const before = await brightness(page);
    await page.selectOption("#tone", "agx");
    await page.waitForFunction(() => tones.has("agx"));
    await page.waitForTimeout(100);
    assert.ok(Math.abs((await brightness(page)) / before - 1) > 0.05);
    await page.click("#follow");
    await page.waitForTimeout(100);
    assert.ok(Math.abs((await brightness(page)) / before - 1) < 0.05);
    assert.equal(await page.inputValue("#tone"), "none");
  },

  async "layers and false colours, with their ends"(page) {
    await waitForPass(page, 3);
    await waitForPicture(page);
    const layers = await page.$$eval("#layer option", (all) => all.map((e) => e.value));
    assert.deepEqual(layers.slice(0, 3), ["picture", "direct", "indirect"]);
    await page.selectOption("#layer", "indirect");
    await page.waitForFunction(() => document.getElementById("readout").textContent.includes("indirect"));
    await page.selectOption("#show", "luminance");
    assert.match(await page.textContent("#legend-high"), /^6830 cd\/m²$/);
    await page.selectOption("#layer", "picture");
    await page.selectOption("#show", "lux");
    await page.waitForFunction(() => document.getElementById("readout").textContent.includes("lx if matt"));
    assert.match(await page.textContent("#legend-high"), / lx$/);
    await page.waitForFunction(() => !byId("error-way").disabled, null, { timeout: 60_000 });
    await page.selectOption("#show", "error");
    assert.equal(await page.textContent("#legend-high"), "50%");
  },

  async "lamps are mixed, and saved as relight does"(page) {
    await waitForPass(page, 3);
    await waitForPicture(page);
    assert.equal(await page.isVisible("#groups-panel"), true);
    const slider = await page.$("#groups input[type=range]");
    const before = await brightness(page);
    const set = (value) => slider.evaluate((e, v) => {
      e.value = v;
      e.dispatchEvent(new Event("input"));
    }, value);
    await set(0);
    await page.waitForFunction(() => sheets.render.parts !== null, null, { timeout: 20_000 });
    await page.waitForTimeout(100);
    assert.ok((await brightness(page)) < 0.05 * before, "the only lamp is off");
    assert.match(await page.textContent("#relight-words"), /^sunfleck relight PICTURE.exr light1=0,0,0 -o OUT.exr$/);
    await page.fill("#groups input[type=color]", "#ff0000");
    await set(1);
    assert.match(await page.textContent("#relight-words"), /light1=1,0,0/);
    const bytes = await page.evaluate(async () => (await (await fetch(byId("save-exr").href)).arrayBuffer()).byteLength);
    assert.ok(bytes > 1000);
    await page.click("#groups button");
    assert.equal(await page.textContent("#relight-words"), "");
  },

  async "a region is rendered in a frame that is drawn, and the render goes on"(page) {
    await waitForPass(page, 2);
    await waitForPicture(page);
    await page.click("[data-drag=region]");
    const box = await page.locator("#stage").boundingBox();
    const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
    await page.mouse.move(...at(0.4, 0.4));
    await page.mouse.down();
    await page.mouse.move(...at(0.6, 0.6), { steps: 3 });
    assert.equal(await page.isVisible("#marquee"), true);
    await page.mouse.up();
    await page.waitForFunction(() => status?.look?.passes > 0 && sheets.look.number > 0, null, { timeout: 30_000 });
    const [x0, x1] = await page.evaluate(() => status.look.region);
    assert.ok(x0 > 0 && x1 < SIZE.width, `${x0} to ${x1}`);
    assert.match(await page.textContent("#aside-text"), /^A look aside, \d+ x \d+ pixels/);
    assert.ok((await brightness(page, "look")) > 5);
    const stood = await passesOf(page);
    await page.waitForTimeout(300);
    assert.equal(await passesOf(page), stood, "the render waits");
    await page.focus("#stage");
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => status.look === null);
    await waitForPass(page, stood + 1);
    assert.equal(await page.isVisible("#aside"), false);
    await page.click("[data-drag=move]");
  },

  async "the camera is turned by keys and mouse, and its words are shown"(page) {
    await waitForPass(page, 1);
    await page.focus("#stage");
    await page.keyboard.press("c");
    await page.keyboard.press("ArrowLeft");
    await page.waitForFunction(() => sheets.look.number > 0, null, { timeout: 30_000 });
    await page.waitForFunction(() => status?.look?.passes > 0, null, { timeout: 30_000 });
    assert.match(await page.textContent("#camera-words"), /Transform[^]*Camera "perspective"/);
    const before = await page.textContent("#camera-words");
    const box = await page.locator("#stage").boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 40, box.y + box.height / 2 + 5, { steps: 4 });
    await page.mouse.up();
    await page.waitForFunction((words) => byId("camera-words").textContent !== words, before, { timeout: 30_000 });
    await page.click("#back");
    await page.waitForFunction(() => status.look === null);
    await page.click("[data-drag=move]");
    assert.equal(await page.isDisabled("#focus-way"), true, "this camera has no lens");
  },

  async "it pauses, and goes on"(page) {
    await waitForPass(page, 2);
    await page.click("#pause");
    await page.waitForFunction(() => status.is_paused);
    assert.equal(await page.textContent("#stage-text"), "paused");
    const stood = await passesOf(page);
    await page.waitForTimeout(500);
    assert.equal(await passesOf(page), stood);
    await page.focus("#stage");
    await page.keyboard.press(" ");
    await waitForPass(page, stood + 1);
  },

  async "a picture is held, and wiped over the later one"(page) {
    await waitForPass(page, 2);
    await waitForPicture(page);
    await page.click("#hold");
    assert.match(await page.textContent("#wipe-name"), /^held at \d+ pass/);
    assert.equal(await page.isVisible("#wipe"), true);
    assert.ok((await brightness(page, "earlier")) > 5);
    await page.$eval("#wipe-at", (slider) => {
      slider.value = 0;
      slider.dispatchEvent(new Event("input"));
    });
    assert.equal(await page.isVisible("#wipe"), false);
  },

  async "the histogram tells what is brighter than white"(page) {
    await waitForPicture(page);
    assert.match(await page.textContent("#histogram-text"), /^[\d.]+% brighter than white$/);
    const before = Number.parseFloat(await page.textContent("#histogram-text"));
    await page.$eval("#exposure", (slider) => {
      slider.value = 8;
      slider.dispatchEvent(new Event("input"));
    });
    assert.ok(Number.parseFloat(await page.textContent("#histogram-text")) > before + 20);
  },

  async "what cannot be is said, and nothing is lost"(page) {
    await waitForPass(page, 1);
    await page.fill("#end-error", "x");
    await page.click("#ends button");
    await page.waitForFunction(() => byId("fault").textContent.includes("error"));
    await page.fill("#end-error", "0.001");
    await page.click("#ends button");
    await page.waitForFunction(() => byId("ends-text").textContent === "Ends at 0.001%");
    assert.equal(await page.textContent("#fault"), "");
  },

  async "wheel, keys and mouse move it"(page) {
    await waitForPicture(page);
    const before = await scale(page);
    await page.hover("#stage");
    await page.mouse.wheel(0, -300);
    assert.ok(Math.abs((await scale(page)) / before - 2) < 0.01);
    await page.focus("#stage");
    await page.keyboard.press("f");
    assert.ok(Math.abs((await scale(page)) / before - 1) < 0.01);
    await page.keyboard.press("1");
    assert.equal(await page.textContent("#zoom-value"), "100%");
    const where = await page.textContent("#readout");
    await page.keyboard.press("ArrowRight");
    assert.notEqual(await page.textContent("#readout"), where);
  },

  "every control has a name": everyControlHasAName,
};

/** A page whose connection is lost says so, and goes on by itself when it is back. */
async function testSleep(browser, url) {
  const way = await wayTo(Number(new URL(url).port));
  const page = await browser.newPage();
  await page.goto(url.replace(/:\d+/, `:${way.port}`));
  await waitForPass(page, 1);
  way.cut();
  await page.waitForFunction(() => byId("stage-text").textContent.startsWith("connection lost"), null, { timeout: 30_000 });
  const stood = await passesOf(page);
  await way.mend();
  await waitForPass(page, stood + 2);
  await page.waitForFunction(() => !byId("stage-text").textContent.startsWith("connection lost"));
  await page.close();
  way.cut();
  console.log("ok: live: a connection that is lost and comes back");
}

/** The page of a render that ends says so, and that of one that is stopped keeps its picture. */
async function testEnds(browser) {
  const { ended, url } = await startRender(rendered, ["--passes", "100000", "-o", "live.exr"]);
  const page = await browser.newPage();
  await page.goto(url);
  await waitForPass(page, 2);
  await page.focus("#stop");
  await page.keyboard.press("Enter");
  assert.equal(await ended, 130);
  assert.ok(existsSync("live.exr"));
  await page.waitForFunction(() => document.getElementById("stage-text").textContent.includes("finished"));
  await waitForPicture(page);
  console.log("ok: live: stop and keep");
}

rmSync("live.exr", { force: true });
const { child, ended, url } = await startRender(rendered, ["--passes", "100000", "-o", "watched.exr"]);
const page = {
  name: "live",
  url,
  tests: TESTS,
  allows: (text) => text.includes("status of 400"), // the answer to a wish that makes no sense
  isOwn: (asked) => asked.startsWith(new URL(url).origin),
};
try {
  await withBrowser(chromiumPath, async (browser) => {
    for (const [width, colours] of [[1400, "light"], [800, "dark"], [360, "dark"]]) await testPage(browser, page, width, colours);
    await testSleep(browser, url);
    await testEnds(browser);
  });
} finally {
  child.kill("SIGINT");
  await ended;
}
