// SPDX-License-Identifier: GPL-3.0-or-later
// What only some pages have: the contestants of `peers`, the families of `fuzz`.
import { byId, el, fill, svg } from "./dom.js";
import { count, t } from "./labels.js";
import { short } from "./numbers.js";

const SHADES = [["1e-3", 1], ["1e-6", 0.78], ["1e-9", 0.55], ["1e-12", 0.35]];

function unanswered(peer) {
    return peer.exceptions + peer.crashes + peer.hangs;
}

function peerChart(peers, pixels) {
    const [left, width, rowHeight] = [170, 700, 30];
    const decades = Math.max(1, Math.ceil(Math.log10(Math.max(pixels, 10))));
    const at = (share) => (share <= 0 ? 0 : Math.max(2, ((Math.log10(share) + decades) / decades) * (width - left - 70)));
    const height = rowHeight * peers.length + 34;
    const ticks = Array.from({ length: decades + 1 }, (_, i) => i - decades);
    const row = (peer, i) => {
        const y = i * rowHeight + 5;
        const failed = unanswered(peer);
        const shareBy = (name) => (peer.pixels ? (peer.wrong[name] + failed) / peer.pixels : 0);
        const all = shareBy("1e-12");
        return svg("g", {}, svg("title", {}, `${peer.name}: ${count(peer.wrong["1e-12"])} + ${count(failed)} / ${count(peer.pixels)}`),
            svg("text", { x: left - 10, y: y + 15, class: "bar-label" }, peer.name),
            [...SHADES].reverse().map(([name, strength]) => svg("rect", { x: left, y, height: rowHeight - 10, rx: 2,
                width: at(shareBy(name)), class: "bar bad", "fill-opacity": strength })),
            svg("text", { x: left + at(all) + 8, y: y + 15, class: "bar-figure" },
                all === 0 ? "0" : `${short(100 * all)} %`));
    };
    return svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": t("peers_chart"), id: "peer-chart" },
        ticks.map((power) => {
            const x = left + ((power + decades) / decades) * (width - left - 70);
            return [svg("line", { x1: x, x2: x, y1: 0, y2: height - 28, class: "grid" }),
                svg("text", { x, y: height - 12, class: "bar-name" },
                    power >= -2 ? `${10 ** (power + 2)} %` : `10${[..."" + (power + 2)].map((c) => ({ "-": "⁻" })[c] ?? "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]).join("")} %`)];
        }).flat(), peers.map(row));
}

function peerTable(peers, openWorst) {
    const heads = [t("peer"), t("asked"), t("without_answer"), ...SHADES.map(([n]) => t("wrong_by", { n })), t("largest_error"), t("speed")];
    return el("table", { id: "peer-table" },
        el("thead", {}, el("tr", {}, heads.map((h, i) => el("th", { scope: "col", class: i ? "number" : null }, h)))),
        el("tbody", {}, peers.map((peer) => el("tr", {},
            el("th", { scope: "row" }, el("button", { type: "button", class: "link", onclick: () => openWorst(peer.name) }, peer.name),
                el("div", { class: "dim" }, peer.version)),
            [count(peer.pixels), count(unanswered(peer)), ...SHADES.map(([n]) => count(peer.wrong[n])), short(peer.largest_error),
                count(Math.round(peer.pixels_per_second))].map((v) => el("td", { class: "number" }, v))))));
}

export function showPeers(head, openWorst) {
    const { peers, pixels } = head.summary;
    fill(byId("extra"), el("h2", {}, t("peers_chart")), el("p", { class: "dim" }, t("peers_note")),
        el("div", { class: "scroll" }, peerChart(peers, pixels)),
        el("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": t("peers_chart") }, peerTable(peers, openWorst)));
}

export function showFuzz(head) {
    const { campaign, pixels } = head.summary;
    const { families, listed } = head.more;
    const sentence = t(campaign.findings === 0 ? "fuzz_none" : "fuzz_found", { findings: count(campaign.findings), pixels: count(pixels),
        families: families.length, engines: Object.keys(campaign.engines).join(", "), seed: campaign.seed });
    const all = head.summary.disagreement_count <= listed;
    const most = Math.max(1, ...families.map((f) => f.findings));
    fill(byId("extra"), el("h2", {}, t("fuzz_families")), el("p", { id: "fuzz-sentence" }, sentence),
        el("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": t("fuzz_families") }, el("table", { id: "family-table" },
            el("thead", {}, el("tr", {}, el("th", { scope: "col" }, t("family")), el("th", { scope: "col", class: "number" }, t("tried")),
                el("th", { scope: "col", class: "number" }, all ? t("findings") : t("findings_of_first", { n: listed })), el("th", {}))),
            el("tbody", {}, families.map((f) => {
                const bar = el("span", { class: "mini-bar" });
                bar.style.width = `${(100 * f.findings) / most}%`;
                return el("tr", { class: f.findings ? "bad" : null }, el("th", { scope: "row" }, f.name),
                    el("td", { class: "number" }, count(f.tried)), el("td", { class: "number" }, count(f.findings)),
                    el("td", { class: "mini" }, f.findings ? bar : null));
            })))));
}
