// The panel in the installed browsers, operated like by a person.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, describe, test } from "node:test";
import { findings, launch, open } from "./browsers.mjs";

const { PYTHON = "python3" } = process.env;
const PRESS = `' IN 1 start  2 part in  3 key switch
' OUT 1 clamp
SCALE(0) = 100
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Dim n, k
Input "How many", n
Pause INX(1)
OUTX(1) = 1
MOVER(0) = 20 : GO(0) : Pause IDLE(0)
Pause INX(1) = 0
If INX(3) Then Print "<script>document.title = 'wrong'</script>"
Repeat
  k = INKEY
Until k > 0
Print "key "; k
Pause ADC(0) > 50
Pause COMMS(3) > 4
Print "over "; n
Pause INX(2)
`;

let folder;
let panel;

// Start a panel for a program; returns the address of its page.
async function start(text, ...options) {
  folder = mkdtempSync(join(tmpdir(), "panel-"));
  writeFileSync(join(folder, "press.mnt"), text);
  panel = spawn(PYTHON, ["-m", "motionlang", "panel", join(folder, "press.mnt"), ...options]);
  const [line] = await new Promise((resolve, reject) => {
    panel.stdout.once("data", (data) => resolve(String(data).split("\n")));
    panel.stderr.once("data", (data) => reject(new Error(String(data))));
  });
  return line;
}

// End the panel as Ctrl-C does; returns its exit status.
async function stop() {
  const ended = new Promise((resolve) => panel.once("exit", resolve));
  panel.kill("SIGINT");
  const status = await ended;
  rmSync(folder, { recursive: true });
  panel = null;
  return status;
}

const waits = (page, words) => page.waitForFunction((text) => document.querySelector("#waits").textContent.includes(text), words);
const says = (page, words) => page.waitForFunction((text) => document.querySelector("#notice").textContent.includes(text), words);
const prints = (page, words) => page.waitForFunction((text) => document.querySelector("#terminal").textContent.includes(text), words);
const seconds = async (page) => parseFloat(await page.locator("#time").innerText());

