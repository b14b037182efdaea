// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the pictures of docs/tour.md. Run by scripts/tour.
//   node tests/browser/tour.mjs BUILD PICTURES
import { join, resolve } from "node:path";

import { openedPage, startedChromium } from "./chromium.mjs";
import { Programs } from "./reports.mjs";

const [build, pictures] = process.argv.slice(2).map((p) => resolve(p));
const JOINT = [267, 441];
const SCENE = ["scene", "data/scenes/tower_closeup.json", "--size", "500x500"];

const programs = new Programs(build);
const published = await programs.report("tour-published", [...SCENE, "--engine", "published"], 1);
const question = programs.run("keikan", ["pixel", ...SCENE.slice(1), "--at", JOINT.join(",")]).out;
const traversal = await programs.report("tour-traversal", ["areas", "-", "--engine", "traversal"], 0, question);

const browser = await startedChromium();
const hash = `#x=${JOINT[0]}&y=${JOINT[1]}`;

/** A picture of `selector`, cut off at `height`, of a page on which `act` has been done. */
async function take(name, report, options, selector, height, act = async () => {}) {
    const page = await openedPage(browser, report.folder, { viewport: { width: 1320, height: 1000 }, ...options });
    // As tall as all of it, so that nothing scrolls between measuring and taking.
    await page.setViewportSize({ width: page.viewportSize().width, height: await page.evaluate(() => document.documentElement.scrollHeight) });
    await page.waitForFunction(() => window.scrollY === 0);
    await act(page);
    const box = await page.locator(selector).boundingBox();
    const file = join(pictures, `tour-${name}.png`);
    await page.screenshot({ path: file, clip: { x: Math.max(0, box.x - 8), y: Math.max(0, box.y - 8),
        width: box.width + 16, height: Math.min(height, box.height + 16) } });
    if (page.complaints.length) throw new Error(page.complaints.join("\n"));
    await page.context().close();
    console.log(file);
}

await take("1-verdict", published, {}, "header", 420);
await take("2-picture", published, { hash, viewport: { width: 900, height: 1000 } }, "#picture-panel", 1100, async (page) => {
    await page.selectOption("#compare", "slider");
    await page.selectOption("#mode-1", "errors");
    await page.locator("#picture-canvas").focus();
    await page.keyboard.press("0");
});
await take("3-joint", published, { hash }, "#pixel-panel", 900);
await take("4-magnified", published, { hash, colorScheme: "dark" }, "#pixel-panel .left", 900, (page) => page.click("#magnify"));
await take("5-traversal", traversal, { hash: `#id=${JOINT.join(",")}&step=3` }, "#pixel-panel", 900);
await browser.close();
