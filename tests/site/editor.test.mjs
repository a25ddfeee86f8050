// The language server of the playground, and the second worker that has it.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { PATIENCE, PLAYGROUND, enter, findings, launch, open, ready, run, screenshot, shown, written } from "./browsers.mjs";

const LOOP = "Dim n\nWhile 1\nn = n + 1\nIf n > 1000 Then n = 0\nEnd While\n";
const WRONG = "SPED(0) = 100\nMOVER(0) = 5\nGO(0)\n";

// The hash of a style element that axe adds, and the policy of the page blocks; Firefox reports it.
const STYLE_OF_AXE = "sha256-YjaKGiklmzC6wjXA513HAMmzus8VE61XCOT+SmwNZWA=";

// Wait until the page has its language server.
const served = (page) => page.waitForFunction(() => !document.querySelector("#keys").hidden, null, PATIENCE);

// Wait until the list of problems has a text, and return it; "" waits until it is gone.
async function problems(page, text) {
  const listed = (part) => {
    const section = document.querySelector("#problems");
    return part ? !section.hidden && section.textContent.includes(part) : section.hidden;
  };
  await page.waitForFunction(listed, text, PATIENCE);
  return page.locator("#problems").innerText();
}

// Start a program that never ends.
async function startLoop(page) {
  await enter(page, { program: LOOP });
  await page.click("#run");
  await page.waitForFunction(() => document.querySelector("#status").textContent === "Running …");
}

