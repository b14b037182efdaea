// SPDX-License-Identifier: GPL-3.0-or-later
// The picture: two layers side by side or in turn, down to single pixels with their values.
import { byId, el, fill } from "./dom.js";
import { count, t } from "./labels.js";
import { Layers, MODES, kindNames } from "./layers.js";
import { short } from "./numbers.js";
import { inkOn } from "./palette.js";

const MOST_ZOOM = 160;
const VALUES_FROM = 44;  // screen pixels a pixel: then its value is written into it
const GRID_FROM = 10;

export class PictureView {
    /** `choose(x, y)` is called when a pixel is opened. */
    constructor(picture, choose) {
        this.picture = picture;
        this.choose = choose;
        this.settings = { exposure: 0, object: 0 };
        this.layers = new Layers(picture, this.settings);
        this.modes = ["rendered", "errors"];
        this.compare = "single";
        this.split = 0.5;
        this.flipped = false;
        this.cursor = [picture.width >> 1, picture.height >> 1];
        this.bitmaps = new Map();
        this.canvas = byId("picture-canvas");
        this.zoom = 1;
        this.left = 0;
        this.top = 0;
        this.listen();
        this.ratio = 1;
        this.resize();
        new ResizeObserver(() => this.resize()).observe(this.canvas);
    }

    // The controls

    controls() {
        const choice = (which) => {
            const select = el("select", { id: `mode-${which}`, "aria-label": t("show"), onchange: (e) => {
                this.modes[which] = e.target.value;
                this.refresh();
            } }, MODES.map((mode) => el("option", { value: mode, selected: mode === this.modes[which] },
                t(`mode_${mode}`))));
            return select;
        };
        const compare = el("select", { id: "compare", onchange: (e) => {
            this.compare = e.target.value;
            this.flipped = false;
            this.refresh();
        } }, ["single", "slider", "flip"].map((c) => el("option", { value: c, selected: c === this.compare },
            t(`compare_${c}`))));
        const stops = el("output", { id: "stops" }, t("stops", { n: this.settings.exposure }));
        const exposure = el("input", { type: "range", id: "exposure", min: -6, max: 6, step: 1,
            value: this.settings.exposure, oninput: (e) => {
                this.settings.exposure = Number(e.target.value);
                stops.textContent = t("stops", { n: this.settings.exposure });
                this.bitmaps.clear();
                this.refresh();
            } });
        const object = el("select", { id: "object", onchange: (e) => {
            this.settings.object = Number(e.target.value);
            this.bitmaps.delete("coverage");
            this.refresh();
        } }, this.picture.objects.map((name, i) => el("option", { value: i, selected: i === this.settings.object }, name)));
        const button = (id, label, text, act) =>
            el("button", { id, type: "button", title: label, "aria-label": label, onclick: act }, text);
        fill(byId("picture-controls"),
            el("label", {}, t("show"), choice(0)),
            el("label", {}, compare),
            el("label", { id: "second-mode" }, t("and"), choice(1)),
            el("label", { id: "object-choice" }, t("object"), object),
            el("label", {}, t("exposure"), exposure, stops),
            el("span", { class: "buttons" },
                button("flip", t("flip_key"), t("flip_key"), () => this.flip()),
                button("zoom-out", t("zoom_out"), "−", () => this.zoomBy(1 / 2)),
                button("zoom-in", t("zoom_in"), "+", () => this.zoomBy(2)),
                button("fit", t("fit"), "⤢", () => this.fit())));
        this.canvas.setAttribute("aria-label", t("picture_help"));
        this.refresh();
    }

