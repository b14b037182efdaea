# SPDX-License-Identifier: GPL-3.0-or-later
"""keikan-verify peers as a user runs it: the table, the JSON, --exec with our own program and with planted bad
ones, --show, the chart, wrong usage. Argument: the build's folder."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
RIGHT = '{"areas": [0.5], "background": 0.5}'


def peers(*arguments, stdin=""):
    command = [str(BUILD / "keikan-verify"), "peers", "--quiet", *arguments]
    return subprocess.run(command, input=stdin, capture_output=True, text=True, timeout=120)


def rows(done):
    return {row["name"]: row for row in json.loads(done.stdout)["peers"]}


def halves(count):
    """Pixels whose left half is covered."""
    return "".join(json.dumps({"id": f"half/1/{i}", "polygons": [[[0, 0], [0.5, 0], [0.5, 1], [0, 1]]]}) + "\n"
                   for i in range(count))


class PeersCommand(unittest.TestCase):
    def test_everybody_is_in_one_table(self):
        with tempfile.TemporaryDirectory() as folder:
            chart, summary = pathlib.Path(folder, "chart.svg"), pathlib.Path(folder, "summary.json")
            done = peers("--count", "210", "--chart", str(chart), "--json", str(summary),
                         "--exec", f"'{BUILD}/keikan' areas -")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            lines = done.stdout.splitlines()
            names = ["splitting", "traversal", "published", "clipper", "geos", "boost-geometry", "cgal-inexact",
                     "cgal-exact", "sampling-16x16", "exec"]
            told_names = [line.split(" | ")[0].strip("| ") for line in lines[2:]]
            if "boost-geometry-1.81" in told_names:  # where its headers are (scripts/boost_1_81)
                names.insert(names.index("boost-geometry") + 1, "boost-geometry-1.81")
            self.assertEqual(told_names, names)
            told = json.loads(summary.read_text())
            self.assertEqual((told["verdict"], told["pixels"], told["oracle"]["quad"]), ("pass", 210, 210))
            self.assertLess(told["max_area_error"], 2e-15)
            by_name = {row["name"]: row for row in told["peers"]}
            self.assertEqual(list(by_name), names)
            for name in ("splitting", "traversal", "exec"):
                self.assertEqual([by_name[name][k] for k in ("pixels", "exceptions", "crashes", "hangs")], [210, 0, 0, 0])
                self.assertLess(by_name[name]["largest_error"], 2e-15)
            self.assertGreater(by_name["published"]["wrong"]["1e-3"], 0)
            self.assertGreater(by_name["sampling-16x16"]["wrong"]["1e-3"], 0)
            self.assertEqual(max(row["of_best"] for row in told["peers"]), 1)
            self.assertEqual(xml.etree.ElementTree.parse(chart).getroot().tag, "{http://www.w3.org/2000/svg}svg")

    def test_planted_bad_programs_are_rows(self):
        crash = f"while read line; do case \"$line\" in *half/1/3*) kill -SEGV $$;; esac; echo '{RIGHT}'; done"
        hang = f"while read line; do case \"$line\" in *half/1/2*) sleep 60;; esac; echo '{RIGHT}'; done"
        wrong = "while read line; do echo '{\"areas\": [0.75], \"background\": 0.25}'; done"
        garbage = "echo 'Welcome!'"
        done = peers("-", "--peer", "none", "--limit", "0.5", "--json", "-", "--exec", crash, "--exec", hang,
                     "--exec", wrong, "--exec", garbage, stdin=halves(5))
        self.assertEqual(done.returncode, 0, done.stderr)
        table = rows(done)
        columns = ("pixels", "exceptions", "crashes", "hangs", "largest_error")
        near = [[round(table[name][c], 9) for c in columns] for name in ("exec", "exec-2", "exec-3", "exec-4")]
        self.assertEqual(near, [[5, 0, 1, 0, 0], [5, 0, 0, 1, 0], [5, 0, 0, 0, 0.25], [5, 5, 0, 0, 0]])
        self.assertEqual(table["exec-3"]["wrong"], {"1e-12": 5, "1e-9": 5, "1e-6": 5, "1e-3": 5})
        self.assertEqual(table["exec-3"]["wrong_share"]["1e-3"], 1)

    def test_show_prints_a_bug_report(self):
        done = peers("--count", "100", "--show", "identical:published")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("keikan, engine published: wrong area by", done.stdout)
        self.assertIn("POLYGON ((", done.stdout)
        self.assertIn("--show identical:published", done.stdout)
        program = peers("-", "--show", "half:exec", "--exec", "echo nothing", stdin=halves(2))
        self.assertIn("no answer: wrote no JSON object: 'nothing'", program.stdout)

    def test_depth_is_asked_of_those_that_know_it(self):
        case = {"polygons": [[[0, 0], [1, 0], [1, 1]], [[0, 0], [1, 0], [1, 1], [0, 1]]], "depth": [[0, 0, 1], [0, 0, 2]]}
        table = rows(peers("-", "--peer", "splitting,geos", "--json", "-", stdin=json.dumps(case)))
        self.assertEqual((table["splitting"]["pixels"], table["geos"]["pixels"], table["geos"]["not_asked"]), (1, 0, 1))

    def test_wrong_usage_is_told_in_a_line(self):
        for arguments in (["--family", "no-such"], ["--peer", "no-such"], ["--peer", "none"], ["no-such.jsonl"],
                          ["--show", "random"], ["--show", "random:no-such"], ["--show", "random:exec"],
                          ["--exec", "no_such_program_anywhere", "--peer", "none", "--count", "1"],
                          ["x.jsonl", "--count", "3"], ["--samples", "65"], ["--limit", "0"]):
            done = peers(*arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        bad = peers("-", stdin='{"polygons": [[[0, 0], [1, 1], [1, 0], [0, 1]]]}')
        self.assertEqual(bad.returncode, 2)
        self.assertIn("standard input:1: polygons[0] is not convex", bad.stderr)


if __name__ == "__main__":
    unittest.main()
