// SPDX-License-Identifier: GPL-3.0-or-later
// The areas of one pixel: as claimed, as they are, and the difference of the two, exactly.
import { el } from "./dom.js";
import { faceColour } from "./drawing.js";
import { t } from "./labels.js";
import { compareFractions, decimals, fractionOf, fractionOfDouble, hexadecimal, minus, nearestDouble, short } from "./numbers.js";
import { plus } from "./spread.js";

const READABLE = 44;

function fractionText(text) {
    if (text.length <= READABLE) return el("code", {}, text);
    const [n, d] = text.split("/");
    return el("details", {}, el("summary", {}, el("code", {}, `${n.slice(0, 6)}…/${(d ?? "1").slice(0, 6)}…`), " ",
        el("span", { class: "dim" }, t("digits", { n: text.replace(/\D/g, "").length }))), el("code", { class: "long" }, text));
}

/** The claimed number less the exact one; null where there is no number. */
export function differenceOf(claimed, exact) {
    return claimed === null ? null : nearestDouble(minus(fractionOfDouble(claimed), fractionOf(exact)));
}

function row(name, colour, claimed, exact, bound, failure) {
    const difference = exact === undefined || failure ? null : differenceOf(claimed, exact);
    const beyond = exact !== undefined && !failure && (difference === null || Math.abs(difference) > bound);
    return el("tr", { class: beyond ? "bad" : null },
        el("td", { class: "face-name" }, colour ? (() => {
            const square = el("span", { class: "swatch" });
            square.style.background = colour;
            return square;
        })() : null, name),
        el("td", { class: "number" }, failure ? "" : [claimed === null ? "∞" : String(claimed),
            claimed === null ? null : el("div", { class: "dim" }, el("code", {}, hexadecimal(claimed)))]),
        el("td", { class: "number" }, exact === undefined ? "?" : [decimals(fractionOf(exact), 18), el("div", { class: "dim" }, fractionText(exact))]),
        el("td", { class: "number" }, failure || exact === undefined ? "" : [short(difference),
            el("div", { class: beyond ? null : "dim" }, difference === null ? "" : t("of_bound", { n: short(Math.abs(difference) / bound) }))]));
}

/** The table, with a choice among those who claim something. `chosen` is called with the number of another. */
export function areaTable(pixel, which, nameOf, choose) {
    const claim = pixel.claims[which];
    const { failure } = claim;
    const exact = pixel.exact.areas ?? pixel.faces.map(() => undefined);
    const order = [...pixel.order].filter((f) => (claim.areas?.[f] ?? 0) !== 0 || (exact[f] !== undefined && fractionOf(exact[f]).n !== 0n));
    const hidden = pixel.order.length - order.length;
    const choice = el("label", {}, t("area_by"), " ", el("select", { id: "claim", onchange: (e) => choose(Number(e.target.value)) },
        pixel.claims.map((c, i) => el("option", { value: i, selected: i === which }, c.by))));
    const sum = claim.areas && !claim.areas.includes(null) && claim.background !== null
        ? [...claim.areas, claim.background].map(fractionOfDouble).reduce(plus) : null;
    const heads = [t("face"), t("claimed"), t("exact"), t("difference")];
    return [choice, failure ? el("p", { class: "bad" }, `${t("no_answer")}: ${failure}`) : null,
        el("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": t("area_table") }, el("table", { id: "areas" },
            el("thead", {}, el("tr", {}, heads.map((h, i) => el("th", { scope: "col", class: i ? "number" : null }, h)))),
            el("tbody", {},
                order.map((f) => row(nameOf(f), faceColour(f), claim.areas?.[f] ?? null, exact[f], pixel.bound, failure)),
                row(t("background"), "var(--background-face)", claim.background ?? null, pixel.exact.background, pixel.bound, failure),
                sum ? el("tr", { class: "sum" }, el("td", {}, t("total")), el("td", { class: "number" }, decimals(sum, 18)),
                    el("td", { class: "number" }, "1"),
                    el("td", { class: "number" }, compareFractions(sum, { n: 1n, d: 1n }) === 0 ? "0"
                        : short(nearestDouble(minus(sum, { n: 1n, d: 1n }))))) : null))),
        hidden > 0 ? el("p", { class: "dim" }, `${hidden} × ${t("visible_nothing")}`) : null];
}
