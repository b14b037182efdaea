// SPDX-License-Identifier: GPL-3.0-or-later
// The magnified topology: the plane stretched along x and along y, each by a function that rises strictly, so that
// what lies left of, above or inside something still does. Places are fractions of whole numbers, exactly.
import { compareFractions, fractionOfDouble, minus, nearestDouble } from "./numbers.js";

/** A point of doubles with exact coordinates. */
export function exactPoint([x, y]) {
    return { x: fractionOfDouble(x), y: fractionOfDouble(y) };
}

/** Where the line a b meets the line c d, exactly; null where they are parallel. */
export function exactCrossing(a, b, c, d) {
    const u = { x: minus(b.x, a.x), y: minus(b.y, a.y) };
    const v = { x: minus(d.x, c.x), y: minus(d.y, c.y) };
    const cross = (p, q) => minus(times(p.x, q.y), times(p.y, q.x));
    const divisor = cross(u, v);
    if (divisor.n === 0n) return null;
    const along = divided(cross({ x: minus(c.x, a.x), y: minus(c.y, a.y) }, v), divisor);
    return between(a, b, along);
}

export function times(p, q) {
    return { n: p.n * q.n, d: p.d * q.d };
}

export function divided(p, q) {
    return q.n < 0n ? { n: -p.n * q.d, d: -p.d * q.n } : { n: p.n * q.d, d: p.d * q.n };
}

export function plus(p, q) {
    return { n: p.n * q.d + q.n * p.d, d: p.d * q.d };
}

function between(a, b, along) {
    return { x: plus(a.x, times(along, minus(b.x, a.x))), y: plus(a.y, times(along, minus(b.y, a.y))) };
}

/** Sorted, each once. */
function distinct(values) {
    const sorted = [...values].sort(compareFractions);
    return sorted.filter((v, i) => i === 0 || compareFractions(v, sorted[i - 1]) !== 0);
}

/**
 * A function from the numbers between the smallest and the largest of `values` to [0, 1] that rises strictly and is
 * straight between neighbours. `strength` 0 leaves distances as they are, 1 makes all neighbours equally far apart;
 * between these, a gap g takes part as g^(1 - strength).
 */
export class Axis {
    constructor(values, strength) {
        this.values = distinct(values);
        this.gaps = this.values.slice(1).map((v, i) => nearestDouble(minus(v, this.values[i])));
        const widths = this.gaps.map((gap) => gap ** (1 - strength));
        const sum = widths.reduce((total, w) => total + w, 0) || 1;
        this.places = [0];
        for (const w of widths) this.places.push(this.places.at(-1) + w / sum);
    }

    smallestGap() {
        return this.gaps.reduce((least, gap) => Math.min(least, gap), Infinity);
    }

    /** The last of the values that is not above v. */
    interval(v) {
        let low = 0;
        let high = this.values.length - 1;
        while (low < high) {
            const middle = (low + high + 1) >> 1;
            if (compareFractions(this.values[middle], v) <= 0) low = middle;
            else high = middle - 1;
        }
        return low;
    }

    place(v) {
        const i = this.interval(v);
        if (i + 1 >= this.values.length) return this.places[i];
        const part = nearestDouble(divided(minus(v, this.values[i]), minus(this.values[i + 1], this.values[i])));
        return this.places[i] + part * (this.places[i + 1] - this.places[i]);
    }
}

/** Of a pixel: an edge that passes a point at less than this is drawn apart from it. It chooses what is magnified. */
const NEAR = 2 ** -16;

/**
 * The points at which edges of the rings pass a vertex of any of them closely, left or right of it and above or below
 * it, without meeting it. If both axes know them, edge and vertex are pushed apart as two vertices are.
 */
export function nearMisses(rings) {
    const found = [];
    const vertices = rings.flat().map((p) => ({ p, x: nearestDouble(p.x), y: nearestDouble(p.y) }));
    const miss = (a, b, v, along, across) => {
        const way = nearestDouble(minus(b[along], a[along]));
        if (way === 0) return;
        const part = (v[along] - nearestDouble(a[along])) / way;
        const passes = nearestDouble(a[across]) + part * nearestDouble(minus(b[across], a[across]));
        if (part < -NEAR || part > 1 + NEAR || Math.abs(passes - v[across]) > NEAR) return;
        const exactly = divided(minus(v.p[along], a[along]), minus(b[along], a[along]));
        if (exactly.n <= 0n || exactly.n >= exactly.d) return;
        const place = between(a, b, exactly);
        if (compareFractions(place[across], v.p[across]) !== 0) found.push(place);
    };
    for (const ring of rings)
        ring.forEach((a, i) => {
            const b = ring[(i + 1) % ring.length];
            for (const v of vertices) {
                miss(a, b, v, "y", "x");
                miss(a, b, v, "x", "y");
            }
        });
    return found;
}

/** Both axes, over the given exact points. */
export class Spread {
    constructor(points, strength) {
        this.x = new Axis(points.map((p) => p.x), strength);
        this.y = new Axis(points.map((p) => p.y), strength);
    }

    smallestGap() {
        return Math.min(this.x.smallestGap(), this.y.smallestGap());
    }

    place(p) {
        return [this.x.place(p.x), this.y.place(p.y)];
    }

    /** The image of the edge a b without its end: straight between the lines on which either axis bends. */
    edge(a, b) {
        const stops = [{ n: 0n, d: 1n }];
        for (const [axis, from, to] of [[this.x, a.x, b.x], [this.y, a.y, b.y]]) {
            const way = minus(to, from);
            if (way.n === 0n) continue;
            for (const value of axis.values) {
                const along = divided(minus(value, from), way);
                if (along.n > 0n && along.n < along.d) stops.push(along);
            }
        }
        return distinct(stops).map((along) => this.place(between(a, b, along)));
    }

    ring(points) {
        return points.flatMap((p, i) => this.edge(p, points[(i + 1) % points.length]));
    }
}
