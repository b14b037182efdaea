// SPDX-License-Identifier: GPL-3.0-or-later
// The head of the page: the verdict, and how it was come by.
import { byId, copyText, el, fill } from "./dom.js";
import { count, t } from "./labels.js";
import { short } from "./numbers.js";

/** A button that copies `text()`, and says so. */
export function copyButton(text, label = "copy", id = null) {
    const button = el("button", { type: "button", class: "copy", id, onclick: async () => {
        if (!(await copyText(text()))) return;
        button.textContent = t("copied");
        setTimeout(() => { button.textContent = t(label); }, 1500);
    } }, t(label));
    return button;
}

export function pixelName(worst) {
    return worst.id ?? worst.pixel.join(", ");
}

function verdictSentence(head) {
    const s = head.summary;
    const pass = s.verdict === "pass";
    if (head.kind === "peers")
        return pass ? t("verdict_peers_pass", { pixels: count(s.pixels), peers: s.peers.length }) : t("verdict_peers_fail");
    return t(pass ? "verdict_pass" : "verdict_fail", { pixels: count(s.pixels), count: count(s.disagreement_count) });
}

/** One figure; `key` names the number of summary.json that it is. */
function tile(key, label, value, note = null, bad = false) {
    return el("div", { class: bad ? "tile bad" : "tile" },
        el("dt", {}, label),
        el("dd", { "data-figure": key }, value),
        note ? el("dd", { class: "note" }, note) : null);
}

function figures(head, open) {
    const s = head.summary;
    const worst = s.worst[0];
    const where = (error) => worst && worst.error > 0 && worst.error === error
        ? el("a", { href: "#", onclick: (e) => { e.preventDefault(); open(worst); } }, t("in_pixel", { pixel: pixelName(worst) }))
        : null;
    const checked = s.classification.checked;
    const tiles = [
        tile("pixels", t("pixels"), count(s.pixels)),
        tile("polygons", t("polygons"), count(s.polygons)),
        tile("max_area_error", t("max_area_error"), short(s.max_area_error), where(s.max_area_error) ?? t("of_pixel")),
        tile("max_sum_error", t("max_sum_error"), short(s.max_sum_error), where(s.max_sum_error) ?? t("of_pixel")),
    ];
    if (head.kind !== "peers")
        tiles.push(
            tile("classification.checked", t("contacts"), count(checked), checked === 0 ? t("none_checked") : head.engine === "published" ? t("of_traversal") : null),
            tile("classification.mismatches", t("mismatches"), count(s.classification.mismatches), null,
                s.classification.mismatches > 0),
            tile("disagreement_count", t("disagreements"), count(s.disagreement_count), null, s.disagreement_count > 0));
    tiles.push(tile("seconds", t("time"), t("seconds", { s: s.seconds < 10 ? s.seconds.toFixed(1) : Math.round(s.seconds) })));
    return tiles;
}

function rungs(head) {
    const o = head.summary.oracle;
    const hiding = head.summary.pixels - o.quad;
    const rows = [["rung_certified", "oracle.certified", o.certified], ["rung_rational", "oracle.rational", o.rational],
        ["rung_cgal", "oracle.cgal", o.cgal]];
    if (head.kind === "scene") rows.unshift(["rung_hiding", null, hiding]);
    return rows.map(([key, figure, n]) =>
        el("span", { class: "fact" }, el("b", { "data-figure": figure }, count(n)), " ", t(key)));
}

export function showHead(head, open) {
    const pass = head.summary.verdict === "pass";
    document.title = `${t(pass ? "pass" : "fail")}: ${head.subject} – keikan`;
    byId("verdict").className = pass ? "verdict pass" : "verdict fail";
    fill(byId("verdict"),
        el("span", { class: "mark", "aria-hidden": "true" }, pass ? "✓" : "✗"),
        el("div", {},
            el("h1", {}, el("span", { "data-figure": "verdict", "data-value": head.summary.verdict }, t(pass ? "pass" : "fail"))),
            el("p", {}, verdictSentence(head))));
    fill(byId("subject"), el("span", { class: "kind" }, `keikan · ${t("title")}`), " ",
        el("span", { class: "name" }, `${t(head.kind)}: ${head.subject}`));
    fill(byId("figures"), figures(head, open));
    const fact = (label, value) => el("span", { class: "fact" }, el("span", { class: "dim" }, label), " ", el("b", {}, value));
    fill(byId("facts"),
        el("div", {}, el("span", { class: "dim" }, t("rungs")), " ", rungs(head)),
        el("div", {}, fact(t("seed"), head.seed), head.engine ? fact(t("engine"), head.engine) : null,
            Object.entries(head.versions).map(([name, version]) => fact(name, version))),
        el("div", { class: "command" }, el("span", { class: "dim" }, t("command")), " ", el("code", { tabindex: 0 }, head.command),
            copyButton(() => head.command)));
}
