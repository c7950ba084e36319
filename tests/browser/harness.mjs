// What the tests of pages have in common: each test opens the page anew, and ends with no fault
// and nothing that is too wide.
import assert from "node:assert/strict";

/** Runs the tests of a page at a width.
 *  @param page  { name, url, tests: by name, each of a Playwright page }; if wanted
 *               allows(text): a message of the console that is no fault; isOwn(url): of a request;
 *               layouts: what to click on for each layout that there is. */
export async function testPage(browser, { name: of, url, tests, allows, isOwn, layouts = [null] }, width, colorScheme) {
  for (const [name, test] of Object.entries(tests)) {
    const context = await browser.newContext({ viewport: { width, height: 800 }, colorScheme });
    await context.grantPermissions(["clipboard-read", "clipboard-write"]);
    const page = await context.newPage();
    const faults = [];
    page.on("console", (message) => {
      if (!allows?.(message.text())) faults.push(`console: ${message.text()}`);
    });
    page.on("pageerror", (error) => faults.push(`error: ${error.message}`));
    page.on("requestfailed", (request) => faults.push(`request: ${request.url()} ${request.failure()?.errorText}`));
    page.on("request", (request) => {
      if (!isOwn(request.url()) && !request.url().startsWith("data:")) faults.push(`request: ${request.url()}`);
    });
    await page.goto(url);
    try {
      await test(page);
      for (const layout of layouts) {
        if (layout) await page.click(layout);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(overflow <= 0, `the page is ${overflow} pixels too wide`);
      }
      assert.deepEqual(faults, []);
    } catch (error) {
      error.message = `${of}: ${name}, ${width} pixels wide: ${error.message}`;
      throw error;
    }
    await context.close();
    console.log(`ok: ${of}: ${name}, ${width} pixels wide`);
  }
}

/** Calls task(browser) with Chromium. */
export async function withBrowser(executablePath, task) {
  const { chromium } = await import("playwright-core");
  const browser = await chromium.launch({ executablePath });
  try {
    await task(browser);
  } finally {
    await browser.close();
  }
}

/** A test of every page. */
export async function everyControlHasAName(page) {
  const controls = "button, select, input, a.button, canvas[role], [role=application], [role=slider]";
  const nameless = await page.$$eval(controls, (all) =>
    all.filter((e) => !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length)).map((e) => e.outerHTML));
  assert.deepEqual(nameless, []);
}
