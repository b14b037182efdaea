// SPDX-License-Identifier: GPL-3.0-or-later
// One pixel: its question, every clip step, its result; its areas; and what to take away.
import { areaTable } from "./area_table.js";
import { byId, el, fill } from "./dom.js";
import { Plan, canvasOf, contactMark, contactSymbol, exactPlace, faceColour, frame, label, middleOf, region } from "./drawing.js";
import { copyButton } from "./head.js";
import { count, t } from "./labels.js";
import { hexadecimal, nearestDouble, fractionOf, short } from "./numbers.js";
import { exactPoint, nearMisses } from "./spread.js";
import { clipCommand, commandsOf, cppTest, geojsonOfPixel, pixelCase, wktOfPixel } from "./takeaway.js";

const PLAY_MS = 900;

function same(a, b) {
    return a[0] === b[0] && a[1] === b[1] && a[2] === b[2] && a[3] === b[3];
}

/** The contacts of engine and oracle side by side: [float or null, exact or null]. */
export function pairsOf(step) {
    if (step.exact === null) return step.contacts.map((c) => [c, null]);
    const left = [...step.exact];
    const rows = [];
    for (const c of step.contacts) {
        // The same place; the published clipper may say something else of it, or list it elsewhere.
        let at = left.findIndex((e) => same(e, c));
        if (at < 0) at = left.findIndex((e) => e[2] === c[2] && e[3] === c[3]);
        rows.push([c, at < 0 ? null : left.splice(at, 1)[0]]);
    }
    rows.push(...left.map((e) => [null, e]));
    return rows.sort((p, q) => (p[0] ?? p[1])[2] - (q[0] ?? q[1])[2]);
}

/** agrees, differs; or unknown, where the oracle was not asked. A touch need not be noted by the paper's clipper. */
export function stateOf([found, exact], step, published) {
    if (step.exact === null) return "unknown";
    if (found && exact) return same(found, exact) ? "agrees" : "differs";
    return published && exact && exact[1] === 2 ? "agrees" : "differs";
}

export class PixelPanel {
    constructor(head, callbacks) {
        this.head = head;
        this.callbacks = callbacks;
        this.pixel = null;
        this.step = 0;
        this.magnified = false;
        this.strength = 0.9;
        this.claim = 0;
        this.take = "take_case";
        this.playing = null;
    }

    name(face) {
        if (face < 0) return t("background");
        const object = this.pixel.faces[face].object;
        return object ? `${t("face_n", { n: face + 1 })} · ${object}` : t("face_n", { n: face + 1 });
    }

    /** A pixel with details. */
    show(pixel, step = null) {
        this.stop();
        this.pixel = pixel;
        this.exact = pixel.points.map(exactPoint);
        this.claim = Math.min(this.claim, pixel.claims.length - 1);
        const wrong = pixel.steps.findIndex((s) => pairsOf(s).some((p) => stateOf(p, s, this.published()) === "differs"));
        this.step = step ?? (wrong >= 0 ? wrong + 1 : pixel.steps.length + 1);
        byId("pixel-empty").hidden = true;
        byId("pixel-body").hidden = false;
        this.refresh();
    }

    /** A pixel without. */
    showPlain(x, y, decided) {
        this.stop();
        this.pixel = null;
        const size = this.head.size ? ` --size ${this.head.size}` : "";
        const command = `keikan pixel ${this.head.scene} --at ${x},${y}${size} | keikan-verify areas - --report pixel-report`;
        byId("pixel-body").hidden = true;
        byId("pixel-empty").hidden = false;
        byId("pixel-title").textContent = t("pixel_at", { x, y });
        fill(byId("pixel-empty"), el("p", {}, t("no_detail")), decided ? el("p", {}, t("only_one_face")) : null,
            el("p", { class: "command" }, el("code", { tabindex: 0 }, command), copyButton(() => command)));
    }

    published() {
        return this.head.engine === "published";
    }

    goTo(step) {
        if (!this.pixel) return;
        this.step = Math.min(Math.max(step, 0), this.pixel.steps.length + 1);
        this.refresh();
    }

    magnify() {
        this.magnified = !this.magnified;
        if (this.pixel) this.refresh();
    }

