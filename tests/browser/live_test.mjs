// Works the page of a render under way as a user does, in a real browser. See run.sh.
//   node live_test.mjs CHROMIUM SUNFLECK SCENE  exit code 1 at the first thing that is not right
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, rmSync } from "node:fs";

const [, , chromiumPath, program, scene] = process.argv;
const SIZE = { width: 160, height: 120 };

/** A render under way, once it has said its address. */
async function startRender(more) {
  const words = ["render", scene, "--resolution", `${SIZE.width}x${SIZE.height}`, "--photons-per-pass", "20000",
    "--aovs", "direct,indirect", "--view", ...more];
  const child = spawn(program, words);
  const ended = new Promise((resolve) => child.on("close", resolve));
  const url = await new Promise((resolve) => {
    let said = "";
    child.stderr.on("data", (data) => {
      said += data;
      if (said.includes("\n")) resolve(said.split("\n")[0]);
    });
  });
  return { child, ended, url };
}

const passesOf = (page) => page.$eval("#passes", (e) => Number.parseInt(e.textContent, 10) || 0);
const waitForPass = (page, pass) =>
  page.waitForFunction((n) => Number.parseInt(document.getElementById("passes").textContent, 10) >= n, pass, { timeout: 60_000 });
const waitForPicture = (page) =>
  page.waitForFunction((width) => document.getElementById("canvas").width === width, SIZE.width, { timeout: 60_000 });

/** The mean byte of the canvas. */
const brightness = (page) =>
  page.$eval("#canvas", (canvas) => {
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d"); // the page's own stays as it is
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) sum += data[i] + data[i + 1] + data[i + 2];
    return sum / data.length;
  });
const scale = (page) => page.$eval("#canvas", (c) => Number(/scale\(([^,)]+)/.exec(c.style.transform)[1]));

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

  async "layers and false colours, with their ends"(page) {
    await waitForPass(page, 3);
    await waitForPicture(page);
    const layers = await page.$$eval("#layer option", (all) => all.map((e) => e.value));
    assert.deepEqual(layers.slice(0, 3), ["picture", "direct", "indirect"]);
    await page.selectOption("#layer", "indirect");
    await page.waitForFunction(() => document.getElementById("readout").textContent.includes("indirect"));
    await page.selectOption("#show", "luminance");
    assert.equal(await page.textContent("#legend-high"), "10");
    await page.selectOption("#show", "error");
    assert.equal(await page.textContent("#legend-high"), "50%");
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

  async "every control has a name"(page) {
    const nameless = await page.$$eval("button, select, input, canvas[role], [role=application]", (all) =>
      all.filter((e) => !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length)).map((e) => e.outerHTML));
    assert.deepEqual(nameless, []);
  },
};

async function testAt(browser, url, width, colorScheme) {
  for (const [name, test] of Object.entries(TESTS)) {
    const page = await browser.newPage({ viewport: { width, height: 800 }, colorScheme });
    const faults = [];
    page.on("console", (message) => faults.push(`console: ${message.text()}`));
    page.on("pageerror", (error) => faults.push(`error: ${error.message}`));
    page.on("requestfailed", (r) => faults.push(`request: ${r.url()} ${r.failure()?.errorText}`));
    await page.goto(url);
    try {
      await test(page);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(overflow <= 0, `the page is ${overflow} pixels too wide`);
      assert.deepEqual(faults, []);
    } catch (error) {
      error.message = `live: ${name}, ${width} pixels wide: ${error.message}`;
      throw error;
    }
    await page.close();
    console.log(`ok: live: ${name}, ${width} pixels wide`);
  }
}

/** The page of a render that ends says so, and that of one that is stopped keeps its picture. */
async function testEnds(browser) {
  const { ended, url } = await startRender(["--passes", "100000", "-o", "live.exr"]);
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
const { chromium } = await import("playwright-core");
const browser = await chromium.launch({ executablePath: chromiumPath });
const { child, ended, url } = await startRender(["--passes", "100000", "-o", "watched.exr"]);
try {
  for (const [width, colours] of [[1400, "light"], [800, "dark"], [360, "dark"]]) await testAt(browser, url, width, colours);
  await testEnds(browser);
} finally {
  child.kill("SIGINT");
  await ended;
  await browser.close();
}
