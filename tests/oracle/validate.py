#!/usr/bin/env python3
"""Checks case files: validate.py FOLDER...  Shares no code with the generator; reads only the JSON.

Exits 1 if anything is wrong."""
import argparse
import json
import sys
from collections import Counter
from pathlib import Path

from check_csg import check_csg
from check_hit import check_hit
from check_others import check_cavity, check_octree, check_refraction, check_triangles
from check_precision import check_precision
from checks import Failures

CHECKS = {"hit": check_hit, "csg": check_csg, "refr": check_refraction, "tri": check_triangles,
          "oct": check_octree, "cavity": check_cavity}


def main():
    """Prints how many cases of each kind were checked, and what failed where."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="+", type=Path)
    log, checked = Failures(), Counter()
    for folder in parser.parse_args().folders:
        for path in sorted(folder.glob("*.jsonl")):
            for text in path.read_text().splitlines():
                case = json.loads(text)
                checked[case["kind"]] += 1
                check_precision(case, log)
                CHECKS[case["kind"]](case, log)
    print("checked", dict(checked))
    for what, ids in log.cases.items():
        print(f"{what}: {len(ids)}, such as {', '.join(ids[:6])}")
    if log.cases or not checked:
        sys.exit(1)
    print("nothing wrong")


if __name__ == "__main__":
    main()
