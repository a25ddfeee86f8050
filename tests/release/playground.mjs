// Run the program that the playground opens with, in Chromium.

import assert from "node:assert/strict";
import { PLAYGROUND, launch, open, ready, run } from "../site/browsers.mjs";

const browser = await launch("chromium");
const page = await open(browser, PLAYGROUND);
await ready(page);
assert.match((await run(page)).output, /the nut is at 200.0000 mm/);
assert.deepEqual(page.refused, []);
assert.deepEqual(page.wrong, []);
await browser.close();
