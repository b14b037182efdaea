// SPDX-License-Identifier: GPL-3.0-or-later
// Debian's Chromium, and pages in it.
import { existsSync } from "node:fs";

const PROGRAMS = [process.env.KEIKAN_CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** Where it is; null where it is not. */
export function chromiumProgram() {
    return PROGRAMS.find((program) => program && existsSync(program)) ?? null;
}

export async function startedChromium() {
    const { chromium } = await import("playwright-core");
    return chromium.launch({ executablePath: chromiumProgram(), args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"] });
}

/**
 * The page of a report, ready, and what its console said. `hash` names a pixel, `options` are those of a browser
 * context (locale, colorScheme, viewport).
 */
export async function openedPage(browser, folder, { hash = "", ...options } = {}) {
    const context = await browser.newContext({ viewport: { width: 1400, height: 1000 }, locale: "en-US", ...options });
    await context.grantPermissions(["clipboard-read", "clipboard-write"]);
    const page = await context.newPage();
    page.complaints = [];
    page.on("console", (message) => {
        if (["error", "warning"].includes(message.type())) page.complaints.push(message.text());
    });
    page.on("pageerror", (error) => page.complaints.push(String(error)));
    page.on("request", (request) => {
        if (!/^(file|data|blob):/.test(request.url())) page.complaints.push(`asks for ${request.url()}`);
    });
    await page.goto(`file://${folder}/index.html${hash}`);
    await page.waitForSelector("html[data-ready]", { timeout: 60000 });
    return page;
}
