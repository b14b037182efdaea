// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels that the page knows in detail: sorted, filtered; and the histogram of all errors.
import { byId, el, fill, svg } from "./dom.js";
import { count, t } from "./labels.js";
import { short } from "./numbers.js";
import { KIND_COLOURS } from "./palette.js";

const ROWS_AT_ONCE = 40;
const REASONS = ["disagrees", "worst", "sample"];

function contactsOf(pixel) {
    return pixel.steps.reduce((n, step) => n + step.contacts.length, 0);
}

const COLUMNS = [
    { key: "column_pixel", value: (p) => p.index, cell: (p) => p.id },
    { key: "column_error", value: (p) => p.error ?? Infinity, cell: (p) => short(p.error), number: true, falling: true },
    { key: "column_of_bound", value: (p) => (p.error ?? Infinity) / p.bound, cell: (p) => short((p.error ?? Infinity) / p.bound),
        number: true, falling: true },
    { key: "column_faces", value: (p) => p.faces.length, cell: (p) => count(p.faces.length), number: true, falling: true },
    { key: "column_contacts", value: contactsOf, cell: (p) => count(contactsOf(p)), number: true, falling: true },
    { key: "column_kinds", value: (p) => p.kinds, cell: (p) => kindDots(p.kinds), falling: true },
    { key: "column_reason", value: (p) => REASONS.indexOf(p.reasons[0]), cell: (p) => reasonsOf(p) },
];
const NOTE_COLUMN = { key: "column_note", value: (p) => p.note ?? "", cell: (p) => p.note ?? "" };

function reasonsOf(pixel) {
    return pixel.reasons.map((r) => el("span", { class: r === "disagrees" ? "chip bad" : "chip" }, t(r)));
}

function kindDots(kinds) {
    const dots = [];
    for (let k = 0; k < 8; ++k) {
        if (!((kinds >> k) & 1)) continue;
        const dot = el("span", { class: "dot", title: t(`kind_${k}`), role: "img", "aria-label": t(`kind_${k}`) });
        dot.style.background = KIND_COLOURS[k];
        dots.push(dot);
    }
    return dots;
}

export class PixelTable {
    constructor(pixels, choose) {
        this.pixels = pixels;
        this.choose = choose;
        this.columns = pixels.some((p) => p.note) ? [NOTE_COLUMN, ...COLUMNS] : COLUMNS;
        this.sortBy = this.columns.findIndex((c) => c.key === "column_error");
        this.falling = true;
        this.kinds = 0;
        this.reasons = new Set();
        this.rows = ROWS_AT_ONCE;
        this.selected = null;
    }

    /** The pixels that pass the filters, in the order of the table. */
    listed() {
        const passes = (p) => (p.kinds & this.kinds) === this.kinds &&
            (this.reasons.size === 0 || p.reasons.some((r) => this.reasons.has(r)));
        const { value } = this.columns[this.sortBy];
        const sign = this.falling ? -1 : 1;
        return this.pixels.filter(passes).sort((p, q) => {
            const [a, b] = [value(p), value(q)];
            return a < b ? -sign : a > b ? sign : p.index - q.index;
        });
    }

    /** The pixel `by` places behind the selected one. */
    neighbour(by) {
        const listed = this.listed();
        if (listed.length === 0) return null;
        const at = listed.indexOf(this.selected);
        return listed[at < 0 ? 0 : (at + by + listed.length) % listed.length];
    }

    select(pixel) {
        this.selected = pixel;
        this.showRows();
    }

    show(head) {
        fill(byId("table-note"), t("pixel_table_note", { n: count(this.pixels.length) }),
            head.left_out > 0 ? [" ", t("no_room", { n: count(head.left_out) })] : null,
            head.disagreeing_left_out > 0
                ? el("strong", { class: "bad" }, " ", t("left_out", { n: count(head.disagreeing_left_out) })) : null);
        this.showFilters();
        this.showRows();
    }

    showFilters() {
        const box = (id, pressed, number, label, toggle) => el("button", { type: "button", id, class: "chip filter",
            "aria-pressed": String(pressed), disabled: number === 0 && !pressed, onclick: () => {
                toggle();
                this.rows = ROWS_AT_ONCE;
                this.showFilters();
                this.showRows();
                byId(id).focus();
            } }, label, " ", el("span", { class: "dim" }, count(number)));
        const kinds = KIND_COLOURS.map((_, k) => {
            const number = this.pixels.filter((p) => (p.kinds >> k) & 1).length;
            return box(`filter-kind-${k}`, (this.kinds >> k) & 1 ? true : false, number,
                [kindDots(1 << k), " ", t(`kind_${k}`)], () => { this.kinds ^= 1 << k; });
        });
        const reasons = REASONS.map((r) => box(`filter-${r}`, this.reasons.has(r),
            this.pixels.filter((p) => p.reasons.includes(r)).length, t(r),
            () => { if (!this.reasons.delete(r)) this.reasons.add(r); }));
        fill(byId("table-filters"),
            el("div", { role: "group", "aria-label": t("filter_kinds") }, el("span", { class: "dim" }, t("filter_kinds")), kinds),
            el("div", { role: "group", "aria-label": t("filter_reasons") }, el("span", { class: "dim" }, t("filter_reasons")), reasons));
    }

