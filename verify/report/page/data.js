// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the page: JSON elements, and in them bytes that are deflated and in base64 (docs/inspector.md).
import { byId } from "./dom.js";
import { halfFloat } from "./numbers.js";

export function jsonOf(id) {
    return JSON.parse(byId(id).textContent);
}

export async function unpacked(text) {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function unpackedJson(text) {
    return JSON.parse(new TextDecoder().decode(await unpacked(text)));
}

/** Values whose bytes stand in planes, the lowest first. */
function fromPlanes(bytes, size) {
    const n = bytes.length / size;
    const result = new Uint8Array(bytes.length);
    for (let plane = 0; plane < size; ++plane)
        for (let i = 0; i < n; ++i) result[i * size + plane] = bytes[plane * n + i];
    return result.buffer;
}

/** Halves as differences to the left, row by row. */
function colours(bytes, width) {
    const bits = new Uint16Array(fromPlanes(bytes, 2));
    const table = halfFloats();
    const result = new Float32Array(bits.length);
    for (let i = 0; i < bits.length; ++i) {
        if (i % width !== 0) bits[i] += bits[i - 1];
        result[i] = table[bits[i]];
    }
    return result;
}

let halfTable = null;
function halfFloats() {
    halfTable ??= Float32Array.from({ length: 65536 }, (_, bits) => halfFloat(bits));
    return halfTable;
}

/** The pictures of numbers of a scene; null if there are none. */
export async function pictureOf(packed) {
    if (!packed) return null;
    const { width, height, objects, layers } = packed;
    const raw = Object.fromEntries(await Promise.all(
        Object.entries(layers).map(async ([name, text]) => [name, await unpacked(text)])));
    const sharePixels = new Uint32Array(fromPlanes(raw.share_pixels, 4));
    for (let i = 1; i < sharePixels.length; ++i) sharePixels[i] += sharePixels[i - 1];
    return {
        width, height, objects,
        red: colours(raw.red, width), green: colours(raw.green, width), blue: colours(raw.blue, width),
        errors: new Float32Array(fromPlanes(raw.errors, 4)),
        flags: raw.flags.map((f) => f & 127),
        wrong: raw.flags.map((f) => f >> 7),
        faces: new Uint16Array(fromPlanes(raw.faces, 2)),
        asked: new Uint16Array(fromPlanes(raw.asked, 2)),
        kinds: raw.kinds,
        object: new Uint16Array(fromPlanes(raw.object, 2)),
        sharePixels,
        shareObjects: new Uint16Array(fromPlanes(raw.share_objects, 2)),
        shares: new Float32Array(fromPlanes(raw.shares, 4)),
    };
}

/** How much of each pixel an object covers. */
export function coverageOf(picture, object) {
    const coverage = new Float32Array(picture.width * picture.height);
    for (let i = 0; i < coverage.length; ++i) coverage[i] = picture.object[i] === object ? 1 : 0;
    for (let k = 0; k < picture.shares.length; ++k)
        if (picture.shareObjects[k] === object) coverage[picture.sharePixels[k]] = picture.shares[k];
    return coverage;
}

/** A pixel's detail with rings for their numbers, and with what the page leaves out put back. */
export function completed(pixel) {
    if (pixel.completed) return pixel;
    pixel.completed = true;
    const ring = (i) => pixel.rings[i];
    pixel.visible = pixel.visible.map(([face, sign, i]) => [face, sign, ring(i)]);
    for (const step of pixel.steps) {
        step.subject = ring(step.subject);
        step.clip = ring(step.clip);
        step.rest = step.rest?.map(([sign, i]) => [sign, ring(i)]);
        if (step.remembered !== undefined) step.remembered = ring(step.remembered);
        if (step.exact === undefined) step.exact = step.contacts;
        if (step.rest === undefined) step.rest = [[step.sign, step.subject]];
    }
    return pixel;
}