    play() {
        if (this.playing) { this.stop(); return; }
        if (this.step > this.pixel.steps.length) this.step = -1;
        this.playing = setInterval(() => {
            this.goTo(this.step + 1);
            if (this.step > this.pixel.steps.length) this.stop();
        }, PLAY_MS);
        this.goTo(this.step + 1);
    }

    stop() {
        clearInterval(this.playing);
        this.playing = null;
        byId("step-play")?.setAttribute("aria-pressed", "false");
    }

    refresh() {
        const focused = document.activeElement?.id;
        const { pixel } = this;
        const at = this.head.kind === "scene" ? t("pixel_at", { x: pixel.pixel[0], y: pixel.pixel[1] }) : pixel.id;
        fill(byId("pixel-title"), at, pixel.note && !pixel.id.startsWith(pixel.note) ? el("span", { class: "dim" }, ` – ${pixel.note}`) : null);
        fill(byId("pixel-disagreements"), pixel.disagreements.map((d) => el("li", { class: "bad" }, d.text)),
            pixel.whole ? null : el("li", { class: "bad" }, t("not_whole")));
        this.showStepControls();
        this.showDrawing();
        this.showContacts();
        fill(byId("area-table"), areaTable(pixel, this.claim, (face) => this.name(face), (i) => { this.claim = i; this.refresh(); }));
        this.showTakeAway();
        if (focused) byId(focused)?.focus();
        this.callbacks.moved?.();
    }

    // Steps

    currentStep() {
        return this.step >= 1 && this.step <= this.pixel.steps.length ? this.pixel.steps[this.step - 1] : null;
    }

    describe() {
        const { pixel } = this;
        const step = this.currentStep();
        if (!step) {
            const key = this.step === 0 ? "step_question" : "step_result";
            return [el("b", {}, t(key, { n: count(pixel.faces.length) }))];
        }
        const holes = step.rest.some(([sign]) => sign !== step.sign);
        const unchanged = step.rest.length === 1 && String(step.rest[0][1]) === String(step.subject);
        const rest = step.remembered ? "step_remembered" : holes ? "step_hole" : step.rest.length === 0 ? "step_rest_none"
            : unchanged ? "step_rest_same" : step.rest.length === 1 ? "step_rest_one" : "step_rest";
        return [el("b", {}, t("step_of", { i: this.step, n: pixel.steps.length })), " ",
            t("step_clips", { clip: this.name(step.clip_face), subject: this.name(step.subject_face) }), ". ",
            t(rest, { n: step.rest.length })];
    }

    showStepControls() {
        const last = this.pixel.steps.length + 1;
        const button = (id, key, text, act, off) => el("button", { id, type: "button", title: t(key), "aria-label": t(key),
            onclick: act, disabled: off }, text);
        fill(byId("step-controls"),
            button("step-back", "step_back", "‹", () => this.goTo(this.step - 1), this.step === 0),
            el("input", { type: "range", id: "step-slider", min: 0, max: last, step: 1, value: this.step, "aria-label": t("step_slider"),
                "aria-valuetext": byId("step-text").textContent, oninput: (e) => this.goTo(Number(e.target.value)) }),
            button("step-on", "step_on", "›", () => this.goTo(this.step + 1), this.step === last),
            el("button", { id: "step-play", type: "button", "aria-pressed": String(this.playing !== null), onclick: () => this.play() },
                t("step_play")));
        fill(byId("step-text"), this.describe());
        fill(byId("magnify-controls"),
            el("label", {}, el("input", { type: "checkbox", id: "magnify", checked: this.magnified, onchange: () => this.magnify() }),
                " ", t("magnify")),
            el("input", { type: "range", id: "strength", min: 0.5, max: 1, step: 0.05, value: this.strength, hidden: !this.magnified,
                "aria-label": t("magnify"), oninput: (e) => { this.strength = Number(e.target.value); this.refresh(); } }));
        const key = this.published() ? "steps_of_published" : this.head.engine === "traversal" ? null : "steps_of_traversal";
        fill(byId("step-note"), key ? t(key) : "", this.magnified ? el("span", {}, " ", t("magnify_note")) : null);
    }

    // The drawing

    ring(indices) {
        return indices.map((i) => this.exact[i]);
    }

