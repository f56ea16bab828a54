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
from precision import BINARY32, BINARY64, choose
from refraction_record import refraction_record
from triangle_record import triangle_record

IN_BOTH = ((HIT, hit_record), (HIT_TORUS, hit_record), (HIT_MATRIX, hit_record), (CSG, csg_record),
           (REFRACTION, refraction_record), (TRIANGLE, triangle_record))
IN_BINARY64 = IN_BOTH + ((OCTREE, octree_record), (CAVITY, cavity_record))
ATTEMPTS = 20


def make_case(table, record, name, level, variant, seed):
    """One case; inputs that can't be decided (a direction of zero, say) are drawn again. None if none can."""
    rng = random.Random(f"{name}/{seed}/{level}/{variant}")
    for _ in range(ATTEMPTS):
        try:
            case = record(table, name, float(f"1e-{level}"), seed, variant, rng)
        except (ValueError, ArithmeticError) as error:
            print("drawn again:", name, level, variant, error, file=sys.stderr)
            continue
        case["id"] = f"{name}-e{level:02d}-{variant:02d}-s{seed}"
        return case
    return None


def make_cases(table, record, name, precision, seed):
    """The cases of one family. Those whose inputs a narrow format can't hold are left out."""
    choose(precision)
    family = table[name]
    cases = [make_case(table, record, name + precision.suffix, level, variant, seed)
             for level in family.levels if level <= precision.hardest_level
             for variant in range(family.repetitions)]
    if precision is BINARY64 and None in cases:
        sys.exit(f"{name}: a case could not be made in {ATTEMPTS} attempts")
    return [case for case in cases if case]


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
    wanted = [(table, record, name, precision)
              for precision, tables in ((BINARY64, IN_BINARY64), (BINARY32, IN_BOTH))
              for table, record in tables for name in table]
    for table, record, name, precision in wanted:
        cases = make_cases(table, record, name, precision, arguments.seed)
        if cases:
            name += precision.suffix
            write_family(arguments.folder, name, cases)
            undecidable = sum(1 for case in cases if case.get("decidable") is False)
            counts.append(f"{name}\t{cases[0]['kind']}\t{len(cases)}\t{undecidable}")
            total += len(cases)
    counts.append(f"TOTAL\t\t{total}\t")
    (arguments.folder / "COUNTS.tsv").write_text("\n".join(counts) + "\n")
    print("total", total)


if __name__ == "__main__":
    main()
