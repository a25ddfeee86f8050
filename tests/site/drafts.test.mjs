// What the reader has written outlives another choice, a link and a reload.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { PLAYGROUND, enter, launch, open, ready, shown, written } from "./browsers.mjs";

// Put a text at the end of the program.
async function type(page, text) {
  await page.locator("#panel-program .cm-content").focus();
  await page.keyboard.press("Control+End");
  await page.keyboard.insertText(text);
}

const own = (page) => page.locator("#yours option").allInnerTexts();

for (const name of ["chromium", "firefox"]) {
  const browser = await launch(name);
  describe(`drafts in ${name}`, { skip: browser === null && `no ${name} is installed` }, () => {
    let page;

    before(async () => {
      page = await open(browser, PLAYGROUND);
      await ready(page);
    });
    after(async () => browser?.close());

    test("an example that is only read leaves nothing", async () => {
      await page.selectOption("#gallery", "pick-and-place.mnt");
      await page.selectOption("#gallery", "ballscrew.mnt");
      assert.deepEqual(await own(page), []);
    });

    test("a changed example is kept under another choice", async () => {
      await type(page, "' mine\n");
      await page.selectOption("#gallery", "pick-and-place.mnt");
      assert.match((await shown(page)).status, /^What you wrote is kept as ballscrew\.mnt \(changed\), under Example\.$/);
      assert.doesNotMatch(await written(page, "program"), /mine/);
      assert.deepEqual(await own(page), ["ballscrew.mnt (changed)"]);
      await page.selectOption("#gallery", "0");
      assert.match(await written(page, "program"), /' mine\n/);
    });

    test("the example itself stays as it was, and a second version has a name of its own", async () => {
      await page.selectOption("#gallery", "ballscrew.mnt");
      assert.doesNotMatch(await written(page, "program"), /mine/);
      await type(page, "' other\n");
      await enter(page, { program: "PRINT 1\n" });
      assert.deepEqual(await own(page), ["ballscrew.mnt (changed)", "ballscrew.mnt (changed 2)"]);
    });

    test("a changed machine file is kept, too", async () => {
      await page.click("#tab-machine");
      await page.locator("#panel-machine .cm-content").focus();
      await page.keyboard.insertText("[axis.0]\n");
      await page.selectOption("#gallery", "0");
      assert.deepEqual(await own(page), ["ballscrew.mnt (changed)", "ballscrew.mnt (changed 2)", "program.mnt (changed)"]);
      await page.selectOption("#gallery", "2");
      assert.match(await written(page, "machine"), /^\[axis\.0\]/);
    });

    test("a reload brings back the text that was shown, and the others", async () => {
      await page.selectOption("#gallery", "0");
      await type(page, "' newer\n");
      await page.reload();
      await ready(page);
      assert.match(await written(page, "program"), /' mine\n[^]*' newer\n/);
      assert.equal(await page.inputValue("#gallery"), "0");
      assert.equal((await own(page)).length, 3);
    });

    test("another tab has its own", async () => {
      const other = await open(browser, PLAYGROUND);
      await other.waitForFunction(() => document.querySelector("#version").textContent);
      assert.deepEqual(await own(other), []);
      await other.context().close();
    });

    test("it met no error", () => assert.deepEqual([page.refused, page.wrong], [[], []]));
  });
}