for (const name of ["chromium", "firefox"]) {
  const browser = await launch(name);
  describe(`editor in ${name}`, { skip: browser === null && `no ${name} is installed` }, () => {
    let page;

    before(async () => {
      page = await open(browser, PLAYGROUND);
      page.asked = [];
      page.on("request", (request) => page.asked.push(new URL(request.url()).pathname));
      await ready(page);
    });
    after(async () => browser?.close());

    test("nothing of the language server is loaded before the first table", async () => {
      const asked = () => page.asked.filter((path) => /\/lsp-|language/.test(path));
      assert.deepEqual(asked(), []);
      await run(page);
      await served(page);
      assert.ok(asked().some((path) => /\/lsp-\w+\.js$/.test(path)), page.asked.join(" "));
    });

    test("a mistake is listed, and Ctrl-. and Enter fix it", async () => {
      await enter(page, { program: WRONG });
      assert.match(await problems(page, "SPED"), /line 1\s*error: SPED is unknown — hint: did you mean SPEED\?/);
      assert.equal(await page.locator("#panel-program .cm-lintRange-error").innerText(), "SPED");
      await page.locator("#panel-program .cm-content").focus();
      await page.keyboard.press("Control+Home");
      await page.keyboard.press("Control+.");
      assert.equal(await page.evaluate(() => document.activeElement.ariaLabel), "fix in line 1: Change to SPEED");
      await page.keyboard.press("Enter");
      assert.match(await written(page, "program"), /^SPEED\(0\) = 100\n/);
      assert.equal(await page.evaluate(() => document.activeElement.id), "panel-program");
      await problems(page, "");
      await page.keyboard.press("Control+z");
      assert.match(await written(page, "program"), /^SPED\(0\)/);
      await problems(page, "SPED");
    });

    test("a program is checked as it is typed, with the machine file of the other tab", async () => {
      await enter(page, { program: "PRINT 1\n", machine: "[axis.0]\nscale = 5\n" });
      await page.click("#tab-machine");
      await page.locator("#panel-machine .cm-content").focus();
      await page.keyboard.press("Control+End");
      await page.keyboard.insertText("scal = 5\n");
      const found = await problems(page, "machine file, line 3");
      assert.match(found, /is invalid, and the program is checked without it/);
      await page.getByRole("button", { name: "go to line 1" }).first().click();
      assert.ok(await page.isVisible("#panel-program"));
    });

    test("a word is completed, and a call shows its parameters", async () => {
      await enter(page, { program: "" });
      await page.locator("#panel-program .cm-content").focus();
      await page.keyboard.type("MOVER");
      await page.locator("#panel-program .cm-completionLabel").getByText("MOVER", { exact: true }).waitFor();
      await page.keyboard.press("Escape");
      await page.keyboard.type("(");
      const signature = page.locator("#panel-program .cm-lsp-signature-tooltip");
      await signature.waitFor();
      assert.match(await signature.innerText(), /^MOVER\(axis\) = user units/);
      await page.keyboard.press("Escape");
    });

    test("a word is explained at the pointer and by a key, without the HTML of a comment", async () => {
      await enter(page, { program: "' An <img src=x onerror=alert(1)> of a length\nDim length\nlength = 2\nPRINT length\n" });
      const help = page.locator("#panel-program .cm-lsp-hover-tooltip");
      await page.locator("#panel-program .cm-line").nth(3).hover({ position: { x: 70, y: 8 } });
      await help.waitFor();
      assert.match(await help.innerText(), /Dim length As Float\s+An <img src=x onerror=alert\(1\)> of a length/);
      assert.equal(await help.locator("img").count(), 0);
      await page.mouse.move(1, 1);
      await help.waitFor({ state: "detached" });
      await page.locator("#panel-program .cm-content").focus();
      await page.keyboard.press("Control+Home");
      for (let k = 0; k < 2; k++) await page.keyboard.press("ArrowDown");
      await page.keyboard.press("Shift+F1");
      await help.waitFor();
      const spoken = page.locator("#panel-program .cm-announced").filter({ hasText: "Dim length" });
      await spoken.waitFor({ state: "attached" });
      await page.keyboard.press("Escape");
      assert.equal(await help.count(), 0);
    });

    test("the other language has its own words", async () => {
      await enter(page, { name: "a.mcl", dialect: "mccl", program: "1XQ5\n" });
      await problems(page, "XQ");
      await enter(page, { program: "PRINT 1\n" });
      await problems(page, "");
    });

    test("the marks of a run and those of the server are shown once", async () => {
      await enter(page, { program: WRONG });
      await problems(page, "SPED");
      await run(page);
      assert.equal(await page.locator("#panel-program .cm-lintRange-error").count(), 1);
    });

    for (const colorScheme of ["light", "dark"]) {
      for (const width of [1300, 400]) {
        test(`axe finds nothing in problems: ${colorScheme}, ${width} pixels`, async () => {
          await page.emulateMedia({ colorScheme });
          await page.setViewportSize({ width, height: 900 });
          await enter(page, { program: `' ${colorScheme}, ${width}\nDim unused\n${WRONG}`, machine: "[axis.0]\nscal = 5\n" });
          await problems(page, "SPED");
          assert.deepEqual(await findings(page), []);
          assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "it scrolls sideways");
          await screenshot(page, `problems-${name}-${colorScheme}-${width}`);
        });
      }
    }

    test("after Stop a run needs no load of Python, and the server is still there", async () => {
      // A new worker cannot get Python, so that a run which needed one would never end.
      await page.context().route("**/pyodide/**", (route) => route.abort());
      await startLoop(page);
      await page.click("#stop");
      assert.equal((await shown(page)).status, "The run was ended.");
      await enter(page, { program: "PRINT 42\n" });
      assert.equal((await run(page)).output, "42\n");
      await enter(page, { program: WRONG });
      await problems(page, "SPED");
      await page.context().unroute("**/pyodide/**");
    });

    test("after a second Stop, of the worker with the server, it comes back", async () => {
      // The first worker is broken since the test before, so the second one runs this.
      await page.context().route("**/pyodide/**", (route) => route.abort());
      await startLoop(page);
      await page.context().unroute("**/pyodide/**");
      await page.click("#stop");
      assert.ok(await page.isHidden("#problems"));
      await served(page);
      await enter(page, { program: WRONG });
      await problems(page, "SPED");
      await enter(page, { program: "PRINT 43\n" });
      assert.equal((await run(page)).output, "43\n");
    });

    test("it asked no network and met no error", () => {
      const wrong = page.wrong.filter((text) => !/pyodide|Failed to load resource|ERR_FAILED/.test(text) && !text.includes(STYLE_OF_AXE));
      assert.deepEqual([page.refused, wrong], [[], []]);
    });
  });
}
