# SPDX-License-Identifier: Apache-2.0
"""scripts/check_licences finds what it is there to find: keikan-verify and the oracle, passed off as the product.

    check_licences_test.py BUILD
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "check_licences"


def main(build):
    with tempfile.TemporaryDirectory() as folder:
        planted = pathlib.Path(folder)
        shutil.copy(build / "keikan-verify", planted / "keikan")
        shutil.copy(build / "verify" / "oracle" / "libkeikan_oracle.a", planted / "libkeikan_clip.a")
        done = subprocess.run([sys.executable, str(CHECK), folder], capture_output=True, text=True)
    print(done.stdout[:2000])
    found = [line for line in done.stdout.splitlines() if line.startswith(str(planted))]
    expected = [f"{planted}/keikan: linked with libgmp", f"{planted}/keikan: uses", f"{planted}/libkeikan_clip.a: uses"]
    return 0 if done.returncode == 1 and all(any(f.startswith(e) for f in found) for e in expected) else 1


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