    refresh() {
        const uses = (mode) => this.modes[0] === mode || (this.compare !== "single" && this.modes[1] === mode);
        byId("second-mode").hidden = this.compare === "single";
        byId("object-choice").hidden = !uses("coverage");
        byId("flip").hidden = this.compare !== "flip";
        const shown = this.compare === "single" ? [this.modes[0]]
            : this.compare === "flip" ? [this.modes[this.flipped ? 1 : 0]] : this.modes;
        fill(byId("picture-legend"), [...new Set(shown)].map((mode) =>
            el("span", { class: "legend" }, el("b", {}, t(`mode_${mode}`)), this.layers.legend(mode))));
        this.draw();
        this.tellCursor();
    }

    flip() {
        if (this.compare === "single") return;
        this.compare = "flip";
        byId("compare").value = "flip";
        this.flipped = !this.flipped;
        this.refresh();
    }

    // Where things are

    resize() {
        const { clientWidth } = this.canvas;
        const ratio = window.devicePixelRatio || 1;
        const height = Math.round(clientWidth * Math.min(this.picture.height / this.picture.width, 0.8));
        this.canvas.style.height = `${height}px`;
        if (this.canvas.width === Math.round(clientWidth * ratio)) return;
        const whole = this.zoom <= this.leastZoom() || this.canvas.dataset.zoom === undefined;
        this.canvas.width = Math.round(clientWidth * ratio);
        this.canvas.height = Math.round(height * ratio);
        this.ratio = ratio;
        if (whole) { this.fit(); return; }
        this.keepInside();
        this.draw();
    }

    leastZoom() {
        return Math.min(this.canvas.width / this.picture.width, this.canvas.height / this.picture.height);
    }

    fit() {
        this.zoom = this.leastZoom();
        this.keepInside();
        this.draw();
    }

    keepInside() {
        const least = this.leastZoom();
        this.zoom = Math.min(Math.max(this.zoom, least), MOST_ZOOM * this.ratio);
        const clamp = (offset, size, room) => {
            const spare = room - size * this.zoom;
            return spare >= 0 ? spare / 2 : Math.min(0, Math.max(spare, offset));
        };
        this.left = clamp(this.left, this.picture.width, this.canvas.width);
        this.top = clamp(this.top, this.picture.height, this.canvas.height);
    }

    /** Zooms about a point of the canvas; about the cursor without one. */
    zoomBy(factor, at = null) {
        const [x, y] = at ?? [this.left + (this.cursor[0] + 0.5) * this.zoom, this.top + (this.cursor[1] + 0.5) * this.zoom];
        const old = this.zoom;
        this.zoom *= factor;
        this.zoom = Math.min(Math.max(this.zoom, this.leastZoom()), MOST_ZOOM * this.ratio);
        this.left = x - ((x - this.left) * this.zoom) / old;
        this.top = y - ((y - this.top) * this.zoom) / old;
        this.keepInside();
        this.draw();
    }

    /** The cursor goes to a pixel, which is brought into view; zoom 0 leaves the zoom as it is. */
    show(x, y, zoom = 0) {
        this.cursor = [x, y];
        if (zoom > 0) this.zoom = zoom * this.ratio;
        const at = [this.left + (x + 0.5) * this.zoom, this.top + (y + 0.5) * this.zoom];
        const outside = at[0] < 0 || at[1] < 0 || at[0] > this.canvas.width || at[1] > this.canvas.height;
        if (zoom > 0 || outside) {
            this.left = this.canvas.width / 2 - (x + 0.5) * this.zoom;
            this.top = this.canvas.height / 2 - (y + 0.5) * this.zoom;
        }
        this.keepInside();
        this.draw();
        this.tellCursor();
    }

    pixelAt(event) {
        const box = this.canvas.getBoundingClientRect();
        const at = [(event.clientX - box.left) * this.ratio, (event.clientY - box.top) * this.ratio];
        const pixel = [Math.floor((at[0] - this.left) / this.zoom), Math.floor((at[1] - this.top) / this.zoom)];
        const inside = pixel[0] >= 0 && pixel[1] >= 0 && pixel[0] < this.picture.width && pixel[1] < this.picture.height;
        return { at, pixel: inside ? pixel : null };
    }

    // What the hands do

