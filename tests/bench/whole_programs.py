# SPDX-License-Identifier: Apache-2.0
"""Wall time and peak memory of keikan's commands, in turns; prints a table.

    whole_programs.py KEIKAN SCENE [TURNS]
"""
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time


def measured(command):
    """(seconds, peak MiB) of one run."""
    start = time.perf_counter()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"exit code {child.returncode}: {' '.join(command)}")
    return time.perf_counter() - start, usage.ru_maxrss / 1024


def main(keikan, scene, turns=5):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        commands = {
            "render": [keikan, "render", scene, "-o", str(out / "a.png"), "--quiet"],
            "scan": [keikan, "scan", scene, "-o", str(out / "a.scan"), "--quiet"],
            "shade": [keikan, "shade", str(out / "a.scan"), scene, "-o", str(out / "b.png"), "--quiet"],
        }
        runs = {name: [] for name in commands}
        for turn in range(int(turns) + 1):
            for name, command in commands.items():
                run = measured(command)
                if turn > 0:  # the first turn fills the system's caches
                    runs[name].append(run)
        if (out / "a.png").read_bytes() != (out / "b.png").read_bytes():
            sys.exit("scan + shade and render differ")
        size = (out / "a.scan").stat().st_size / 2**20

    seconds = {name: statistics.median(s for s, _ in runs[name]) for name in runs}
    print("| command | seconds | peak MiB |\n|---|---:|---:|")
    for name in commands:
        print(f"| keikan {name} | {seconds[name]:.3f} | {max(m for _, m in runs[name]):.0f} |")
    print(f"\nshade alone is {seconds['render'] / seconds['shade']:.1f} x faster than a full render; "
          f"the scan file has {size:.1f} MiB; both pictures are the same bytes")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__.strip())
    main(*sys.argv[1:])
