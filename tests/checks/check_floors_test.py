# SPDX-License-Identifier: Apache-2.0
"""scripts/check_floors finds what it is there to find: planted includes, each in a small project."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK_FLOORS = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "check_floors"


class CheckFloors(unittest.TestCase):
    def verdict(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "include" / "keikan").mkdir(parents=True)
            for name, text in files.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            done = subprocess.run([sys.executable, str(CHECK_FLOORS), folder], capture_output=True, text=True)
            return done.returncode, done.stdout

    def assert_found(self, files, place):
        code, text = self.verdict(files)
        self.assertEqual(code, 1, text)
        self.assertIn(place, text)

    def test_includes_that_point_down_pass(self):
        code, text = self.verdict({
            "src/scan/a.cpp": '#include "keikan/clip/a.hpp"\n#include <vector>\n#include "b.hpp"\n',
            "src/scan/b.hpp": '#include "keikan/scan/c.hpp"\n',
            "verify/crosscheck/a.cpp": '#include "keikan/scan/c.hpp"\n#include "oracle/a.hpp"\n',
            "verify/oracle/a.hpp": '#include "keikan/model/face.hpp"\n',
        })
        self.assertEqual((code, text), (0, ""))

    def test_a_higher_floor_is_found(self):
        self.assert_found({"src/clip/a.cpp": '\n#include "keikan/scene/scene.hpp"\n'}, "src/clip/a.cpp:2")

    def test_a_neighbour_is_found(self):
        self.assert_found({"include/keikan/clip/a.hpp": "#include <keikan/image/image.hpp>\n"}, "clip/a.hpp:1")

    def test_a_product_that_includes_the_oracle_is_found(self):
        self.assert_found({"verify/oracle/a.hpp": "", "src/scan/a.cpp": '#include "../../verify/oracle/a.hpp"\n'},
                          "src/scan/a.cpp:1")

    def test_an_oracle_that_looks_at_the_clipper_is_found(self):
        self.assert_found({"verify/oracle/a.cpp": '#include "keikan/clip/visible_areas.hpp"\n'},
                          "verify/oracle/a.cpp:1")

    def test_an_oracle_that_looks_into_the_products_sources_is_found(self):
        self.assert_found({"src/clip/a.hpp": "", "verify/oracle/a.cpp": '#include "../../src/clip/a.hpp"\n'},
                          "verify/oracle/a.cpp:1")

    def test_an_oracle_that_looks_at_crosscheck_is_found(self):
        self.assert_found({"verify/crosscheck/a.hpp": "", "verify/oracle/a.cpp": '#include "crosscheck/a.hpp"\n'},
                          "verify/oracle/a.cpp:1")

    def test_a_room_without_a_floor_is_found(self):
        self.assert_found({"src/attic/a.cpp": '#include "keikan/model/face.hpp"\n'}, "src/attic/a.cpp:1")


if __name__ == "__main__":
    unittest.main()
