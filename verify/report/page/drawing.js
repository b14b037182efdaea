// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of one pixel: rings, contacts, and both again with their topology magnified.
import { svg } from "./dom.js";
import { FACE_COLOURS } from "./palette.js";
import { Spread, exactCrossing, exactPoint } from "./spread.js";

export const SIDE = 600;
const MARGIN = 26;

export function faceColour(face) {
    return face < 0 ? "var(--background-face)" : FACE_COLOURS[face % FACE_COLOURS.length];
}

/** Maps exact points and rings of the pixel [0, 1] x [0, 1] to the drawing. */
export class Plan {
    /** `points`: all that the drawing shows; `strength`: 0 true to scale, up to 1. */
    constructor(points, strength) {
        const corners = [[0, 0], [1, 1]].map(exactPoint);
        this.spread = new Spread([...corners, ...points], strength);
    }
    place(p) {
        return this.spread.place(p).map((v) => MARGIN + v * (SIDE - 2 * MARGIN));
    }
    path(ring) {
        if (ring.length === 0) return "";
        const at = this.spread.ring(ring).map((q) => q.map((v) => (MARGIN + v * (SIDE - 2 * MARGIN)).toFixed(2)).join(" "));
        return `M${at.join("L")}Z`;
    }
}

export function canvasOf(children, label) {
    return svg("svg", { viewBox: `0 0 ${SIDE} ${SIDE}`, role: "img", "aria-label": label, class: "drawing" },
        svg("defs", {},
            svg("pattern", { id: "hatch", width: 8, height: 8, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
                svg("line", { x1: 0, y1: 0, x2: 0, y2: 8, class: "hatch" }))),
        children);
}

export function frame() {
    return svg("rect", { x: MARGIN, y: MARGIN, width: SIDE - 2 * MARGIN, height: SIDE - 2 * MARGIN, class: "frame" });
}

/** A region of several rings as one path: holes stay open. */
export function region(plan, rings, attributes) {
    return svg("path", { d: rings.map((r) => plan.path(r)).join(""), "fill-rule": "evenodd", ...attributes });
}

/** A label that reads on everything. */
export function label(at, text) {
    return svg("text", { x: at[0], y: at[1], class: "face-label" }, text);
}

/** A place well within a ring: the middle of its corners in the drawing. */
export function middleOf(plan, ring) {
    const places = ring.map((p) => plan.place(p));
    return [0, 1].map((k) => places.reduce((sum, q) => sum + q[k], 0) / places.length);
}

const SHAPES = [
    (r) => svg("circle", { r }),                                                                      // edge-edge
    (r) => svg("rect", { x: -r, y: -r, width: 2 * r, height: 2 * r }),                                // subject-vertex
    (r) => svg("path", { d: `M0 ${-1.3 * r}L${1.2 * r} ${0.9 * r}L${-1.2 * r} ${0.9 * r}Z` }),        // clip-vertex
    (r) => svg("path", { d: `M0 ${-1.4 * r}L${1.4 * r} 0L0 ${1.4 * r}L${-1.4 * r} 0Z` }),             // shared-vertex
];

/** The mark of a contact class: its shape says the class, its filling the turn (open: it only touches). */
export function contactMark(at, kind, turn, state, title) {
    const shape = SHAPES[kind](7);
    shape.setAttribute("class", `contact kind-${kind} turn-${turn} ${state}`);
    return svg("g", { transform: `translate(${at[0].toFixed(2)} ${at[1].toFixed(2)})` }, svg("title", {}, title), shape);
}

/** The mark alone, for tables and legends. */
export function contactSymbol(kind, turn) {
    const shape = SHAPES[kind](6);
    shape.setAttribute("class", `contact kind-${kind} turn-${turn}`);
    return svg("svg", { viewBox: "-10 -10 20 20", width: 18, height: 18, class: "symbol", "aria-hidden": "true" }, shape);
}

/** Where a contact is, exactly: a crossing of edges is no double. */
export function exactPlace(contact, step, points) {
    const [kind, , subject, clip, point] = contact;
    if (kind !== 0) return points[point];
    const at = (ring, i) => points[ring[i % ring.length]];
    return exactCrossing(at(step.subject, subject), at(step.subject, subject + 1), at(step.clip, clip), at(step.clip, clip + 1))
        ?? points[point];
}
