// A session in VS Code: a mistake and its quick fix, a breakpoint, the Step Back and Reverse buttons, the scope page.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, join } from "node:path";
import { after, afterEach, before, test } from "node:test";

const { CHROMIUM, FOLDER, PROGRAM, URL: ADDRESS } = process.env;
const { chromium } = createRequire(join(FOLDER, "package.json"))("playwright-core");
const PICTURES = join(FOLDER, "pictures");
// Starting VS Code takes seconds, and a loaded machine several times as long.
const PATIENCE = Number(process.env.PATIENCE ?? 120_000);
const NAME = basename(PROGRAM);
let browser, page;

const picture = (name) => page.screenshot({ path: join(PICTURES, `${name}.png`) });
const button = (name) => page.locator(`.debug-toolbar a[aria-label^="${name}"]`);

// The line of the editor with this text.
const line = (text) => page.locator(".monaco-editor .view-line").filter({ hasText: text }).first();

// Wait until the debugger stops in a line.
async function stopped(number) {
  const place = page.locator(".line-number", { hasText: `${number}:` });
  await page.locator(".debug-call-stack .stack-frame").filter({ has: place }).first().waitFor();
}

// The value of a variable in the view of the debugger.
const variable = (name) => page.locator(".debug-variables .monaco-list-row").filter({ hasText: name }).first();

// Put the cursor into a line of the program.
async function to(number) {
  await page.locator(".monaco-editor .view-lines").first().click();
  await page.keyboard.press("Control+g");
  await page.keyboard.type(`${number}`);
  await page.keyboard.press("Enter");
}

async function breakpoint(number) {
  await to(number);
  await page.keyboard.press("F9");
}

// Wait for a text in the terminal that is shown.
const terminal = (text) => page.locator(".terminal-wrapper.active .xterm-rows > div").filter({ hasText: text }).first().waitFor();

async function palette(command) {
  await page.keyboard.press("F1");
  await page.locator(".quick-input-widget input").first().fill(`>motionlang: ${command}`);
  await page.locator(".quick-input-list .monaco-list-row").filter({ hasText: command }).first().click();
}

before(async () => {
  mkdirSync(PICTURES, { recursive: true });
  browser = await chromium.launch({ executablePath: CHROMIUM, args: ["--no-sandbox"] });
  page = await browser.newPage({ viewport: { width: 1500, height: 950 } });
  page.setDefaultTimeout(PATIENCE);
  await page.goto(ADDRESS);
  await page.locator(".explorer-folders-view .monaco-list-row").filter({ hasText: NAME }).dblclick();
  await line("SPEDE").waitFor();
});

// The picture after a test; that of one that fails shows why.
afterEach((context) => picture(context.name));

after(async () => {
  await browser.close();
});

test("a misspelt keyword has a squiggle, and its quick fix", async () => {
  await page.locator(".squiggly-error").first().waitFor();
  await line("SPEDE").getByText("SPEDE").click();
  await page.keyboard.press("Control+.");
  await page.locator(".action-widget .focused").filter({ hasText: "Change to SPEED" }).waitFor();
  await page.keyboard.press("Enter");
  await line("SPEED(0) = 300").waitFor();
  await page.locator(".squiggly-error").first().waitFor({ state: "detached" });
});

test("the debugger stops at a breakpoint, and steps back", async () => {
  await breakpoint(20);
  await page.keyboard.press("F5");
  await stopped(20);
  await variable("bits").filter({ hasText: /=\s*4/ }).waitFor();
  await button("Step Over").click();
  await stopped(21);
  await button("Step Back").click();
  await stopped(20);
  await variable("bits").waitFor();
  assert.equal(await page.locator(".notification-toast").count(), 0);
});

test("the Reverse button goes back to the breakpoint before", async () => {
  await breakpoint(28);
  await button("Continue").click();
  await stopped(28);
  await button("Reverse").click();
  await stopped(20);
});

test("the page of the motion follows the stop", async () => {
  await palette("Show the motion on a page");
  const motion = page.frameLocator("iframe.webview.ready").frameLocator("iframe");
  // The limit is reached at 0.933 s; the gantry is off the switch 0.231 s later.
  await motion.locator("#readout").getByText("A 0.93 s").waitFor();
  await button("Continue").click();
  await stopped(28);
  await motion.locator("#readout").getByText("A 5.74 s").waitFor();
});

test("the program is run, profiled and compared with the saved one", async () => {
  await button("Stop").click();
  await button("Stop").waitFor({ state: "hidden" });
  await palette("Run program");
  await terminal("--allow limit accepts it");
  await terminal("exit code");  // the next command takes the same terminal
  await palette("Show where the time goes");
  await terminal("4.5764  65.9%");
  await to(28);
  await page.keyboard.press("End");
  await page.keyboard.type(" / 2");
  await palette("Compare with the saved program");
  await page.locator(".output-view .view-line").filter({ hasText: /6\.940894.*6\.440894/ }).first().waitFor();
  await page.locator(".tab.dirty").filter({ hasText: NAME }).waitFor();
});
