"""The program whittle: `python -m whittle simplify scan.ply -o small.ply --ratio 10%`."""

import os
import subprocess
import sys
from pathlib import Path


def program() -> Path:
    """Where the program is that came with the package."""
    return Path(__file__).parent / "bin" / ("whittle.exe" if os.name == "nt" else "whittle")


def main() -> int:
    command = [str(program()), *sys.argv[1:]]
    if os.name == "posix":
        os.execv(command[0], command)
    return subprocess.call(command)


if __name__ == "__main__":
    sys.exit(main())