    listen() {
        const canvas = this.canvas;
        let drag = null;
        canvas.addEventListener("pointerdown", (e) => {
            const { at } = this.pixelAt(e);
            const onSplit = this.compare === "slider" && Math.abs(at[0] - this.split * canvas.width) < 12 * this.ratio;
            drag = { from: [e.clientX, e.clientY], left: this.left, top: this.top, moved: false, onSplit };
            canvas.setPointerCapture(e.pointerId);
        });
        canvas.addEventListener("pointermove", (e) => {
            const { at, pixel } = this.pixelAt(e);
            if (drag?.onSplit) {
                this.split = Math.min(Math.max(at[0] / canvas.width, 0), 1);
                this.draw();
                return;
            }
            if (drag) {
                const way = [e.clientX - drag.from[0], e.clientY - drag.from[1]];
                drag.moved ||= Math.hypot(...way) > 4;
                if (drag.moved) {
                    this.left = drag.left + way[0] * this.ratio;
                    this.top = drag.top + way[1] * this.ratio;
                    this.keepInside();
                    this.draw();
                }
                return;
            }
            if (pixel) this.tell(...pixel);
        });
        canvas.addEventListener("pointerup", (e) => {
            const { pixel } = this.pixelAt(e);
            const click = drag && !drag.moved && !drag.onSplit;
            drag = null;
            if (click && pixel) this.choose(...pixel);
        });
        canvas.addEventListener("pointerleave", () => this.tellCursor());
        canvas.addEventListener("wheel", (e) => {
            if (!e.ctrlKey && !e.metaKey && document.activeElement !== canvas) return;  // the page scrolls
            e.preventDefault();
            this.zoomBy(2 ** (-e.deltaY / 240), this.pixelAt(e).at);
        }, { passive: false });
        canvas.addEventListener("keydown", (e) => this.key(e));
    }

    key(e) {
        const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
        if (steps) {
            const by = e.shiftKey ? 10 : 1;
            const clamp = (v, size) => Math.min(Math.max(v, 0), size - 1);
            this.show(clamp(this.cursor[0] + by * steps[0], this.picture.width),
                clamp(this.cursor[1] + by * steps[1], this.picture.height));
        } else if (e.key === "+" || e.key === "=") this.zoomBy(2);
        else if (e.key === "-") this.zoomBy(1 / 2);
        else if (e.key === "0") this.fit();
        else if (e.key === "Enter") this.choose(...this.cursor);
        else return;
        e.preventDefault();
    }

    tellCursor() {
        this.tell(...this.cursor);
    }

    /** The values of a pixel, in words. */
    tell(x, y) {
        const p = this.picture;
        const i = y * p.width + x;
        const only = p.object[i];
        const name = only === 0xffff ? t("background") : only === 0xfffe ? null : p.objects[only];
        const part = (label, value) => el("span", {}, label ? el("b", {}, label) : null, " ", value);
        fill(byId("picture-readout"),
            el("strong", {}, t("pixel_at", { x, y })),
            part(t("mode_rendered"), [p.red[i], p.green[i], p.blue[i]].map((v) => v.toFixed(4)).join(" ")),
            part(t("column_error"), short(p.errors[i])),
            part(t("mode_faces"), count(p.faces[i])),
            part("", [t("one_face"), t("exact_areas"), t("scanline")][p.flags[i]]),
            p.wrong[i] ? el("span", { class: "bad" }, t("disagrees")) : null,
            p.kinds[i] ? part(t("contacts"), kindNames(p.kinds[i]).join(", ")) : null,
            name ? part(t("object"), name) : null);
    }

    // What is seen

    bitmap(mode) {
        if (!this.bitmaps.has(mode)) {
            const { width, height } = this.picture;
            const image = new ImageData(width, height);
            for (let i = 0; i < width * height; ++i) {
                const [r, g, b] = this.layers.colourAt(mode, i);
                image.data.set([r, g, b, 255], 4 * i);
            }
            const canvas = new OffscreenCanvas(width, height);
            canvas.getContext("2d").putImageData(image, 0, 0);
            this.bitmaps.set(mode, canvas);
        }
        return this.bitmaps.get(mode);
    }

