// Browsers without a network, and a page of the playground that is used like by a person.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { deflateRawSync } from "node:zlib";

const require = createRequire(new URL("../../playground/package.json", import.meta.url));
const { chromium, firefox } = require("playwright-core");
const AXE = require.resolve("axe-core");
const BROWSERS = {
  chromium: [chromium, ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"]],
  firefox: [firefox, ["/usr/bin/firefox-esr", "/usr/bin/firefox"]],
};

export const { SITE, PLAYGROUND, NATIVE } = process.env;
// Loading Python takes seconds, and a loaded machine several times as long.
export const PATIENCE = { timeout: Number(process.env.PATIENCE ?? 180_000) };

// The installed browser of a name, or null.
export async function launch(name) {
  const [type, paths] = BROWSERS[name];
  const executablePath = paths.find(existsSync);
  if (!executablePath) return null;
  // Playwright drives an unpatched Firefox by WebDriver BiDi, which this channel stands for.
  const how = name === "chromium" ? { args: ["--no-sandbox"] } : { channel: "moz-firefox" };
  return type.launch({ executablePath, ...how });
}

// A page that reaches nothing but its own server; `page.refused` has what it tried to reach, `page.wrong` errors.
export async function open(browser, url, options = {}) {
  const context = await browser.newContext({ acceptDownloads: false, ...options });
  context.setDefaultTimeout(PATIENCE.timeout);
  const refused = [];
  await context.route(
    (target) => target.origin !== new URL(url).origin && ["http:", "https:", "ws:"].includes(target.protocol),
    (route) => (refused.push(route.request().url()), route.abort()),
  );
  const page = await context.newPage();
  Object.assign(page, { refused, wrong: [] });
  page.on("pageerror", (error) => page.wrong.push(error.message));
  page.on("console", (message) => message.type() === "error" && page.wrong.push(message.text()));
  await page.goto(url);
  return page;
}

export async function ready(page) {
  await page.waitForFunction(() => document.documentElement.dataset.loaded, null, PATIENCE);
}

// The part of an address after # that holds a text, in the form of share.js.
export function fragment(text) {
  return `v1.${deflateRawSync(Buffer.from(text)).toString("base64url")}`;
}

// Follow a link with a program.
export async function enter(page, { name = "program.mnt", dialect = "mint", program, machine = "" }) {
  const next = fragment(JSON.stringify({ name, dialect, program, machine }));
  await page.evaluate((text) => {
    document.querySelector("#status").textContent = ""; // of a link before this one
    location.hash = text;
  }, next);
  await page.waitForFunction(() => /came with the link/.test(document.querySelector("#status").textContent));
}

// The text of an editor: "program" or "machine".
export async function written(page, file) {
  return page.locator(`#panel-${file} .cm-content`).innerText();
}

// A figure that the page has measured: loaded, first, table (ms), runs.
export async function figure(page, name) {
  return page.evaluate((key) => Number(document.documentElement.dataset[key] ?? 0), name);
}

// Press Run and wait for the end of the run, which must not be cut short; returns what the page shows of it.
export async function run(page) {
  const before = await figure(page, "runs");
  await page.click("#run");
  await page.waitForFunction(() => !document.querySelector("#run").disabled, null, PATIENCE);
  const found = await shown(page);
  assert.equal(await figure(page, "runs"), before + 1, found.status);
  return found;
}

export async function shown(page) {
  return page.evaluate(() => {
    const text = (id) => document.querySelector(id).textContent;
    return { output: text("#output pre"), table: text("#table pre"), wrong: text("#wrong pre"), status: text("#status") };
  });
}

export async function findings(page) {
  await page.evaluate(readFileSync(AXE, "utf-8"));
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { iframes: false }));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((each) => each.html).join(" ")}`);
}

export const screenshot = (page, name) => page.screenshot({ path: join(process.env.FOLDER, `${name}.png`), fullPage: true });
