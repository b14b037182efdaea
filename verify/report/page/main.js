// SPDX-License-Identifier: GPL-3.0-or-later
// The pixel inspector: puts the parts of the page together, and follows links to a pixel (#x=812&y=340).
import { completed, jsonOf, pictureOf, unpackedJson } from "./data.js";
import { byId, el, fill } from "./dom.js";
import { showFuzz, showPeers } from "./extras.js";
import { showHead } from "./head.js";
import { currentLanguage, preferredLanguage, setLanguage, t } from "./labels.js";
import { PictureView } from "./picture.js";
import { PixelPanel } from "./pixel.js";
import { PixelTable, showHistogram } from "./table.js";

const app = { head: null, pixels: [], byPlace: new Map(), picture: null, view: null, table: null, panel: null };

/** Faces near to far where the pixel is looked at: by w in the middle of what is in it. */
function nearToFar(pixel) {
    const faces = pixel.faces.map((_, i) => i);
    if (!pixel.faces.some((f) => f.depth)) return faces;
    const [x, y] = pixel.pixel;
    const within = (v, low) => Math.min(Math.max(v, low), low + 1);
    const w = pixel.faces.map(({ ring, depth: [a, b, c] }) => {
        const n = Math.max(ring.length, 1);
        return ring.reduce((sum, p) => sum + a * within(p[0], x) + b * within(p[1], y), 0) / n + c;
    });
    return faces.sort((p, q) => w[q] - w[p]);
}

function linkOf(pixel) {
    return app.head.kind === "scene" ? `x=${pixel.pixel[0]}&y=${pixel.pixel[1]}` : `id=${encodeURIComponent(pixel.id)}`;
}

function setLink(link) {
    if (location.hash.slice(1) !== link) history.replaceState(null, "", `#${link}`);
}

/** Opens a pixel that the page knows. */
function openPixel(pixel, step = null) {
    setLink(linkOf(pixel));
    byId("pixel-panel").hidden = false;
    app.table.select(pixel);
    app.panel.show(completed(pixel), step);
    if (app.view) app.view.show(...pixel.pixel);
}

/** Opens any pixel of the picture. */
function openPlace(x, y) {
    const known = app.byPlace.get(`${x},${y}`);
    if (known) { openPixel(known); return; }
    setLink(`x=${x}&y=${y}`);
    app.table.select(null);
    app.panel.showPlain(x, y, app.picture.asked[y * app.picture.width + x] === 0);
    app.view.show(x, y);
}

function openWorst(worst) {
    if (worst.id === undefined) openPlace(...worst.pixel);
    else {
        const known = app.pixels.find((p) => p.id === worst.id);
        if (known) openPixel(known);
    }
    byId("pixel-panel").scrollIntoView({ behavior: "smooth" });
}

/** True if the address names a pixel of this page. */
function followLink() {
    const link = new URLSearchParams(location.hash.slice(1));
    const step = link.has("step") ? Number(link.get("step")) : null;
    if (link.has("id")) {
        const known = app.pixels.find((p) => p.id === link.get("id"));
        if (known) openPixel(known, step);
        return Boolean(known);
    }
    const [x, y] = [Number(link.get("x") ?? NaN), Number(link.get("y") ?? NaN)];
    const inside = app.picture && x >= 0 && y >= 0 && x < app.picture.width && y < app.picture.height;
    if (!inside || !Number.isInteger(x) || !Number.isInteger(y)) return false;
    openPlace(x, y);
    if (step !== null) app.panel.goTo(step);
    app.view.show(x, y, 24);
    return true;
}

function showTexts() {
    document.documentElement.lang = currentLanguage();
    for (const node of document.querySelectorAll("[data-text]")) node.textContent = t(node.dataset.text);
    fill(byId("language"), [["en", "English"], ["ja", "日本語"]].map(([code, name]) => el("button", { type: "button", lang: code,
        "aria-pressed": String(code === currentLanguage()), onclick: () => { setLanguage(code); showAll(); } }, name)));
    byId("language").setAttribute("aria-label", t("language"));
    for (const [id, key] of [["previous-pixel", "previous_pixel"], ["next-pixel", "next_pixel"]]) {
        byId(id).title = t(key);
        byId(id).setAttribute("aria-label", t(key));
    }
    byId("made-by").textContent = t("made_by", { version: app.head.versions.keikan });
}

function showAll() {
    showTexts();
    showHead(app.head, openWorst);
    showHistogram(app.head);
    app.view?.controls();
    app.table.show(app.head);
    if (app.panel.pixel) app.panel.refresh();
    byId("extra").hidden = !(app.head.kind === "peers" || app.head.kind === "fuzz");
    if (app.head.kind === "peers") showPeers(app.head, (name) => {
        const worst = app.pixels.find((p) => p.note === name);
        if (worst) openPixel(worst);
    });
    if (app.head.kind === "fuzz") showFuzz(app.head);
}

function neighbour(by) {
    const next = app.table.neighbour(by);
    if (next) openPixel(next);
}

function onKey(e) {
    if (e.ctrlKey || e.metaKey || e.altKey || /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName) && e.target.type !== "range"
        && e.target.type !== "checkbox") return;
    const acts = {
        j: () => neighbour(1), k: () => neighbour(-1), f: () => app.view?.flip(), m: () => app.panel.magnify(),
        ",": () => app.panel.goTo(app.panel.step - 1), ".": () => app.panel.goTo(app.panel.step + 1),
    };
    const act = acts[e.key.toLowerCase()];
    if (!act) return;
    act();
    e.preventDefault();
}

async function start() {
    setLanguage(preferredLanguage());
    app.head = jsonOf("report-head");
    if (typeof DecompressionStream === "undefined") {
        fill(byId("verdict"), t("cannot_unpack"));
        return;
    }
    [app.pixels, app.picture] = await Promise.all([unpackedJson(jsonOf("report-pixels")), pictureOf(jsonOf("report-picture"))]);
    app.pixels.forEach((pixel, index) => {
        pixel.index = index;
        pixel.order = nearToFar(pixel);
        app.byPlace.set(pixel.pixel.join(","), pixel);
    });
    byId("picture-panel").hidden = !app.picture;
    if (app.picture) app.view = new PictureView(app.picture, openPlace);
    app.table = new PixelTable(app.pixels, openPixel);
    app.panel = new PixelPanel(app.head, {});
    byId("previous-pixel").addEventListener("click", () => neighbour(-1));
    byId("next-pixel").addEventListener("click", () => neighbour(1));
    byId("pixel-panel").hidden = app.pixels.length === 0 && !app.picture;
    byId("table-panel").hidden = app.pixels.length === 0;
    document.addEventListener("keydown", onKey);
    window.addEventListener("hashchange", followLink);
    showAll();
    const first = app.pixels.length ? app.table.listed()[0] : null;
    const hash = location.hash;
    if (!followLink() && first) {
        openPixel(first);
        if (!hash) history.replaceState(null, "", location.pathname + location.search);
    }
    document.documentElement.dataset.ready = "true";
}

start();
