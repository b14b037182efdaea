// SPDX-License-Identifier: GPL-3.0-or-later
// The page's modules that need no browser: numbers exactly, the magnified topology, what is taken away.
//   node --test tests/report/page_modules_test.mjs
import assert from "node:assert/strict";
import { test } from "node:test";

import { differenceOf } from "../../verify/report/page/area_table.js";
import { shellWord, wktOfRing } from "../../verify/report/page/takeaway.js";
import {
    compareFractions, decimals, fractionOf, fractionOfDouble, halfFloat, hexadecimal, minus, nearestDouble, short,
} from "../../verify/report/page/numbers.js";
import { Axis, Spread, exactCrossing, exactPoint, nearMisses } from "../../verify/report/page/spread.js";

/** The finaliser of SplitMix64: numbers that are the same on every machine. */
function* numbers(seed) {
    for (let state = BigInt(seed);;) {
        state = (state + 0x9e3779b97f4a7c15n) & 0xffffffffffffffffn;
        let z = state;
        z = ((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n) & 0xffffffffffffffffn;
        z = ((z ^ (z >> 27n)) * 0x94d049bb133111ebn) & 0xffffffffffffffffn;
        yield Number((z ^ (z >> 31n)) >> 11n) * 2 ** -53;
    }
}

test("hexadecimal floats are those of C", () => {
    assert.equal(hexadecimal(0.1), "0x1.999999999999ap-4");
    assert.equal(hexadecimal(1), "0x1p+0");
    assert.equal(hexadecimal(-0.375), "-0x1.8p-2");
    assert.equal(hexadecimal(0), "0x0p+0");
    assert.equal(hexadecimal(2 ** -1074), "0x0.0000000000001p-1022");
});

test("a double and its fraction name each other", () => {
    const random = numbers(1);
    for (let i = 0; i < 2000; ++i) {
        const x = (random.next().value - 0.5) * 2 ** Math.round(random.next().value * 120 - 60);
        assert.equal(nearestDouble(fractionOfDouble(x)), x);
    }
});

test("the nearest double is the nearest, ties to even", () => {
    assert.equal(nearestDouble({ n: 1n, d: 3n }), 1 / 3);
    assert.equal(nearestDouble({ n: -2n, d: 3n }), -2 / 3);
    assert.equal(nearestDouble({ n: 2n ** 53n + 1n, d: 1n }), 2 ** 53);
    assert.equal(nearestDouble({ n: 2n ** 54n + 3n, d: 2n }), 2 ** 53 + 2);
    assert.equal(nearestDouble({ n: (2n ** 53n + 1n) * 10n ** 60n + 1n, d: 10n ** 60n }), 2 ** 53 + 2);
});

test("the difference of a double and a fraction is not rounded before it is taken", () => {
    // 0.1 is 2^-55 / 5 * 3602879701896397 * ... : it exceeds 1/10 by 1/180143985094819840.
    assert.equal(differenceOf(0.1, "1/10"), 1 / 180143985094819840);
    assert.equal(differenceOf(0.25, "1/4"), 0);
    assert.equal(differenceOf(null, "1/4"), null);
});

test("decimals are cut off, not rounded", () => {
    assert.equal(decimals({ n: 2n, d: 3n }, 5), "0.66666");
    assert.equal(decimals({ n: 1n, d: 1n }, 4), "1.000");
    assert.equal(decimals({ n: -1n, d: 8n }, 4), "−0.1250");
    assert.equal(decimals({ n: 1n, d: 10n ** 20n }, 3), "1.00e-20");
    assert.equal(decimals({ n: 0n, d: 7n }, 3), "0");
});

test("short numbers keep three digits, and what has no measure is infinite", () => {
    assert.equal(short(4.479862344131154e-16), "4.48e-16");
    assert.equal(short(0.5), "0.5");
    assert.equal(short(0), "0");
    assert.equal(short(null), "∞");
    assert.equal(short(Number.MAX_VALUE), "∞");
});

test("half floats", () => {
    assert.equal(halfFloat(0x3c00), 1);
    assert.equal(halfFloat(0xc000), -2);
    assert.equal(halfFloat(1), 2 ** -24);
    assert.equal(halfFloat(0x7c00), Infinity);
});

test("text becomes one word of a shell", () => {
    assert.equal(shellWord("a/b-1,2"), "a/b-1,2");
    assert.equal(shellWord("it's $HOME"), "'it'\\''s $HOME'");
});

test("a ring in well-known text ends where it begins", () => {
    assert.equal(wktOfRing([[0, 0], [1, 0], [0.1, 1e-20]]), "POLYGON ((0 0, 1 0, 0.1 1e-20, 0 0))");
    assert.equal(wktOfRing([]), "POLYGON EMPTY");
});

/** Points in the pixel, many of them a unit in the last place from another or with a coordinate in common. */
function crowdedPoints(random, n) {
    const points = [];
    for (let i = 0; i < n; ++i) {
        let point = [random.next().value, random.next().value];
        if (i > 0 && random.next().value < 0.7) {
            const near = points[Math.floor(random.next().value * i)];
            const ulps = () => Math.round(random.next().value * 4 - 2) * 2 ** -53;
            point = [Math.min(Math.max(near[0] + ulps(), 0), 1), Math.min(Math.max(near[1] + ulps(), 0), 1)];
        }
        points.push(point);
    }
    return points;
}

test("magnifying keeps the order along both axes: strictly, and what is equal stays equal", () => {
    const random = numbers(2);
    for (const strength of [0, 0.5, 0.9, 1])
        for (let round = 0; round < 20; ++round) {
            const points = crowdedPoints(random, 24);
            const exact = points.map(exactPoint);
            const spread = new Spread(exact, strength);
            const placed = exact.map((p) => spread.place(p));
            for (let i = 0; i < points.length; ++i)
                for (let j = 0; j < points.length; ++j)
                    for (const axis of [0, 1]) {
                        // Unmagnified, 2^-53 of a pixel may be lost in the drawing's own doubles.
                        const sign = strength === 0 ? (v) => Math.max(v, 0) : Math.sign;
                        const [before, after] = [points[i][axis] - points[j][axis], placed[i][axis] - placed[j][axis]];
                        assert.ok(strength === 0 ? Math.sign(before) * Math.sign(after) >= 0 : sign(before) === sign(after));
                    }
        }
});

test("equal distances at full strength: neighbours a unit in the last place apart are as far apart as any", () => {
    const axis = new Axis([0, 0.5, 0.5 + 2 ** -53, 1].map(fractionOfDouble), 1);
    assert.deepEqual(axis.places, [0, 1 / 3, 2 / 3, 1]);
    assert.equal(axis.smallestGap(), 2 ** -53);
});

test("where two edges cross is known exactly, and lies on the images of both", () => {
    const random = numbers(3);
    for (let round = 0; round < 60; ++round) {
        const [a, b, c, d] = crowdedPoints(random, 4).map(exactPoint);
        const crossing = exactCrossing(a, b, c, d);
        if (!crossing) continue;
        const cross = (p, q, r) => minus({ n: minus(q.x, p.x).n * minus(r.y, p.y).n, d: minus(q.x, p.x).d * minus(r.y, p.y).d },
            { n: minus(q.y, p.y).n * minus(r.x, p.x).n, d: minus(q.y, p.y).d * minus(r.x, p.x).d });
        assert.equal(cross(a, b, crossing).n, 0n);
        assert.equal(cross(c, d, crossing).n, 0n);
        const inside = (p, q) => [p.x, q.x].sort(compareFractions).every((v, i) => (i ? 1 : -1) * compareFractions(v, crossing.x) >= 0)
            && [p.y, q.y].sort(compareFractions).every((v, i) => (i ? 1 : -1) * compareFractions(v, crossing.y) >= 0);
        if (!inside(a, b) || !inside(c, d)) continue;
        const spread = new Spread([a, b, c, d, crossing], 0.9);
        const place = spread.place(crossing);
        const bends = (p, q) => spread.edge(p, q).some((at) => Math.hypot(at[0] - place[0], at[1] - place[1]) < 1e-9);
        const isEnd = (p) => compareFractions(p.x, crossing.x) === 0 && compareFractions(p.y, crossing.y) === 0;
        assert.ok(bends(a, b) || isEnd(b));
        assert.ok(bends(c, d) || isEnd(d));
    }
});

test("a point beside an edge stays on its side when magnified", () => {
    // The edge from (0, 0) to (1, 1), and points one unit in the last place to either side of its middle.
    const unit = 2 ** -53;
    const [a, b] = [[0, 0], [1, 1]].map(exactPoint);
    for (const [dx, side] of [[unit, 1], [-unit, -1]]) {
        const p = exactPoint([0.5 + dx, 0.5]);
        const misses = nearMisses([[a, b], [p]]);
        assert.equal(misses.length, 4);  // left and right of it, above and below, from a to b and back
        const spread = new Spread([a, b, p, ...misses], 1);
        const [x, y] = spread.place(p);
        const edge = [...spread.edge(a, b), spread.place(b)];
        const k = edge.findIndex((q, i) => i + 1 < edge.length && q[1] <= y && edge[i + 1][1] >= y);
        const [[x0, y0], [x1, y1]] = [edge[k], edge[k + 1]];
        const onEdge = y1 === y0 ? x0 : x0 + ((y - y0) / (y1 - y0)) * (x1 - x0);
        assert.equal(Math.sign(x - onEdge), side);
        assert.ok(Math.abs(x - onEdge) > 0.05);  // and can be seen
    }
});

test("fractions are read as the oracle writes them", () => {
    assert.deepEqual(fractionOf("-3/4"), { n: -3n, d: 4n });
    assert.deepEqual(fractionOf("0/1"), { n: 0n, d: 1n });
});