    showRows() {
        const heads = this.columns.map((column, i) => el("th", { scope: "col", class: column.number ? "number" : null,
            "aria-sort": i === this.sortBy ? (this.falling ? "descending" : "ascending") : "none" },
        el("button", { type: "button", "data-sort": column.key, onclick: () => {
            this.falling = i === this.sortBy ? !this.falling : Boolean(column.falling);
            this.sortBy = i;
            this.showRows();
            byId("pixel-table").querySelector(`[data-sort="${column.key}"]`).focus();
        } }, t(column.key))));
        const listed = this.listed();
        const rows = listed.slice(0, this.rows).map((p) => el("tr", {
            class: p === this.selected ? "selected" : null, "data-pixel": p.id, onclick: () => this.choose(p) },
        this.columns.map((column) => {
            const cell = column.cell(p);
            const content = column.key === "column_pixel"
                ? el("button", { type: "button", class: "link", "aria-current": p === this.selected ? "true" : null }, cell) : cell;
            return el("td", { class: column.number ? "number" : null }, content);
        })));
        fill(byId("pixel-table"), el("thead", {}, el("tr", {}, heads)), el("tbody", {}, rows));
        const more = listed.length - rows.length;
        fill(byId("table-more"),
            listed.length === 0 ? el("p", { class: "dim" }, t("no_rows")) : null,
            more > 0 ? el("button", { type: "button", onclick: () => { this.rows += 200; this.showRows(); } },
                t("more_rows", { n: count(Math.min(more, 200)) })) : null);
    }
}

/** Bars on a logarithmic scale: what one pixel in a million does is seen. */
export function showHistogram(head) {
    const { none, bins, beyond } = head.errors;
    const total = none + beyond + bins.reduce((a, b) => a + b, 0);
    byId("histogram-panel").hidden = total === 0;
    if (total === 0) return;
    const powers = ["⁰", "⁻¹", "⁻²", "⁻³", "⁻⁴", "⁻⁵", "⁻⁶", "⁻⁷", "⁻⁸", "⁻⁹", "⁻¹⁰", "⁻¹¹", "⁻¹²"];
    const name = (i) => (i === bins.length ? "1" : i === bins.length - 1 ? "½" : `2${powers[bins.length - i]}`);
    const bars = [
        { n: none, label: t("histogram_none"), range: t("histogram_none") },
        ...bins.map((n, i) => ({ n, label: name(i + 1), range: i === 0 ? `≤ ${name(1)}` : `${name(i)} … ${name(i + 1)}` })),
        { n: beyond, label: t("histogram_beyond"), range: t("histogram_beyond"), bad: true },
    ];
    const [width, height, foot] = [640, 190, 26];
    const step = width / bars.length;
    const most = Math.log10(Math.max(total, 10));
    const size = (n) => (n === 0 ? 0 : ((1 + Math.log10(n)) / (1 + most)) * (height - 24));
    fill(byId("histogram"), svg("svg", { viewBox: `0 0 ${width} ${height + foot}`, role: "img", "aria-label": t("histogram") },
        svg("line", { x1: 0, x2: width, y1: height, y2: height, class: "axis" }),
        bars.map((bar, i) => svg("g", {},
            svg("title", {}, t("histogram_label", { n: count(bar.n), range: bar.range })),
            svg("rect", { x: i * step + 3, width: step - 6, y: height - size(bar.n), height: size(bar.n), rx: 2,
                class: bar.bad ? "bar bad" : i === 0 ? "bar none" : "bar" }),
            svg("text", { x: (i + 0.5) * step, y: height - size(bar.n) - 5, class: "bar-value" },
                bar.n === 0 && !bar.bad ? "" : bar.n >= 1e6 ? `${(bar.n / 1e6).toPrecision(3)}M`
                    : bar.n >= 1e4 ? `${Math.round(bar.n / 1e3)}k` : String(bar.n)),
            svg("text", { x: (i + 0.5) * step, y: height + 17, class: "bar-name" }, bar.label)))));
}
