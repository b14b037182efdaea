// SPDX-License-Identifier: GPL-3.0-or-later
// The reports that are looked at, made by the programs that were built.
import { spawn, spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = resolve(dirname(fileURLToPath(import.meta.url)), "../..");

/** A name that would run as markup, were it taken for any. */
export const HOSTILE = "<img src=x onerror=\"document.title='taken over'\"></script><b>bold</b>";

export class Programs {
    constructor(build) {
        this.build = build;
        this.folder = join(build, "browser-tests");
        mkdirSync(this.folder, { recursive: true });
    }

    /** Runs a program; returns its exit code and output. */
    run(program, args, input = "") {
        const done = spawnSync(join(this.build, program), args, { cwd: ROOT, input, encoding: "utf8", maxBuffer: 1 << 28 });
        if (done.error) throw done.error;
        return { code: done.status, out: done.stdout, err: done.stderr };
    }

    /** The same, without waiting for it. */
    started(program, args, input = "") {
        return new Promise((resolved, rejected) => {
            const child = spawn(join(this.build, program), args, { cwd: ROOT });
            const said = { out: "", err: "" };
            child.stdout.setEncoding("utf8").on("data", (text) => { said.out += text; });
            child.stderr.setEncoding("utf8").on("data", (text) => { said.err += text; });
            child.on("error", rejected).on("close", (code) => resolved({ code, ...said }));
            child.stdin.end(input);
        });
    }

    /** A report of keikan-verify, whose exit code must be the one given. */
    async report(name, args, code, input = "") {
        const folder = join(this.folder, name);
        const done = await this.started("keikan-verify", [...args, "--quiet", "--report", relative(ROOT, folder)], input);
        if (done.code !== code) throw new Error(`${args.join(" ")}: exit code ${done.code}, not ${code}: ${done.err}`);
        return { folder, printed: JSON.parse(done.out.startsWith("{") ? done.out : "null"),
            summary: JSON.parse(readFileSync(join(folder, "summary.json"), "utf8")),
            junit: readFileSync(join(folder, "junit.xml"), "utf8") };
    }

    /** A tower of a thousand members, at a size where pages and their reading are quick; it has holes. */
    tower() {
        return this.report("tower", ["scene", "data/scenes/tower_closeup.json", "--size", "300x195"], 0);
    }

    /** The paper's clipper to the letter, where it is known to be wrong. */
    knownFailures() {
        return this.report("known-failures", ["areas", "data/degenerate/known_failures/published.jsonl", "--engine", "published"], 1);
    }

    /** Right areas, and a case that states a wrong one; its name is hostile. */
    planted() {
        const square = "[[[0, 0], [0.5, 0], [0.5, 0.5], [0, 0.5]]]";
        const lines = [`{"id": "right", "polygons": ${square}, "areas": ["1/4"], "background": "3/4"}`,
            `{"id": ${JSON.stringify(HOSTILE)}, "polygons": ${square}, "areas": ["1/3"]}`];
        return this.report("planted", ["areas", "-"], 1, lines.join("\n") + "\n");
    }

    emptyFuzz() {
        return this.report("fuzz", ["fuzz", "--count", "240"], 0);
    }

    peers() {
        return this.report("peers", ["peers", "--count", "210", "--peer", "splitting,published,sampling-16x16"], 0);
    }

    /** A small scene whose terrain has a hostile name. */
    hostileScene() {
        const file = join(this.folder, "hostile.json");
        const scene = JSON.parse(readFileSync(join(ROOT, "data/scenes/hill.json"), "utf8"));
        scene.terrain.name = HOSTILE;
        scene.terrain.grid = relative(this.folder, join(ROOT, "data/terrain/hill.png"));
        writeFileSync(file, JSON.stringify(scene));
        return this.report("hostile-scene", ["scene", relative(ROOT, file), "--size", "160x104"], 0);
    }
}
