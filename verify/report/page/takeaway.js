// SPDX-License-Identifier: GPL-3.0-or-later
// One pixel in the words of other programs. JSON's numbers name the same doubles again.

/** As one word of a shell command. */
export function shellWord(text) {
    return /^[\w./+,:@-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

function answers(pixel) {
    return pixel.exact.areas ? { areas: pixel.exact.areas, background: pixel.exact.background } : {};
}

function depths(pixel) {
    return pixel.faces.some((f) => f.depth) ? { depth: pixel.faces.map((f) => f.depth) } : {};
}

/** A line of a file of pixel cases (docs/cases.md). */
export function pixelCase(pixel) {
    const objects = pixel.faces.some((f) => f.object) ? { objects: pixel.faces.map((f) => f.object) } : {};
    return JSON.stringify({ id: pixel.id, pixel: pixel.pixel, polygons: pixel.faces.map((f) => f.ring), ...depths(pixel),
        ...answers(pixel), ...objects });
}

export function wktOfRing(ring) {
    if (ring.length === 0) return "POLYGON EMPTY";
    return `POLYGON ((${[...ring, ring[0]].map(([x, y]) => `${x} ${y}`).join(", ")}))`;
}

export function wktOfPixel(pixel) {
    const keys = JSON.stringify({ id: pixel.id, pixel: pixel.pixel, ...depths(pixel), ...answers(pixel) });
    return `# ${keys}\nGEOMETRYCOLLECTION (${pixel.faces.map((f) => wktOfRing(f.ring)).join(", ")})`;
}

export function geojsonOfPixel(pixel) {
    const features = pixel.faces.map((f, i) => ({ type: "Feature", properties: { polygon: i, ...(f.object ? { object: f.object } : {}) },
        geometry: { type: "Polygon", coordinates: [f.ring.length ? [...f.ring, f.ring[0]] : []] } }));
    return JSON.stringify({ type: "FeatureCollection", id: pixel.id, pixel: pixel.pixel, ...depths(pixel), ...answers(pixel), features });
}

function cppText(text) {
    return JSON.stringify(text).replace(/[\u007f-\uffff]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, "0")}`);
}

/** A test case for Catch2: the exact areas, each as the double nearest to it, and the bound of the header. */
export function cppTest(pixel, exactAsDouble) {
    const { areas, background } = pixel.exact;
    const number = (x) => (Number.isInteger(x) ? `${x}.0` : String(x));
    const byDepth = pixel.faces.some((f) => f.depth);
    const lines = [
        "#include <catch2/catch.hpp>", "#include <cmath>", "#include <vector>", "",
        "#include \"keikan/clip/visible_areas.hpp\"", "",
        `TEST_CASE(${cppText(`visible_areas: pixel ${pixel.id}`)}, "[clip]") {`,
        "    using namespace keikan;",
        "    const std::vector<Ring> rings = {",
        ...pixel.faces.map((f) => `        {${f.ring.map(([x, y]) => `{${number(x)}, ${number(y)}}`).join(", ")}},`),
        "    };",
        `    const std::vector<double> exact = {${(areas ?? []).map((a) => number(exactAsDouble(a))).join(", ")}};`,
        "    std::vector<FaceView> faces;",
    ];
    if (byDepth) {
        lines.push("    const std::vector<DepthPlane> planes = {",
            ...pixel.faces.map((f) => `        {${f.depth.map(number).join(", ")}},`), "    };");
    }
    lines.push("    for (std::size_t i = 0; i < rings.size(); ++i)",
        `        faces.push_back({static_cast<FaceId>(i), rings[i], ${byDepth ? "planes[i]" : "{}"}});`,
        "    VisibleAreas visible_areas;",
        `    const PixelCoverage seen = visible_areas({${pixel.pixel.join(", ")}}, faces, Nearness::${byDepth ? "ByDepth" : "InOrder"});`,
        "    std::vector<double> areas(rings.size(), 0.0);",
        "    for (const VisiblePart& part : seen.parts) areas[part.face] = part.area;",
        `    const double bound = ${pixel.bound};  // of so many faces`,
        "    for (std::size_t i = 0; i < rings.size(); ++i) CHECK(std::abs(areas[i] - exact[i]) <= bound);",
        `    CHECK(std::abs(seen.background - ${number(background ? exactAsDouble(background) : 1)}) <= bound);`,
        "}");
    return lines.join("\n");
}

/** The commands that ask for this pixel again. */
export function commandsOf(pixel, head) {
    const lines = [];
    if (head.scene) {
        const size = head.size ? ` --size ${head.size}` : "";
        const question = `keikan pixel ${head.scene} --at ${pixel.pixel.join(",")}${size}`;
        lines.push(question, `${question} | keikan-verify areas -`, `${question} | keikan-verify areas - --report pixel-report`);
    } else {
        lines.push(`printf '%s\\n' ${shellWord(pixelCase(pixel))} | keikan-verify areas -`);
    }
    if (pixel.command) lines.push(pixel.command);
    return lines.join("\n");
}

/** The command that repeats one clip step. */
export function clipCommand(step, points, engine) {
    const wkt = (ring) => shellWord(wktOfRing(ring.map((i) => points[i])));
    return `keikan clip --subject ${wkt(step.subject)} --clip ${wkt(step.clip)}${engine === "published" ? " --engine published" : ""}`;
}
