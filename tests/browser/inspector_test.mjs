// SPDX-License-Identifier: GPL-3.0-or-later
// The pixel inspector in a real browser: what a reader does with it, and that its numbers are those of the check.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";

import { openedPage, startedChromium } from "./chromium.mjs";
import { HOSTILE, Programs } from "./reports.mjs";

const programs = new Programs(process.env.KEIKAN_BUILD);
let browser;

/** Opens a report, and closes it again; nothing may have been complained about. */
async function inPage(report, options, look) {
    const page = await openedPage(browser, report.folder, options);
    await look(page);
    assert.deepEqual(page.complaints, []);
    await page.context().close();
}

const made = new Map();
function report(name) {
    if (!made.has(name)) made.set(name, programs[name]());
    return made.get(name);
}

const textOf = (page, selector) => page.locator(selector).innerText();
const withoutSpaces = (text) => text.replace(/[\s\u202f]/g, "");

/** Every number of the page that names its place in summary.json says what stands there. */
async function checkFigures(page, summary) {
    const figures = await page.$$eval("[data-figure]", (nodes) =>
        nodes.map((n) => [n.dataset.figure, n.dataset.value ?? n.textContent]));
    assert.ok(figures.length >= 7);
    for (const [path, shown] of figures) {
        const value = path.split(".").reduce((node, key) => node[key], summary);
        if (path === "seconds") continue;
        const said = typeof value === "string" || Number.isInteger(value) ? String(value)
            : value >= 1e-3 ? String(Number(value.toPrecision(3))) : Number(value.toPrecision(3)).toExponential();
        assert.equal(withoutSpaces(shown), said, path);
    }
}

