// SPDX-License-Identifier: GPL-3.0-or-later
// Colours that differ for every kind of eye: Okabe and Ito (2008), and viridis for numbers.

export const FACE_COLOURS = ["#56B4E9", "#E69F00", "#009E73", "#F0E442", "#CC79A7", "#0072B2", "#D55E00", "#999999"];

/** Of the kinds 0 ... 7. */
export const KIND_COLOURS = ["#56B4E9", "#0072B2", "#E69F00", "#F0E442", "#009E73", "#CC79A7", "#D55E00", "#B9BDC4"];

export const FLAG_COLOURS = ["#20262e", "#56B4E9", "#E69F00"];
export const WRONG_COLOUR = "#D55E00";

const VIRIDIS = [[68, 1, 84], [72, 40, 120], [62, 73, 137], [49, 104, 142], [38, 130, 142],
    [31, 158, 137], [53, 183, 121], [110, 206, 88], [181, 222, 43], [253, 231, 37]];

/** The colour at t in [0, 1], as [r, g, b]. */
export function viridis(t) {
    const at = Math.min(Math.max(t, 0), 1) * (VIRIDIS.length - 1);
    const i = Math.min(Math.floor(at), VIRIDIS.length - 2);
    return VIRIDIS[i].map((c, k) => Math.round(c + (at - i) * (VIRIDIS[i + 1][k] - c)));
}

export function rgbOf(hex) {
    return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
}

/** Linear light to an sRGB code of 8 bits. */
export function srgb(linear) {
    const x = Math.min(Math.max(linear, 0), 1);
    return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
}

/** Black or white, whatever reads better on [r, g, b]. */
export function inkOn([r, g, b]) {
    return 0.299 * r + 0.587 * g + 0.114 * b > 140 ? "#000" : "#fff";
}
