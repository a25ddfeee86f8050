// The built site, below a path, without a network: read a page, run its program, change it, share it.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { SITE, figure, launch, open, ready, run, screenshot, shown } from "./browsers.mjs";

for (const name of ["chromium", "firefox"]) {
  const browser = await launch(name);
  describe(`site in ${name}`, { skip: browser === null && `no ${name} is installed` }, () => {
    let page;

    before(async () => {
      page = await open(browser, `${SITE}index.html`);
    });
    after(async () => browser?.close());

    test("the first sentence is followed by the link to the playground", async () => {
      const first = page.locator(".md-content p").first();
      assert.match(await first.innerText(), /^[^.]+\. The playground runs it in a browser/);
      assert.match(await first.locator("a").first().getAttribute("href"), /^playground\.html$/);
    });

    test("each page has version and commit", async () => {
      assert.match(await page.innerText(".md-footer"), /motionlang \d+\.\d+\.\d+, commit [0-9a-f]{12}/);
    });

    test("the search finds a keyword", async () => {
      const other = await open(browser, `${SITE}cycle.html`);
      await other.keyboard.press("Control+k");
      await other.keyboard.type("MOVER", { delay: 20 });
      await other.getByText(/MOVER/).first().waitFor();
      assert.deepEqual(other.refused, []);
      await other.context().close();
    });

    test("a reader runs the first example, changes a speed, and shares it", async () => {
      const link = page.locator(".run a").first();
      await link.click();
      await ready(page);
      assert.ok(!(await page.isHidden("#docs")));
      const before = await run(page);
      const frame = page.frameLocator("#frame iframe");
      await frame.locator("#outcome").waitFor();
      const outcome = await frame.locator("#outcome").innerText();

      const line = page.locator("#panel-program .cm-line", { hasText: "SPEED" }).first();
      const text = await line.innerText();
      const slower = text.replace(/SPEED\(0\) = \d+/, "SPEED(0) = 125");
      assert.notEqual(slower, text);
      await line.click();
      await page.keyboard.press("Home");
      await page.keyboard.press("Shift+End");
      await page.keyboard.insertText(slower);
      const after = await run(page);
      assert.notEqual(after.table, before.table);
      assert.match(after.table, / 125$/m);
      await frame.getByText(/peak 125 uu\/s/).first().waitFor();
      assert.notEqual(await frame.locator("#outcome").innerText(), outcome);

      await page.click("#share");
      await page.waitForFunction(() => /The link is in/.test(document.querySelector("#status").textContent));
      const other = await open(browser, page.url());
      await ready(other);
      assert.equal(await figure(other, "runs"), 0);
      assert.equal((await shown(other)).table, "");
      assert.equal((await run(other)).table, after.table);
      assert.deepEqual([page.refused, other.refused], [[], []]);
      await other.context().close();
    });

    for (const colorScheme of ["light", "dark"]) {
      test(`a picture of the start page: ${colorScheme}`, async () => {
        const other = await open(browser, `${SITE}index.html`, { colorScheme, viewport: { width: 400, height: 900 } });
        assert.ok(await other.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "it scrolls sideways");
        await screenshot(other, `site-${name}-${colorScheme}-400`);
        await other.context().close();
      });
    }
  });
}