    draw() {
        if (!this.canvas.width || !this.ratio) return;
        const context = this.canvas.getContext("2d");
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.clearRect(0, 0, this.canvas.width, this.canvas.height);
        if (this.compare === "slider") {
            const x = Math.round(this.split * this.canvas.width);
            this.drawMode(context, this.modes[0], 0, x);
            this.drawMode(context, this.modes[1], x, this.canvas.width);
            context.fillStyle = "#fff";
            context.fillRect(x - this.ratio, 0, 2 * this.ratio, this.canvas.height);
            context.beginPath();
            context.arc(x, this.canvas.height / 2, 9 * this.ratio, 0, 2 * Math.PI);
            context.fill();
            context.strokeStyle = "#000";
            context.stroke();
        } else {
            this.drawMode(context, this.modes[this.compare === "flip" && this.flipped ? 1 : 0], 0, this.canvas.width);
        }
        this.drawCursor(context);
        this.canvas.dataset.zoom = String(this.zoom / this.ratio);
    }

    drawMode(context, mode, from, to) {
        context.save();
        context.beginPath();
        context.rect(from, 0, to - from, this.canvas.height);
        context.clip();
        context.imageSmoothingEnabled = this.zoom < 1;
        context.imageSmoothingQuality = "high";
        const { width, height } = this.picture;
        context.drawImage(this.bitmap(mode), this.left, this.top, width * this.zoom, height * this.zoom);
        if (this.zoom >= GRID_FROM * this.ratio) this.drawPixels(context, mode, from, to);
        context.restore();
    }

    drawPixels(context, mode, from, to) {
        const first = [Math.max(0, Math.floor((from - this.left) / this.zoom)), Math.max(0, Math.floor(-this.top / this.zoom))];
        const last = [Math.min(this.picture.width - 1, Math.floor((to - this.left) / this.zoom)),
            Math.min(this.picture.height - 1, Math.floor((this.canvas.height - this.top) / this.zoom))];
        context.strokeStyle = "rgb(128 128 128 / 0.35)";
        context.lineWidth = 1;
        context.textAlign = "center";
        context.textBaseline = "middle";
        const size = Math.min(this.zoom / 5.5, 13 * this.ratio);
        context.font = `${size}px ui-monospace, monospace`;
        for (let y = first[1]; y <= last[1]; ++y)
            for (let x = first[0]; x <= last[0]; ++x) {
                const at = [this.left + x * this.zoom, this.top + y * this.zoom];
                context.strokeRect(Math.round(at[0]) + 0.5, Math.round(at[1]) + 0.5, this.zoom, this.zoom);
                if (this.zoom < VALUES_FROM * this.ratio) continue;
                const i = y * this.picture.width + x;
                const lines = this.layers.valueAt(mode, i);
                context.fillStyle = inkOn(this.layers.colourAt(mode, i));
                lines.forEach((line, k) => context.fillText(line, at[0] + this.zoom / 2,
                    at[1] + this.zoom / 2 + (k - (lines.length - 1) / 2) * size * 1.15, this.zoom * 0.94));
            }
    }

    drawCursor(context) {
        const side = Math.max(this.zoom, 9 * this.ratio);
        const x = this.left + (this.cursor[0] + 0.5) * this.zoom - side / 2;
        const y = this.top + (this.cursor[1] + 0.5) * this.zoom - side / 2;
        context.lineWidth = 4 * this.ratio;
        context.strokeStyle = "rgb(0 0 0 / 0.75)";
        context.strokeRect(x, y, side, side);
        context.lineWidth = 2 * this.ratio;
        context.strokeStyle = "#fff";
        context.strokeRect(x, y, side, side);
    }
}