    showDrawing() {
        const step = this.currentStep();
        const places = step ? pairsOf(step).map(([found, exact]) => exactPlace(found ?? exact, step, this.exact)) : [];
        const used = step
            ? [...this.ring(step.subject), ...this.ring(step.clip), ...step.rest.flatMap(([, r]) => this.ring(r)),
                ...step.contacts.map((c) => this.exact[c[4]]), ...places]
            : this.step === 0 ? this.faceRings().flatMap(({ ring }) => ring) : this.pixel.visible.flatMap(([, , r]) => this.ring(r));
        if (this.magnified) used.push(...nearMisses(this.drawnRings(step)));
        const plan = new Plan(used, this.magnified ? this.strength : 0);
        const drawn = step ? this.drawStep(plan, step, places) : this.step === 0 ? this.drawQuestion(plan) : this.drawResult(plan);
        fill(byId("pixel-drawing"), canvasOf([frame(), drawn], byId("step-text").textContent));
        const gap = plan.spread.smallestGap();
        fill(byId("drawing-legend"), step ? this.stepLegend(step) : null,
            el("span", { class: "dim" }, gap < Infinity && gap < 1 ? t("smallest_gap", { gap: short(gap) }) : ""));
    }

    /** The faces as the first clip step, or the last outline, knows them: cut to the pixel. */
    faceRings() {
        const rings = new Map();
        for (const [face, , ring] of this.pixel.visible) if (face >= 0) rings.set(face, ring);
        for (const step of [...this.pixel.steps].reverse()) {
            if (step.subject_face >= 0 && step.sign > 0) rings.set(step.subject_face, step.subject);
            if (step.subject_face < 0) rings.set(step.clip_face, step.clip);
        }
        const first = new Set();
        for (const step of this.pixel.steps)
            if (step.subject_face >= 0 && !first.has(step.subject_face)) {
                first.add(step.subject_face);
                rings.set(step.subject_face, step.subject);
            }
        return [...rings].map(([face, ring]) => ({ face, ring: this.ring(ring) }));
    }

    drawnRings(step) {
        if (step) return [this.ring(step.subject), this.ring(step.clip)];
        return this.step === 0 ? this.faceRings().map(({ ring }) => ring) : this.pixel.visible.map(([, , r]) => this.ring(r));
    }

    drawQuestion(plan) {
        const order = new Map(this.pixel.order.map((face, place) => [face, place]));
        const faces = this.faceRings().sort((p, q) => order.get(q.face) - order.get(p.face));
        return [...faces.map(({ face, ring }) => region(plan, [ring], { class: "face", style: `--face: ${faceColour(face)}` })),
            ...faces.map(({ face, ring }) => label(middleOf(plan, ring), String(face + 1)))];
    }

    drawResult(plan) {
        const byFace = new Map();
        for (const [face, sign, ring] of this.pixel.visible) {
            if (!byFace.has(face)) byFace.set(face, []);
            byFace.get(face).push({ sign, ring: this.ring(ring) });
        }
        const all = [...byFace].map(([face, rings]) => ({ face, rings }));
        return [...all.map(({ face, rings }) => region(plan, rings.map((r) => r.ring),
            { class: face < 0 ? "face background" : "face", style: `--face: ${faceColour(face)}` })),
        ...all.filter(({ face }) => face >= 0).map(({ face, rings }) =>
            label(middleOf(plan, rings.find((r) => r.sign > 0)?.ring ?? rings[0].ring), String(face + 1)))];
    }

    drawStep(plan, step, places) {
        const marks = pairsOf(step).map((pair, i) => {
            const [found, exact] = pair;
            const state = stateOf(pair, step, this.published());
            const [kind, turn, subject, clip] = found ?? exact;
            const title = `${t(`kind_${kind}`)}, ${t(`turn_${turn}`)} (${t("subject")} ${subject}, ${t("clipper")} ${clip}): ${
                t(state === "differs" ? (found ? (exact ? "differs" : "is_none") : "not_found") : "same")}`;
            return contactMark(plan.place(places[i]), kind, turn, state, title);
        });
        const vertices = (ring, name) => ring.map((i) => {
            const [x, y] = plan.place(this.exact[i]);
            return region(plan, [], { d: `M${x - 2.5} ${y}h5M${x} ${y - 2.5}v5`, class: `vertex ${name}` });
        });
        return [
            region(plan, step.rest.map(([, r]) => this.ring(r)), { class: "rest" }),
            step.remembered ? region(plan, [this.ring(step.remembered)], { class: "remembered" }) : null,
            region(plan, [this.ring(step.clip)], { class: "clip" }),
            region(plan, [this.ring(step.subject)], { class: "subject" }),
            vertices(step.clip, "of-clip"), vertices(step.subject, "of-subject"),
            marks,
        ].flat(Infinity).filter(Boolean);
    }