for (const name of ["chromium", "firefox"]) {
  const browser = await launch(name);
  describe(`panel in ${name}`, { skip: browser === null && `no ${name} is installed` }, () => {
    afterEach(async () => panel && stop());
    after(async () => browser?.close());

    test("answer, press and hold, type, slide, write, go back, save, and verify what was saved", async () => {
      const page = await open(browser, await start(PRESS));
      await waits(page, "How many");
      await page.fill("#line", "3");
      await page.press("#line", "Enter");
      await waits(page, "waits for input 1 (start), line 7");
      const button = page.getByRole("button", { name: "input 1 start" });
      const pulses = page.locator(".waiting");
      assert.match(await pulses.innerText(), /input 1 start/);
      await page.getByRole("switch", { name: "input 3 key switch" }).click();
      await button.hover();
      await page.mouse.down();
      await waits(page, "input 1 (start), line 10");
      assert.equal(await button.getAttribute("aria-pressed"), "true");
      assert.match(await page.locator("#axes").innerText(), /at 20\.00/);
      assert.match(await page.locator("#outputs .on").innerText(), /output 1 clamp\s*on/);
      await page.mouse.up();
      await prints(page, "<script>document.title = 'wrong'</script>");
      await waits(page, "a key");
      await page.focus("#terminal");
      await page.keyboard.press("x");
      await prints(page, "key 120");
      await waits(page, "analogue input 0");
      await page.getByRole("slider").fill("60");
      await waits(page, "comms element 3");
      const before = await seconds(page);
      await page.getByRole("spinbutton", { name: "new value of comms element 3" }).fill("5.5");
      await page.getByRole("button", { name: "write comms element 3" }).click();
      await prints(page, "over 3");
      await page.click("#save");
      await says(page, "saved ");
      assert.equal(await page.title(), "press.mnt · panel");
      await page.fill("#moment", String(before - 0.02));
      await page.click("#back");
      await says(page, "1 later action cut off");
      await page.waitForFunction(() => document.querySelector("#mode").textContent === "paused");
      assert.ok((await seconds(page)) < before);
      const text = readFileSync(join(folder, "press.scenarios", "hand-1.toml"), "utf-8");
      assert.match(text, /\{ prints = "over 3/);
      const verified = execFileSync(PYTHON, ["-m", "motionlang", "verify", join(folder, "press.mnt")], { encoding: "utf-8" });
      assert.match(verified, /1 of 1 scenarios pass/);
      assert.deepEqual([page.wrong, page.refused], [[], []]);
      await page.context().close();
      assert.equal(await stop(), 0);
    });

    test("pause, hold, go to the next rest, step, change the speed, and restart after the file has changed", async () => {
      const text = PRESS.replace('Input "How many", n', "n = 1");
      const page = await open(browser, await start(text));
      const mode = (words) => page.waitForFunction((text) => document.querySelector("#mode").textContent === text, words);
      const hold = page.getByRole("switch", { name: "input 1 start, hold" });
      await waits(page, "waits for input 1 (start), line 7");
      await page.click("#run");
      await mode("paused");
      await hold.click();
      await page.click("#rest");
      await waits(page, "waits for input 1 (start), line 10");
      await mode("paused");
      await hold.click();
      await page.locator('#record button:has-text("input 1 off")').waitFor();
      await page.click("#step");
      await page.locator('#program .at:has-text("If INX(3)")').waitFor();
      await page.selectOption("#speed", "10");
      await page.click("#run");
      await waits(page, "waits for a key");
      assert.equal(await page.locator("#speed").inputValue(), "10");
      writeFileSync(join(folder, "press.mnt"), `${text}' longer\n`);
      await says(page, "press.mnt or its machine file has changed");
      await page.click("#again");
      await says(page, "started again, with 2 actions");
      await waits(page, "waits for a key");
      assert.equal(await page.locator("#changed").isVisible(), false);
      await page.context().close();
    });

    test("an input that follows an output becomes a rule", async () => {
      const page = await open(browser, await start(`${"OUTX(1) = 1\nPause INX(2)\nOUTX(1) = 0\nPause INX(2) = 0\n".repeat(2)}Pause INX(5)\n`));
      const hold = page.getByRole("switch", { name: "input 2, hold" });
      await waits(page, "input 2, line 2");
      await hold.click();
      await waits(page, "input 2, line 4");
      await hold.click();
      await waits(page, "input 2, line 6");
      await page.getByRole("button", { name: /^as a rule: follows output 1 after/ }).click();
      await waits(page, "input 5, line 9");
      assert.match(await page.locator("#inputs").innerText(), /follows output 1 after/);
      await page.context().close();
    });

    test("the terminal knows where LOCATE and CLS put a text", async () => {
      const text = 'Print "old"\nCLS\nLOCATE(3, 2) : Print "there"\nLOCATE(1, 1) : Print "here"\nPause INX(1)\n';
      const page = await open(browser, await start(text));
      await waits(page, "input 1");
      assert.equal((await page.locator("#terminal").textContent()).trimEnd(), "here\n  there");
      await page.context().close();
    });

    test("two pages see what either does, and a page that comes later sees it, too", async () => {
      const url = await start(PRESS.replace('Input "How many", n', "n = 1"));
      const [one, other] = [await open(browser, url), await open(browser, url)];
      const lever = (page) => page.getByRole("switch", { name: "input 3 key switch" });
      const shows = (page, level) => page.locator(`[role=switch][aria-label="input 3 key switch"][aria-checked=${level}]`).waitFor();
      await lever(one).click();
      await Promise.all([shows(one, true), shows(other, true)]);
      await lever(other).click();
      await Promise.all([shows(one, false), shows(other, false)]);
      await lever(one).click();
      await one.reload();
      await shows(one, true);
      for (const page of [one, other]) await page.context().close();
    });

    test("the keyboard alone operates it, and a screen reader has names", async () => {
      const page = await open(browser, await start(PRESS));
      await waits(page, "How many");
      assert.deepEqual(await findings(page), []);
      assert.equal(await page.evaluate(() => document.activeElement.id), "line");
      await page.keyboard.type("1");
      await page.keyboard.press("Enter");
      await waits(page, "input 1");
      assert.deepEqual(await findings(page), []);
      while ((await page.evaluate(() => document.activeElement.textContent)) !== "input 1 start") await page.keyboard.press("Tab");
      await page.keyboard.down("Space");
      await waits(page, "line 10");
      await page.keyboard.up("Space");
      await waits(page, "a key");
      await page.context().close();
    });

    test("a page of another origin cannot act", async () => {
      const url = await start(PRESS);
      const page = await open(browser, url);
      await waits(page, "How many");
      const frame = await browser.newContext();
      const foreign = await frame.newPage();
      await foreign.goto("data:text/html,elsewhere");
      const answer = await foreign.evaluate(async (target) => {
        try {
          return (await fetch(target, { method: "POST", headers: { "Content-Type": "application/json" }, body: '{"do":"save"}' })).status;
        } catch {
          return "refused";
        }
      }, `${url}act`);
      assert.equal(answer, "refused");
      await frame.close();
      await page.context().close();
    });

    test("10 000 printed lines, 64 inputs and 8 axes fit a small window", async () => {
      const inputs = Array.from({ length: 64 }, (_, k) => `If INX(${k}) Then Print ${k}`);
      const axes = Array.from({ length: 8 }, (_, k) => `MOVER(${k}) = 1000 : GO(${k})`);
      const lines = ["Dim n", "For n = 1 To 10000", "Print n", "Next", ...axes, "Loop", ...inputs, "Wait = 20", "End Loop"];
      const page = await open(browser, await start(lines.join("\n")), { viewport: { width: 390, height: 800 } });
      await prints(page, "10000.0000");
      assert.equal(await page.locator("#inputs .channel").count(), 64);
      assert.equal(await page.locator("#axes .axis").count(), 8);
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(width <= 390, `${width}`);
      await page.context().close();
    });
  });
}