// Two at a time: a page that is waited for leaves the processor to another.
describe("the pixel inspector", { concurrency: 2 }, () => {
    before(async () => {
        void report("tower").catch(() => {});  // the longest to make, so while Chromium starts; who asks for it hears of an error
        browser = await startedChromium();
    });
    after(async () => { await browser?.close(); });

    test("a scene: the head says what summary.json says, misclassified 0 among it", async () => {
        const { summary, printed } = await report("tower");
        assert.deepEqual(summary, printed);
        assert.equal(summary.verdict, "pass");
        await inPage(await report("tower"), {}, async (page) => {
            await checkFigures(page, summary);
            assert.equal(await textOf(page, '[data-figure="classification.mismatches"]'), "0");
            assert.match(await page.title(), /^Pass: /);
        });
    });

    test("the pictures of numbers add up to the summary", async () => {
        const { summary } = await report("tower");
        await inPage(await report("tower"), {}, async (page) => {
            const sums = await page.evaluate(async () => {
                const layers = JSON.parse(document.getElementById("report-picture").textContent).layers;
                const bytes = async (text) => {
                    const data = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
                    return new Uint8Array(await new Response(new Blob([data]).stream()
                        .pipeThrough(new DecompressionStream("deflate"))).arrayBuffer());
                };
                const faces = await bytes(layers.faces);
                const errors = await bytes(layers.errors);
                const n = faces.length / 2;
                let polygons = 0, largest = 0;
                const view = new DataView(new ArrayBuffer(4));
                for (let i = 0; i < n; ++i) {
                    polygons += faces[i] + 256 * faces[n + i];
                    for (let k = 0; k < 4; ++k) view.setUint8(3 - k, errors[k * n + i]);
                    largest = Math.max(largest, view.getFloat32(0));
                }
                return { pixels: n, polygons, largest };
            });
            assert.equal(sums.pixels, summary.pixels);
            assert.equal(sums.polygons, summary.polygons);
            assert.equal(sums.largest, Math.fround(summary.max_area_error));
        });
    });

    test("the table sorts, and its filters leave what they name", async () => {
        await inPage(await report("tower"), {}, async (page) => {
            const rows = () => page.locator("#pixel-table tbody tr");
            const first = await rows().first().getAttribute("data-pixel");
            await page.click('[data-sort="column_faces"]');
            const faces = await page.$$eval("#pixel-table tbody tr td:nth-child(4)", (cells) => cells.map((c) => Number(c.textContent)));
            assert.deepEqual(faces, [...faces].sort((a, b) => b - a));
            await page.click('[data-sort="column_error"]');
            assert.equal(await rows().first().getAttribute("data-pixel"), first);
            await page.click("#filter-kind-4");
            assert.equal(await page.getAttribute("#filter-kind-4", "aria-pressed"), "true");
            assert.ok((await rows().count()) > 0);
            for (const cell of await page.$$eval("#pixel-table tbody tr td:nth-child(6)", (cells) => cells.map((c) => c.innerHTML)))
                assert.match(cell, /hole/);
            await page.click("#filter-kind-4");
            await page.click("#filter-sample");
            assert.ok((await rows().count()) > 10);
        });
    });

    test("two layers: flipped with a key, compared with a slider, down to values", async () => {
        await inPage(await report("tower"), {}, async (page) => {
            await page.locator("#picture-canvas").focus();
            const legend = () => textOf(page, "#picture-legend");
            assert.match(await legend(), /^Rendered/);
            await page.selectOption("#compare", "flip");
            await page.keyboard.press("Tab");
            await page.locator("#picture-canvas").focus();
            await page.keyboard.press("f");
            assert.match(await legend(), /^Error/);
            await page.keyboard.press("f");
            assert.match(await legend(), /^Rendered/);
            await page.selectOption("#compare", "slider");
            assert.match(await legend(), /Rendered[\s\S]*Error/);
            await page.locator("#picture-canvas").focus();
            for (let i = 0; i < 6; ++i) await page.keyboard.press("+");
            assert.ok(Number(await page.getAttribute("#picture-canvas", "data-zoom")) > 44);
            const before = await textOf(page, "#picture-readout strong");
            await page.keyboard.press("ArrowRight");
            assert.notEqual(await textOf(page, "#picture-readout strong"), before);
            await page.keyboard.press("0");
            for (const mode of ["coverage", "errors", "kinds", "flags", "faces"]) {
                await page.selectOption("#mode-0", mode);
                assert.ok((await legend()).length > 5);
            }
        });
    });

    test("a link opens its pixel, whether the page has details or the command", async () => {
        const { summary } = await report("tower");
        const [x, y] = summary.worst[0].pixel;
        await inPage(await report("tower"), { hash: `#x=${x}&y=${y}` }, async (page) => {
            assert.equal(await textOf(page, "#pixel-title"), `Pixel ${x}, ${y}`);
            assert.ok(await page.isVisible("#areas"));
        });
        await inPage(await report("tower"), { hash: "#x=3&y=2" }, async (page) => {
            assert.match(await textOf(page, "#pixel-empty"), /keikan pixel .*--at 3,2 --size 300x195 \| keikan-verify areas -/);
            await page.evaluate(([a, b]) => { location.hash = `#x=${a}&y=${b}`; }, [x, y]);
            await page.waitForSelector("#areas");
            assert.equal(await textOf(page, "#pixel-title"), `Pixel ${x}, ${y}`);
        });
    });

    test("a pixel is stepped through; a step's contacts are those of the oracle", async () => {
        const { summary } = await report("tower");
        const [x, y] = summary.worst[1].pixel;  // the worst but one has a seventh of the steps
        await inPage(await report("tower"), { hash: `#x=${x}&y=${y}&step=0` }, async (page) => {
            assert.match(await textOf(page, "#step-text"), /^The question/);
            const last = Number(await page.getAttribute("#step-slider", "max"));
            assert.ok(last > 2);
            let contacts = 0;
            for (let step = 1; step < last; ++step) {
                await page.keyboard.press(".");
                const { text, states, drawn } = await page.evaluate(() => ({
                    text: document.getElementById("step-text").innerText,
                    states: [...document.querySelectorAll("#contact-table [data-state]")].map((row) => row.dataset.state),
                    drawn: document.querySelectorAll("#pixel-drawing .contact").length }));
                assert.match(text, new RegExp(`^Step ${step} of ${last - 1}`));
                assert.ok(states.every((s) => s === "agrees"));
                assert.equal(drawn, states.length);
                contacts += states.length;
            }
            assert.ok(contacts > 0);
            await page.click("#magnify");
            await page.keyboard.press(",");
            await page.locator("#step-slider").fill("0");
            assert.match(await textOf(page, "#step-text"), /^The question/);
            await page.keyboard.press("m");
            assert.equal(await page.isChecked("#magnify"), false);
            // Stepping has left the table of the areas where it was.
            const areas = await page.$$eval("#areas tbody tr", (rows) => rows.length);
            assert.ok(areas >= 3);
        });
    });

    test("well-known text is copied, and keikan clip and keikan-verify read it", async () => {
        const { summary } = await report("tower");
        const [x, y] = summary.worst[0].pixel;
        await inPage(await report("tower"), { hash: `#x=${x}&y=${y}&step=1` }, async (page) => {
            const copied = async (tab) => {
                await page.click(`#${tab}`);
                await page.click("#copy-taken");
                await page.waitForFunction(() => document.getElementById("copy-taken").textContent === "Copied");
                return page.evaluate(() => navigator.clipboard.readText());
            };
            const [subject, clip] = (await copied("take_step")).match(/POLYGON \(\(.*?\)\)/g);
            const done = programs.run("keikan", ["clip", "--subject", subject, "--clip", clip]);
            assert.equal(done.code, 0, done.err);
            const turns = await page.$$eval("#contact-table [data-state] td:first-child", (cells) =>
                cells.map((c) => c.textContent.trim()).filter((c) => !c.endsWith("touch")));
            assert.deepEqual(JSON.parse(done.out).intersections.map((i) => `${i.class}, ${i.turn}`), turns);

            const wkt = programs.run("keikan-verify", ["convert", "-", "-", "--from", "wkt", "--to", "jsonl"], await copied("take_wkt"));
            assert.equal(wkt.code, 0, wkt.err);
            const geojson = programs.run("keikan-verify", ["convert", "-", "-", "--from", "geojson", "--to", "jsonl"],
                await copied("take_geojson"));
            assert.equal(geojson.out, wkt.out);
            const asked = programs.run("keikan-verify", ["areas", "-", "--quiet"], (await copied("take_case")) + "\n");
            assert.equal(asked.code, 0, asked.err);  // its stated areas among it
            assert.equal(JSON.parse(asked.out).pixels, 1);
            const [question] = (await copied("take_commands")).split("\n");
            const pixel = programs.run("keikan", question.split(" ").slice(1));
            assert.equal(pixel.code, 0, pixel.err);
            assert.match(await copied("take_cpp"), /TEST_CASE\("visible_areas: pixel/);
        });
    });

    test("a planted wrong answer is shown: verdict, table, and in words", async () => {
        const { summary, junit } = await report("planted");
        assert.equal(summary.verdict, "fail");
        assert.match(junit, /failures="1"/);
        await inPage(await report("planted"), {}, async (page) => {
            await checkFigures(page, summary);
            assert.match(await page.title(), /^Fail: /);
            await page.click("#filter-disagrees");
            assert.equal(await page.locator("#pixel-table tbody tr").count(), 1);
            await page.click("#pixel-table tbody tr button");
            assert.match(await textOf(page, "#pixel-disagreements"), /given.*1\/3/s);
        });
    });

    test("text of scenes and cases is shown as text", async () => {
        await inPage(await report("planted"), {}, async (page) => {
            assert.equal(await page.locator("#pixel-table tbody button", { hasText: "<img src=x" }).count(), 1);
            assert.equal(await page.locator("img").count(), 0);
            await page.locator("#pixel-table tbody button", { hasText: "<img src=x" }).click();
            assert.equal(await textOf(page, "#pixel-title"), HOSTILE);
            assert.notEqual(await page.title(), "taken over");
        });
        await inPage(await report("hostileScene"), {}, async (page) => {
            assert.equal(await page.locator("img").count(), 0);
            assert.notEqual(await page.title(), "taken over");
            await page.selectOption("#mode-0", "coverage");
            assert.ok((await page.$$eval("#object option", (options) => options.map((o) => o.textContent)))
                .some((name) => name.startsWith(HOSTILE)));
            assert.match(await textOf(page, "#areas"), /<img src=x onerror/);
        });
        assert.equal((await report("hostileScene")).junit.includes("<img"), false);
    });

    test("the paper's clipper to the letter: the contact that is not the exact one is marked", async () => {
        const { summary } = await report("knownFailures");
        await inPage(await report("knownFailures"), {}, async (page) => {
            await checkFigures(page, summary);
            assert.equal(await page.locator("#pixel-table tbody tr .chip.bad").count(), 5);
            await page.locator("#pixel-table tbody button", { hasText: "D1-long-clipper-edge" }).click();
            assert.ok((await page.locator('#contact-table [data-state="differs"]').count()) > 0);
            assert.ok((await page.locator("#pixel-drawing .contact.differs").count()) > 0);
            assert.ok((await page.locator("#areas tr.bad").count()) > 0);
            await page.selectOption("#claim", "traversal");
            assert.equal(await page.locator("#areas tr.bad").count(), 0);
        });
    });

    test("a campaign without findings says what was tried", async () => {
        const { summary } = await report("emptyFuzz");
        const families = summary.campaign.families.length;
        assert.equal(summary.campaign.findings, 0);
        await inPage(await report("emptyFuzz"), {}, async (page) => {
            await checkFigures(page, summary);
            assert.match(await textOf(page, "#fuzz-sentence"), new RegExp(`^No findings\\. 240 pixels of ${families} families`));
            const tried = await page.$$eval("#family-table tbody td:nth-child(2)", (cells) => cells.map((c) => Number(c.textContent)));
            assert.equal(tried.length, families);
            assert.equal(tried.reduce((a, b) => a + b), 240);
        });
    });

    test("peers: a bar for each, and the worst pixels of who was wrong", async () => {
        const { summary } = await report("peers");
        await inPage(await report("peers"), {}, async (page) => {
            await checkFigures(page, summary);
            assert.equal(await page.locator("#peer-chart .bar-label").count(), summary.peers.length);
            const wrong = await page.$$eval("#peer-table tbody tr", (rows) =>
                rows.map((r) => [r.querySelector("button").textContent, Number(r.children[6].textContent.replace(/\s/g, ""))]));
            for (const peer of summary.peers)
                assert.equal(Object.fromEntries(wrong)[peer.name], peer.wrong["1e-12"]);
            await page.locator("#peer-table button", { hasText: "published" }).click();
            assert.match(await textOf(page, "#pixel-title"), /published/);
            assert.ok((await page.locator("#areas tr.bad").count()) > 0);
        });
    });

    test("Japanese by choice of the reader or of the browser", async () => {
        await inPage(await report("planted"), { locale: "ja-JP" }, async (page) => {
            assert.match(await textOf(page, "#verdict"), /不合格/);
            assert.equal(await page.getAttribute("html", "lang"), "ja");
            await page.locator("#language button", { hasText: "English" }).click();
            assert.match(await textOf(page, "#verdict"), /Fail/);
        });
    });

    test("nothing is wider than the page, on a desk or in a hand, in the dark or not", async () => {
        const hand = { viewport: { width: 390, height: 900 }, colorScheme: "dark", locale: "ja-JP" };
        const narrowEnough = async (page, what) => {
            const [inside, outside] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
            assert.ok(inside <= outside, `${what}: ${inside} in ${outside}`);
        };
        for (const [name, hash] of [["tower", "#x=1&y=1"], ["tower", ""], ["knownFailures", ""], ["peers", ""], ["emptyFuzz", ""]])
            await inPage(await report(name), { hash, ...hand }, async (page) => {
                await narrowEnough(page, `${name} in a hand`);
                await page.setViewportSize({ width: 1400, height: 900 });
                await page.emulateMedia({ colorScheme: "light" });
                await page.locator("#language button", { hasText: "English" }).click();
                await narrowEnough(page, `${name} on a desk`);
            });
    });

    test("every control has a name, and the keyboard reaches it", async () => {
        await inPage(await report("tower"), {}, async (page) => {
            const nameless = await page.$$eval("button, select, input, canvas, [role=tabpanel], [role=region]", (nodes) => nodes
                .filter((n) => n.offsetParent !== null)
                .filter((n) => !(n.getAttribute("aria-label") || n.getAttribute("aria-labelledby") || n.closest("label")?.innerText.trim()
                    || n.innerText?.trim()))
                .map((n) => n.outerHTML.slice(0, 120)));
            assert.deepEqual(nameless, []);
            const seen = new Set();
            for (let i = 0; i < 40; ++i) {
                await page.keyboard.press("Tab");
                seen.add(await page.evaluate(() => document.activeElement.id));
            }
            for (const id of ["mode-0", "compare", "exposure", "picture-canvas"]) assert.ok(seen.has(id), id);
        });
    });
});
