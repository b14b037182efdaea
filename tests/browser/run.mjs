// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the tests of the pixel inspector in a browser; says that it skips them (exit code 77) where playwright-core or
// Chromium is missing. scripts/setup installs both.
//   node tests/browser/run.mjs BUILD
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const kSkipped = 77;
const here = dirname(fileURLToPath(import.meta.url));

const { chromiumProgram } = await import("./chromium.mjs");
const lacking = !existsSync(join(here, "node_modules/playwright-core")) ? "playwright-core (npm ci in tests/browser)"
    : chromiumProgram() === null ? "Chromium (apt-get install chromium)" : null;
if (lacking) {
    console.log(`skipped: there is no ${lacking}`);
    process.exit(kSkipped);
}
if (process.argv.length !== 3) {
    console.error("usage: node tests/browser/run.mjs BUILD");
    process.exit(2);
}
const { status } = spawnSync(process.execPath, ["--test", join(here, "inspector_test.mjs")],
    { stdio: "inherit", env: { ...process.env, KEIKAN_BUILD: resolve(process.argv[2]) } });
process.exit(status ?? 1);
