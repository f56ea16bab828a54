#!/usr/bin/env python3
"""Writes the oracle's cases: generate.py FOLDER SEED. The same seed gives the same bytes; see README.md."""
import argparse
import json
import random
import sys
from pathlib import Path

from cavity_record import cavity_record
from csg_record import csg_record
from families_cavity import CAVITY
from families_csg import CSG
from families_hit import HIT
from families_hit_matrix import HIT_MATRIX
from families_hit_torus import HIT_TORUS
from families_octree import OCTREE
from families_refraction import REFRACTION
from families_triangle import TRIANGLE
from hit_record import hit_record
from octree_record import octree_record
from refraction_record import refraction_record
from triangle_record import triangle_record

TABLES = ((HIT, hit_record), (HIT_TORUS, hit_record), (HIT_MATRIX, hit_record), (CSG, csg_record),
          (REFRACTION, refraction_record), (TRIANGLE, triangle_record), (OCTREE, octree_record),
          (CAVITY, cavity_record))
ATTEMPTS = 20


def make_case(table, record, name, level, variant, seed):
    """One case; inputs that can't be decided (a direction of zero, say) are drawn again."""
    rng = random.Random(f"{name}/{seed}/{level}/{variant}")
    for _ in range(ATTEMPTS):
        try:
            case = record(table, name, float(f"1e-{level}"), seed, variant, rng)
        except (ValueError, ArithmeticError) as error:
            print("drawn again:", name, level, variant, error, file=sys.stderr)
            continue
        case["id"] = f"{name}-e{level:02d}-{variant:02d}-s{seed}"
        return case
    sys.exit(f"{name}, level {level}, variant {variant}: no case in {ATTEMPTS} attempts")


def write_family(folder, name, cases):
    """One JSON Lines file."""
    lines = (json.dumps(case, allow_nan=False, separators=(",", ":")) + "\n" for case in cases)
    (folder / f"{name}.jsonl").write_text("".join(lines))


def main():
    """Writes every family and COUNTS.tsv."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("seed", type=int)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    counts = ["family\tkind\tcases\tundecidable"]
    total = 0
    for table, record in TABLES:
        for name, family in table.items():
            cases = [make_case(table, record, name, level, variant, arguments.seed)
                     for level in family.levels for variant in range(family.repetitions)]
            write_family(arguments.folder, name, cases)
            undecidable = sum(1 for case in cases if case.get("decidable") is False)
            counts.append(f"{name}\t{cases[0]['kind']}\t{len(cases)}\t{undecidable}")
            total += len(cases)
    counts.append(f"TOTAL\t\t{total}\t")
    (arguments.folder / "COUNTS.tsv").write_text("\n".join(counts) + "\n")
    print("total", total)


if __name__ == "__main__":
    main()
