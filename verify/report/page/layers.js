// SPDX-License-Identifier: GPL-3.0-or-later
// What the picture can show: for each mode the colour of every pixel, its value in words, and a legend.
import { coverageOf } from "./data.js";
import { el } from "./dom.js";
import { count, t } from "./labels.js";
import { short } from "./numbers.js";
import { FLAG_COLOURS, KIND_COLOURS, WRONG_COLOUR, rgbOf, srgb, viridis } from "./palette.js";

const DARK = [24, 27, 32];
const LOWEST = -18;
const HIGHEST = -14;
/** Rare kinds first: a pixel shows the rarest it has. */
const BY_RARITY = [6, 7, 4, 5, 3, 1, 2, 0];

export const MODES = ["rendered", "coverage", "errors", "kinds", "flags", "faces"];

export function kindNames(kinds) {
    const names = [];
    for (let k = 0; k < 8; ++k) if ((kinds >> k) & 1) names.push(t(`kind_${k}`));
    return names;
}

function largestOf(values) {
    let largest = 0;
    for (const v of values) if (v > largest) largest = v;
    return largest;
}

function swatch(colour, text) {
    const square = el("span", { class: "swatch" });
    square.style.background = colour;
    return el("span", { class: "legend-item" }, square, text);
}

function ramp(low, high) {
    const bar = el("span", { class: "ramp" });
    const stops = Array.from({ length: 10 }, (_, i) => `rgb(${viridis(i / 9).join(" ")})`);
    bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
    return el("span", { class: "legend-item" }, low, bar, high);
}

/** The layers of a picture; `settings` are {exposure, object}. */
export class Layers {
    constructor(picture, settings) {
        this.picture = picture;
        this.settings = settings;
        this.mostFaces = largestOf(picture.faces);
        this.coverage = null;
    }

    coverageOfObject() {
        if (this.coverage?.object !== this.settings.object)
            this.coverage = { object: this.settings.object, values: coverageOf(this.picture, this.settings.object) };
        return this.coverage.values;
    }

    /** [r, g, b] of pixel i. */
    colourAt(mode, i) {
        const p = this.picture;
        if (mode === "rendered") {
            const gain = 2 ** this.settings.exposure;
            return [srgb(gain * p.red[i]), srgb(gain * p.green[i]), srgb(gain * p.blue[i])];
        }
        if (mode === "coverage") {
            const code = srgb(Math.min(this.coverageOfObject()[i] * 2 ** this.settings.exposure, 1));
            return [code, code, code];
        }
        if (p.wrong[i] && (mode === "errors" || mode === "flags")) return rgbOf(WRONG_COLOUR);
        if (mode === "errors") {
            if (p.errors[i] === 0) return DARK;
            const decades = Math.log10(p.errors[i]) + this.settings.exposure * Math.log10(2);
            return viridis((decades - LOWEST) / (HIGHEST - LOWEST));
        }
        if (mode === "kinds") {
            const kind = BY_RARITY.find((k) => (p.kinds[i] >> k) & 1);
            return kind === undefined ? DARK : rgbOf(KIND_COLOURS[kind]);
        }
        if (mode === "flags") return rgbOf(FLAG_COLOURS[p.flags[i]]);
        return p.faces[i] === 0 ? DARK : viridis(Math.log2(1 + p.faces[i]) / Math.log2(1 + this.mostFaces));
    }

    /** Lines of text for a pixel that is magnified. */
    valueAt(mode, i) {
        const p = this.picture;
        if (mode === "rendered") return [p.red[i], p.green[i], p.blue[i]].map((v) => v.toFixed(4));
        if (mode === "coverage") return [short(this.coverageOfObject()[i])];
        if (mode === "errors") return [short(p.errors[i])];
        if (mode === "kinds") return kindNames(p.kinds[i]);
        if (mode === "flags") return [[t("one_face"), t("exact_areas"), t("scanline")][p.flags[i]]];
        return [String(p.faces[i])];
    }

    legend(mode) {
        const decades = this.settings.exposure * Math.log10(2);
        const power = (n) => `10^${(n - decades).toFixed(this.settings.exposure ? 1 : 0)}`.replace("-", "−");
        if (mode === "errors")
            return [swatch(`rgb(${DARK.join(" ")})`, t("no_error")), ramp(power(LOWEST), power(HIGHEST)),
                swatch(WRONG_COLOUR, t("disagrees"))];
        if (mode === "kinds")
            return [...BY_RARITY.map((k) => swatch(KIND_COLOURS[k], t(`kind_${k}`))),
                swatch(`rgb(${DARK.join(" ")})`, t("no_contact"))];
        if (mode === "flags")
            return [swatch(FLAG_COLOURS[0], t("one_face")), swatch(FLAG_COLOURS[1], t("exact_areas")),
                swatch(FLAG_COLOURS[2], t("scanline")), swatch(WRONG_COLOUR, t("disagrees"))];
        if (mode === "faces") return [swatch(`rgb(${DARK.join(" ")})`, "0"), ramp("1", count(this.mostFaces))];
        if (mode === "coverage") return [swatch("#000", "0"), swatch("#fff", "1")];
        return [];
    }
}