    stepLegend(step) {
        const kinds = [...new Set(pairsOf(step).map(([c, e]) => (c ?? e)[0]))].sort();
        return [["subject", "subject"], ["clip", "clipper"], ["rest", "rest"]].map(([name, key]) =>
            el("span", { class: "legend-item" }, el("span", { class: `line ${name}` }), t(key)))
            .concat(kinds.map((k) => el("span", { class: "legend-item" }, contactSymbol(k, 0), t(`kind_${k}`))));
    }

    showContacts() {
        const step = this.currentStep();
        byId("contact-panel").hidden = !step;
        if (!step) return;
        const pairs = pairsOf(step);
        if (pairs.length === 0) { fill(byId("contact-table"), el("p", { class: "dim" }, t("contact_none"))); return; }
        const described = (c) => (c ? [contactSymbol(c[0], c[1]), ` ${t(`kind_${c[0]}`)}, ${t(`turn_${c[1]}`)}`] : null);
        const rows = pairs.map((pair) => {
            const [found, exact] = pair;
            const state = stateOf(pair, step, this.published());
            const [x, y] = this.pixel.points[(found ?? exact)[4]];
            const oracle = step.exact === null ? "?" : exact ? described(exact) : t("is_none");
            return el("tr", { class: state === "differs" ? "bad" : null, "data-state": state },
                el("td", {}, found ? described(found) : t("not_found")),
                el("td", {}, oracle),
                el("td", { class: "number" }, String((found ?? exact)[2])),
                el("td", { class: "number" }, String((found ?? exact)[3])),
                el("td", { class: "number", title: `${hexadecimal(x)}, ${hexadecimal(y)}` }, `${Number(x.toPrecision(7))}, ${Number(y.toPrecision(7))}`),
                el("td", {}, state === "agrees" ? el("span", { class: "good" }, `✓ ${t("same")}`)
                    : state === "differs" ? `✗ ${t("differs")}` : "?"));
        });
        fill(byId("contact-table"),
            step.exact === null ? el("p", { class: "dim" }, t("oracle_not_asked")) : null,
            el("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": t("contact_table") }, el("table", {},
                el("thead", {}, el("tr", {}, [t("float_says"), t("oracle_says"), t("subject"), t("clipper"), t("contact_point"), ""]
                    .map((h, i) => el("th", { scope: "col", class: i >= 2 && i <= 4 ? "number" : null }, h)))),
                el("tbody", {}, rows))));
    }

    // Taking away

    takeTexts() {
        const { pixel, head } = this;
        const step = this.currentStep();
        const texts = {
            take_case: () => pixelCase(pixel),
            take_wkt: () => wktOfPixel(pixel),
            take_geojson: () => geojsonOfPixel(pixel),
            take_cpp: () => cppTest(pixel, (text) => nearestDouble(fractionOf(text))),
            take_commands: () => commandsOf(pixel, head),
        };
        if (step) texts.take_step = () => clipCommand(step, pixel.points, head.engine);
        return texts;
    }

    showTakeAway() {
        const texts = this.takeTexts();
        if (!texts[this.take]) this.take = "take_case";
        const text = texts[this.take]();
        fill(byId("take-tabs"), Object.keys(texts).map((key) => el("button", { type: "button", role: "tab", id: key,
            "aria-selected": String(key === this.take), "aria-controls": "take-text", tabindex: key === this.take ? 0 : -1,
            onclick: () => { this.take = key; this.showTakeAway(); },
            onkeydown: (e) => this.tabKey(e, Object.keys(texts)) }, t(key))));
        byId("take-text").textContent = text;
        byId("take-text").setAttribute("aria-labelledby", this.take);
        fill(byId("take-copy"), copyButton(() => text, "copy", "copy-taken"));
    }

    tabKey(e, keys) {
        const by = { ArrowRight: 1, ArrowLeft: -1 }[e.key];
        if (!by) return;
        this.take = keys[(keys.indexOf(this.take) + by + keys.length) % keys.length];
        this.showTakeAway();
        byId(this.take).focus();
        e.preventDefault();
    }
}
